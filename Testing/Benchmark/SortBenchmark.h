#ifndef SortBenchmark_h
#define SortBenchmark_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkUnstructuredGrid;
class vtkVisibilitySort;

/// Every sort on the same mesh and eyes, through the same GetNextCells(), frames interleaved.
class SortBenchmark
{
public:
  /// The sorts that are compared; the first is what the others are measured against.
  SortBenchmark();

  /// Times `frames` eyes on the mesh, each a little further, and prints one line per sort.
  void Run(const std::string& name, vtkUnstructuredGrid* grid, int frames);

  /// A cube of cells^3 cubes in 6 tetrahedra each, points inside moved at random.
  static vtkSmartPointer<vtkUnstructuredGrid> MakeLattice(int cells);

private:
  struct Contender
  {
    std::string Name;
    std::function<vtkSmartPointer<vtkVisibilitySort>()> Make;
  };
  std::vector<Contender> Contenders;
};

#endif
