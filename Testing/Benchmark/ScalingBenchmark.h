#ifndef ScalingBenchmark_h
#define ScalingBenchmark_h

#include <string>
#include <vector>

/// How the time of a frame grows with cells, pixels and threads: Tiles with its stages beside our Raster
/// engine, VTK's projected tetrahedra and its ray casters, each with its error against the oracle.
/// Frames of all mappers, and of all sizes of image or numbers of threads, are drawn in turns, so that their ratios are
/// of the same minute; meshes of different sizes follow each other.
namespace ScalingBenchmark
{
struct Plan
{
  /// Cubes of six tetrahedra along an edge of the lattices, ascending.
  std::vector<int> Cubes;
  /// Widths and heights of images, ascending, of the lattice of CubesOfPixels.
  std::vector<int> Sizes;
  int CubesOfPixels;
  int CubesOfThreads;
  /// Of the rows for cells and threads.
  int Size;
  /// The oracle looks at every cell for every pixel: a small image of the same view, and smaller than that
  /// where it would look more than OracleLooks times.
  int ErrorSize;
  double OracleLooks;
  /// What a frame of a mapper may take, foreseen from its row before: where it takes longer the mapper is left out.
  double SecondsPerFrame;
  /// Frames that begin after these are left out.
  double SecondsPerRow;
};

/// 20,250 to 12,002,256 tetrahedra, 256 x 256 to 2048 x 2048 pixels.
Plan Full();
/// A few cells and pixels: for the test.
Plan Tiny();

/// Prints the tables, and writes scaling.csv into `folder` where it is not empty.
void Run(const Plan& plan, int frames, const std::string& folder);
}

#endif
