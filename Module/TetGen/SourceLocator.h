/**
 * Which cell of the input the middle of a tetrahedron lies in, and what data a new point takes.
 */
#ifndef SourceLocator_h
#define SourceLocator_h

#include "TetGenMesher.h"
#include "TransferredData.h"
#include "vtkSmartPointer.h"

class vtkIdTypeArray;
class vtkStaticCellLocator;
class vtkUnstructuredGrid;

class SourceLocator
{
public:
  /** `split`: tetrahedra with the array `SourceCell`; its points are the first of the meshes'. */
  explicit SourceLocator(vtkUnstructuredGrid* split);
  ~SourceLocator();

  /** Of each tetrahedron; -1 where it lies outside. */
  std::vector<vtkIdType> FindSources(const TetGenMesh& mesh) const;

  /** Those after the points of `split`. */
  std::vector<NewPoint> FindNewPoints(const TetGenMesh& mesh) const;

private:
  vtkIdType FindCell(const double x[3], double weights[4]) const;
  NewPoint FindNewPoint(const double x[3]) const;

  vtkUnstructuredGrid* Split;
  vtkIdTypeArray* Sources;
  vtkSmartPointer<vtkStaticCellLocator> Locator;
};

#endif
