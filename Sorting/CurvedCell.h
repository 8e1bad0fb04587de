/**
 * One quadratic, Lagrange or Bezier cell at a time, as VTK's own shape functions give it.
 *
 * Reference coordinates are straight: an edge of the cell's linear twin, which has the same
 * corners, is a straight line of them. They are VTK's parametric ones, but for the quadratic
 * pyramid, whose apex VTK spreads over a square. Not thread-safe: one object per thread.
 */
#ifndef CurvedCell_h
#define CurvedCell_h

#include "TetrahedralSplit.h"

#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <vector>

class CurvedCell
{
public:
  using Coordinates = std::array<double, 3>;

  /** VTK's limit for Lagrange and Bezier cells. */
  static constexpr int MaximumDegree = 10;

  /** The shape of a type's linear twin. False for types that are not curved. */
  static bool TwinOf(int type, TetrahedralSplit::Shape& twin);

  explicit CurvedCell(vtkUnstructuredGrid* grid);

  /** Whether a cell of a curved type has the points that its type and degrees ask for. */
  bool HasRightCount(vtkIdType cell, int type, vtkIdType count) const;

  /** The cell to evaluate, of a right count, with points that exist. */
  void Take(vtkIdType cell);
  /** Its points, corners of the twin first. */
  vtkIdList* GetIds() { return this->Cell->GetPointIds(); }
  /** The reference coordinates of a corner of the twin. */
  Coordinates GetCorner(int vertex);

  /** The weights of its points stay until the next call. */
  Coordinates Locate(const Coordinates& reference);
  double* GetWeights() { return this->Weights.data(); }

private:
  vtkNew<vtkUnstructuredGrid> Grid;
  vtkNew<vtkGenericCell> Cell;
  vtkIdType Taken = -1;
  std::vector<double> Weights;
};

#endif
