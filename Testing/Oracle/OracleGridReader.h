/**
 * Fills OracleCells from a vtkUnstructuredGrid: points go through the actor's matrix to world units
 * relative to the mesh's centre, scalars come from component 0 of an array, or, of two and four
 * components that depend on each other, from the last, and colours from those before it.
 *
 * Linear cells of dimension 3 are read: tetrahedra as such, all others as convex polyhedra by their
 * faces. Cells of lower dimension, non-linear cells and convex point sets, and cells marked as
 * duplicate or hidden in the ghost array are ignored. Neighbours share faces only where they share
 * point ids.
 */

#ifndef OracleGridReader_h
#define OracleGridReader_h

#include "OracleCells.h"
#include "OracleColors.h"
#include "OracleGradients.h"

#include "vtkType.h"

#include <array>

class vtkCell;
class vtkDataArray;
class vtkUnstructuredGrid;

class OracleGridReader
{
public:
  /** `dataToWorld`: 16 values row by row, affine. The arguments must outlive this object. */
  OracleGridReader(vtkUnstructuredGrid* grid, vtkDataArray* scalars, bool cellScalars,
    bool independentComponents, const std::array<double, 16>& dataToWorld);

  OracleColors GetColors() const { return this->Colors; }

  /** The world position of the centre of the mesh's bounds: the zero of the cells' coordinates. */
  OracleVector GetCenter() const;

  /** Vertices come with gradients where they are asked for; then all cells must be tetrahedra. */
  OracleCells Read(bool withGradients) const;

  /** Whether all cells that are drawn are tetrahedra. */
  bool HasTetrahedraOnly() const;

private:
  bool IsDrawn(vtkCell* cell, vtkIdType cellId) const;
  OracleGradients ReadGradients() const;
  std::vector<OracleVertex> ReadVertices(vtkCell* cell, vtkIdType cellId) const;
  OracleVector ReadColor(vtkIdType tuple) const;
  static std::vector<std::vector<int>> ReadFaces(vtkCell* cell);
  OracleVector Transform(const OracleVector& vector) const;

  vtkUnstructuredGrid* Grid;
  vtkDataArray* Scalars;
  bool CellScalars;
  OracleColors Colors;
  std::array<double, 16> Matrix;
  OracleVector DataCenter;
};

#endif
