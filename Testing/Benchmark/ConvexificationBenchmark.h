#ifndef ConvexificationBenchmark_h
#define ConvexificationBenchmark_h

#include <string>

class vtkUnstructuredGrid;

/// Imaginary cells, and what they cost the sort and the frame, against the number of cuts that are
/// compared: the table of figure 8 in Roettger et al. 2004.
namespace ConvexificationBenchmark
{
/// Cuts the mesh into tetrahedra and prints one line per number of candidate cuts, after one for
/// the mesh without imaginary cells.
void Run(const std::string& name, vtkUnstructuredGrid* mesh, int frames);
}

#endif
