#ifndef SortFuzz_h
#define SortFuzz_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkUnstructuredGrid;

/// Random small meshes with holes cut into them, and the smallest part of one that still fails.
namespace SortFuzz
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// 10 to 200 tetrahedra or hexahedra: a Delaunay mesh, or a lattice, exact or jittered, from which
/// random cells are cut out. The same for the same seed.
Grid Mesh(unsigned int seed);

/// Drops cells from `grid` as long as `fails`.
Grid Minimise(vtkUnstructuredGrid* grid, const std::function<bool(vtkUnstructuredGrid*)>& fails);

/// The mesh as arrays in C++.
std::string Print(vtkUnstructuredGrid* grid);

/// Sorts the meshes of `count` seeds from `first` on by convexified MPVO for two eyes each; prints
/// the seed and the smallest part of what fails, and returns their number.
int CountFailures(unsigned int first, unsigned int count);
}

#endif
