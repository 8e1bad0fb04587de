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

/// For a process of its own: prints how many threads took part, and the seconds of a frame.
void RunThreads(vtkUnstructuredGrid* grid, int frames, int threads);
}

#endif
