#ifndef RayCells_h
#define RayCells_h

#include "BoxTree.h"
#include "vtkType.h"

#include <array>
#include <vector>

class vtkUnstructuredGrid;

/// Cells of dimension 3 as triangles, as class RayOrder needs them.
class RayCells
{
public:
  using Point = std::array<double, 3>;

  /// Cells with a true `skipped` are left out.
  RayCells(vtkUnstructuredGrid* grid, const std::vector<bool>& skipped);

  std::vector<Point> Points;
  /// Ascending ids, so that the two cells of a triangle compute the same.
  std::vector<std::array<vtkIdType, 3>> Triangles;
  std::vector<int> Offsets;
  /// Cell by cell: its corners by ascending ids, and of each triangle their places among these.
  std::vector<Point> Corners;
  std::vector<int> CornerOffsets;
  std::vector<std::array<int, 3>> Places;
  std::vector<vtkIdType> CellIds;
  std::vector<BoxTree::Box> Boxes;
  double Diagonal = 0.0;

private:
  void ReadCells(vtkUnstructuredGrid* grid, const std::vector<bool>& skipped);
  void AddFace(const std::vector<vtkIdType>& corners);
  void AddCorners();
  void MakeBoxes();

  std::vector<vtkIdType> Merged;
};

#endif
