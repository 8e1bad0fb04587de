#ifndef FrameStages_h
#define FrameStages_h

#include <vector>

class BenchmarkScene;
class vtkPreIntegratedTetrahedraMapper;
class vtkTable;

/// What the Tiles engine says of the stages of one frame.
struct FrameStages
{
  /// The statistics' names, in the order of a frame.
  static const std::vector<const char*>& GetNames();

  double Whole = 0.0;          // seconds of the frame
  std::vector<double> Seconds; // one for each name
  double Threads = 0.0;
  double CellsInTiles = 0.0;
  double Fragments = 0.0;
  double CoverLaneUse = 0.0;
  double ShadeLaneUse = 0.0;
  double BytesOfMesh = 0.0;
  double BytesOfFrame = 0.0;
  double RepairedPixels = 0.0;

  bool IsMeasured() const { return !this->Seconds.empty(); }
  double GetRest() const;

  /// Of the frame with the median time of the frames from 1 to `frames`; none for other mappers.
  static FrameStages Measure(BenchmarkScene& scene, int frames);

private:
  static FrameStages Read(vtkTable* statistics, double whole);
};

#endif
