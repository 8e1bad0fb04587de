#ifndef BenchmarkMapper_h
#define BenchmarkMapper_h

#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <string>

class BenchmarkScene;
class vtkUnstructuredGrid;
class vtkUnstructuredGridVolumeMapper;

/// A mapper of a comparison; all draw the same: ours by both engines, and VTK's.
struct BenchmarkMapper
{
  std::string Name;
  std::string Engine;
  std::function<vtkSmartPointer<vtkUnstructuredGridVolumeMapper>()> Make;
  bool IsLit = false;
  /// The power of the number of cells that a frame's time grows by, at most.
  double Growth = 1.0;

  /// A window of its own with a new mapper.
  std::unique_ptr<BenchmarkScene> Show(vtkUnstructuredGrid* grid, int size, bool spiky) const;

  static BenchmarkMapper Tiles();
  static BenchmarkMapper LitTiles();
  static BenchmarkMapper Raster();
  static BenchmarkMapper ProjectedTetrahedra();
  /// A ray for every pixel, as ours.
  static BenchmarkMapper Bunyk();
  static BenchmarkMapper ZSweep();
};

#endif
