#ifndef ShellBenchmark_h
#define ShellBenchmark_h

#include <string>

class vtkUnstructuredGrid;

/**
 * Tables 1 and 2 of Georgii and Westermann 2006 for vtkBarycentricShellMapper: elements, memory and
 * stages with 4, 8 and 16 samples per shell; then cell projection and an opaque iso-surface, which
 * IsoBenchmark compares. Points move before every frame.
 */
class ShellBenchmark
{
public:
  /// Prints both tables' rows: medians of `frames`, 3 at most, at 128 x 128 pixels, and of one frame
  /// at 512 x 512.
  static void Run(
    const std::string& name, vtkUnstructuredGrid* tetrahedra, int samplesPerRay, int frames);
};

#endif
