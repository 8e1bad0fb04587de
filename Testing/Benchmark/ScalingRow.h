#ifndef ScalingRow_h
#define ScalingRow_h

#include "BenchmarkError.h"
#include "FrameStages.h"

#include <ostream>
#include <string>
#include <vector>

struct BenchmarkMachine;

/// One line of the benchmark's CSV: what a mapper takes for a mesh, an image and a number of threads, and
/// what is wrong in its image.
///
///     sweep            cells, pixels or threads: what the rows differ in
///     cells            tetrahedra of a jittered lattice
///     width, height    of the image, pixels
///     threads          of vtkSMPTools; VTK's projected tetrahedra and ZSweep use one
///     transfer         smooth or spiky
///     method, engine
///     frames           after the first, a new eye each
///     median_ms, first_ms, prepare_ms    prepare: what of the first frame is not done again
///     mcells_per_s, ratio_to_vtk         the ratio: VTK's projected tetrahedra's median over this one
///     timed_ms         of Tiles: the median frame of as many whose stages are timed
///     cull_ns ... rest_ns    its stages, ns per tetrahedron of the mesh, see
///                      vtkPreIntegratedTetrahedraMapper::SetReportStages; those within tiles as the mean
///                      of the threads, rest: the driver, depth, blending
///     fragments, fragments_per_s    rays in cells: of that frame, and of the median frame's time
///     cells_in_tiles   one for every tile of a cell
///     cover_lane_use   covered lanes per lane of the blocks of pixels that coverage looked at
///     shade_lane_use   pieces per lane of the vectors that were shaded
///     mesh_bytes_per_cell, frame_bytes_per_cell    the engine's memory
///     repaired_pixels
///     error_size       width and height of the image that is held against the oracle
///     rmse, p999, maximum, share_above_half_level    as in the report
///     renderer, processor, smp_backend, vtk          what the figures are of
struct ScalingRow
{
  std::string Sweep;
  long long Cells = 0;
  int Size = 0;
  int Threads = 0;
  bool IsSpiky = false;
  std::string Method;
  std::string Engine;
  double First = 0.0; // seconds, as all here
  double Prepare = 0.0;
  std::vector<double> Frames;
  double Reference = 0.0; // the median of VTK's projected tetrahedra; 0 where they are left out
  FrameStages Stages;     // of Tiles
  int ErrorSize = 0;
  BenchmarkError Error;

  double GetMedian() const;
  double GetNanosecondsPerCell(double seconds) const;

  static void WriteHeader(std::ostream& stream);
  void Write(std::ostream& stream, const BenchmarkMachine& machine) const;
  static void PrintHeader();
  void Print() const;
  static void PrintStagesHeader();
  void PrintStages() const;
};

#endif
