#ifndef ReportLevels_h
#define ReportLevels_h

#include "vtkSmartPointer.h"

#include <map>

class vtkUnstructuredGrid;

/// Levels of one mesh by the error of its field, each made once.
class ReportLevels
{
public:
  struct Level
  {
    vtkSmartPointer<vtkUnstructuredGrid> Grid;
    double Seconds = 0.0;
  };

  explicit ReportLevels(vtkUnstructuredGrid* tetrahedra)
    : Tetrahedra(tetrahedra)
  {
  }

  /// `percent`: of the scalar's range; 0 is the mesh itself.
  const Level& Get(double percent);

private:
  vtkSmartPointer<vtkUnstructuredGrid> Tetrahedra;
  std::map<double, Level> Levels;
};

#endif
