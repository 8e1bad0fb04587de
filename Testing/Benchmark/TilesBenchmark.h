#ifndef TilesBenchmark_h
#define TilesBenchmark_h

#include <string>

class vtkUnstructuredGrid;

/// How the Tiles engine's frame grows with cells, pixels and threads, where its time goes, and VTK's
/// ray casters beside it.
namespace TilesBenchmark
{
/// Every table; `grid` with `name` is shown beside the lattices.
void Run(const std::string& name, vtkUnstructuredGrid* grid, int frames);
}

#endif
