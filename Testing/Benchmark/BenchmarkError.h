#ifndef BenchmarkError_h
#define BenchmarkError_h

class vtkCellProjectionOracle;
class vtkUnstructuredGrid;
struct BenchmarkMapper;

/// Of a small image of the first view, over the pixels that it or the oracle covers; see
/// vtkCellProjectionOracle::Compare. Of VTK's mappers the 8 bits of the window count, without alpha.
struct BenchmarkError
{
  double RootMeanSquare = 0.0;
  double Percentile = 0.0;
  double Maximum = 0.0;
  double Share = 0.0;

  /// `size`: of the image. `oracle` draws it where it has none yet: one for each mesh, function and light.
  static BenchmarkError Measure(const BenchmarkMapper& mapper, vtkUnstructuredGrid* grid, bool spiky,
    int size, vtkCellProjectionOracle* oracle);
};

#endif
