#ifndef TilesBenchmark_h
#define TilesBenchmark_h

#include <string>

class vtkUnstructuredGrid;

/// Where the time of a frame by Tiles goes, how it grows with cells, pixels and threads, and VTK's
/// ray casters beside it.
namespace TilesBenchmark
{
/// All tables; `grid` with `name` stands beside the lattices.
void Run(const std::string& name, vtkUnstructuredGrid* grid, int frames);
}

#endif
