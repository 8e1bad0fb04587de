#ifndef HangingMeshes_h
#define HangingMeshes_h

#include "vtkSmartPointer.h"

#include <array>
#include <functional>

class vtkUnstructuredGrid;

/// Polyhedra with nodes in the middle of straight edges, in double precision; neighbours have their
/// common faces with all of these nodes.
namespace HangingMeshes
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;
/// Whether a cube of some middle and size is cut into eight.
using IsFine = std::function<bool(const std::array<double, 3>& middle, int size)>;

/// A cube of `size`, a power of two, from the origin on; a large leaf has the faces of the small
/// ones beside it.
Grid MakeOctree(int size, const IsFine& isFine);
/// The octree of Examples/12_polyhedral_mesh.py, of size 32.
Grid MakeRings();
/// Eight unit cubes, each edge with `hanging` nodes: with two or more no fan of a face will do.
Grid MakeBoxes(int hanging);
}

#endif
