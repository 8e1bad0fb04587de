#ifndef CellFuzz_h
#define CellFuzz_h

#include "vtkSmartPointer.h"

#include <string>

class vtkUnstructuredGrid;

/// Random cells of every type, spoilt on purpose, and whether vtkConvexCells accounts for each.
namespace CellFuzz
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// One cell of each type and one polyhedron, each with points of its own and a scalar "scalar":
/// repeated and coincident points, flat, thin, inverted, tangled and self-touching cells, points on
/// a coarse lattice, huge and tiny ones, NaN, ids out of range, wrong counts, faces that are
/// missing, doubled or turned. The same for the same seed.
Grid Mesh(unsigned int seed);

/// What is wrong with the account of a cell, as convex cells and as tetrahedra: a cell that is in
/// no row of the report, a piece that is turned, a volume that is not the cell's. Empty where all
/// is right.
std::string FindFault(vtkUnstructuredGrid* grid);

/// The cell alone, and the mesh as arrays in C++.
Grid Single(vtkUnstructuredGrid* grid, vtkIdType cell);
std::string Print(vtkUnstructuredGrid* grid);

/// Runs the meshes of `count` seeds from `first` on; prints the seed and the cells of what fails,
/// and returns their number.
int CountFailures(unsigned int first, unsigned int count);
}

#endif
