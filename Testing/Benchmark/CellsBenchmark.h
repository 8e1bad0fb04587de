#ifndef CellsBenchmark_h
#define CellsBenchmark_h

#include <string>

class vtkUnstructuredGrid;

/// What vtkConvexCells takes for a mesh, as convex cells and as conforming tetrahedra.
namespace CellsBenchmark
{
/// Lattices of `cubes` along each edge: of hexahedra, and of five kinds of cells in turn.
void Run(int cubes, int frames);
}

#endif
