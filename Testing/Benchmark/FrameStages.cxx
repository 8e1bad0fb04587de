#include "FrameStages.h"

#include "BenchmarkScene.h"
#include "TileStages.h"

#include "vtkPreIntegratedTetrahedraMapper.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <numeric>

//------------------------------------------------------------------------------
const std::vector<const char*>& FrameStages::GetNames()
{
  static const std::vector<const char*> names = []
  {
    std::vector<const char*> all;
    for (int stage = 0; stage < TileStages::Other; ++stage)
    {
      all.push_back(TileStages::GetName(stage));
    }
    return all;
  }();
  return names;
}

//------------------------------------------------------------------------------
double FrameStages::GetRest() const
{
  return this->Whole - std::accumulate(this->Seconds.begin(), this->Seconds.end(), 0.0);
}

//------------------------------------------------------------------------------
FrameStages FrameStages::Read(vtkTable* statistics, double whole)
{
  const auto value = [statistics](const std::string& name)
  { return statistics->GetValueByName(0, name.c_str()).ToDouble(); };
  FrameStages stages;
  stages.Whole = whole;
  for (const char* name : FrameStages::GetNames())
  {
    stages.Seconds.push_back(value(std::string("Seconds") + name));
  }
  stages.Threads = value("Threads");
  stages.CellsInTiles = value("CellsInTiles");
  stages.Fragments = value("Fragments");
  stages.CoverLaneUse = value("LanesCovered") / std::max(1.0, value("LanesOfBlocks"));
  stages.ShadeLaneUse = value("Pieces") / std::max(1.0, value("LanesShaded"));
  stages.BytesOfMesh = value("BytesOfMesh");
  stages.BytesOfFrame = value("BytesOfFrame");
  stages.RepairedPixels = value("RepairedPixels");
  return stages;
}

//------------------------------------------------------------------------------
FrameStages FrameStages::Measure(BenchmarkScene& scene, int frames)
{
  auto* mapper = vtkPreIntegratedTetrahedraMapper::SafeDownCast(scene.Volume->GetMapper());
  if (!mapper || mapper->GetEngine() != vtkConvexCellMapper::TILES)
  {
    return {};
  }
  // From another eye, so that nothing stands from the frame before the first.
  scene.TimeFrame(0);
  mapper->ReportStagesOn();
  std::vector<FrameStages> timed;
  for (int frame = 1; frame <= frames; ++frame)
  {
    const double whole = scene.TimeFrame(frame);
    timed.push_back(FrameStages::Read(mapper->GetLastStatistics(), whole));
  }
  mapper->ReportStagesOff();
  std::sort(timed.begin(), timed.end(),
    [](const FrameStages& a, const FrameStages& b) { return a.Whole < b.Whole; });
  return timed[timed.size() / 2];
}
