#ifndef SimplificationBenchmark_h
#define SimplificationBenchmark_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class BenchmarkScene;
class vtkImageData;
class vtkUnstructuredGrid;

/**
 * Table 4 of Cignoni et al. 1995: levels of a mesh by the error of its field, what they cost, how
 * much faster their frames are and how far the images are off the original's. As CSV.
 */
class SimplificationBenchmark
{
public:
  SimplificationBenchmark(const std::string& name, vtkUnstructuredGrid* tetrahedra);

  /// `bounds`: of the field error; medians of `frames`.
  void Run(const std::vector<double>& bounds, int frames);

  static void PrintHeader();

private:
  struct Level
  {
    double Bound = 0.0;
    double Error = 0.0;
    vtkIdType Cells = 0;
    double Seconds = 0.0;
    double Frame = 0.0;
    double ImageError = 0.0;
  };

  Level Measure(vtkUnstructuredGrid* grid, int frames, BenchmarkScene* original);
  void Print(const Level& level, const Level& original) const;

  std::string Name;
  vtkSmartPointer<vtkUnstructuredGrid> Tetrahedra;
  vtkSmartPointer<vtkImageData> Image;
};

#endif
