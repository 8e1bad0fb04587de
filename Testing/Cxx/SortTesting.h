#ifndef SortTesting_h
#define SortTesting_h

#include "vtkType.h"

#include <string>
#include <vector>

class vtkCamera;
class vtkUnstructuredGrid;
class vtkVisibilitySort;

/// What tests of sorts share.
namespace SortTesting
{
struct Eye
{
  std::string Name;
  /// A point, or with Position[3] = 0 a direction towards the eye.
  double Position[4];
};

/// Outside in several directions, along the axes and diagonals exactly, from within, on the plane
/// of a face, in a corner of a cell; perspective and parallel.
std::vector<Eye> Eyes(vtkUnstructuredGrid* grid);
/// Only some from outside and one within.
std::vector<Eye> FewEyes(vtkUnstructuredGrid* grid);

/// Far up the third axis through the middle.
Eye EyeUp(vtkUnstructuredGrid* grid, bool parallel);

/// `eye` as the sort will see it: what a camera makes of a direction is rounded.
void SetCamera(vtkCamera* camera, vtkUnstructuredGrid* grid, Eye& eye);

/// All that `sort` returns, back to front.
std::vector<vtkIdType> OrderOf(vtkVisibilitySort* sort, vtkUnstructuredGrid* grid, Eye& eye);

bool IsPermutation(const std::vector<vtkIdType>& order, vtkIdType count);
}

#endif
