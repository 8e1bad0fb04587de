#ifndef ShellBenchmark_h
#define ShellBenchmark_h

#include <string>

class vtkUnstructuredGrid;

/**
 * Tables 1 and 2 of Georgii and Westermann 2006 for vtkBarycentricShellMapper: elements, memory and
 * stages with 4, 8 and 16 samples per shell; then cell projection and an iso-surface, whose peer is
 * vtkContourFilter and drawing its triangles. Points move before every frame.
 */
class ShellBenchmark
{
public:
  /// Prints both tables' rows, medians of `frames`, 3 at most, 128 x 128 pixels.
  static void Run(
    const std::string& name, vtkUnstructuredGrid* tetrahedra, int samplesPerRay, int frames);
};

#endif
