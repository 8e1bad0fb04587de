#ifndef IsoBenchmark_h
#define IsoBenchmark_h

#include <string>

class vtkUnstructuredGrid;

/// Iso-surfaces of vtkBarycentricShellMapper beside VTK's contour filters and their drawing, of a
/// mesh whose points move in every frame: frames interleaved, all stages counted.
namespace IsoBenchmark
{
void Run(const std::string& name, vtkUnstructuredGrid* tetrahedra, int frames);
}

#endif
