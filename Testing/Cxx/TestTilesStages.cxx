// What the Tiles engine says of its stages: times that add up to no more than the frame, as many fragments
// as the oracle finds pieces of rays in cells, vectors no fuller than full; the same image as without, and
// nothing said then.

#include "TestMeshes.h"
#include "TilesScene.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

namespace
{
// Rays that graze an edge may be in a cell for the one and not for the other.
constexpr double Grazing = 1e-3;

void CheckTimes(TestChecks& checks, const TilesScene& scene)
{
  const TileStages& stages = scene.Engine.GetStages();
  double sum = 0.0;
  for (int stage = 0; stage < TileStages::Count; ++stage)
  {
    std::cout << TileStages::GetName(stage) << " " << 1e6 * stages.Seconds[stage] << " us\n";
    const bool mayBeNone = stage == TileStages::Repair || stage >= TileStages::Wait;
    CHECK(stages.Seconds[stage] > 0.0 || (mayBeNone && stages.Seconds[stage] == 0.0));
    sum += stages.Seconds[stage];
  }
  CHECK_AT_MOST(sum, scene.SecondsOfEngine);
}

// The account is complete: with what waits and what is of no stage it is nearly all that the engine takes, whatever else
// the processors do; of one frame of ten, as this thread may be stopped between two stages.
void CheckShare(TestChecks& checks, TilesScene& scene)
{
  double most = 0.0;
  for (int frame = 0; frame < 10 && most <= 0.8; ++frame)
  {
    CHECK(scene.DrawTiles());
    most = std::max(most, scene.Engine.GetStages().GetSum() / scene.SecondsOfEngine);
  }
  CHECK(most > 0.8);
}

// Of light and dark alike: nothing is opaque, nothing transparent.
void CheckCounts(TestChecks& checks, TilesScene& scene, double segments)
{
  const TileCounts& counts = scene.Engine.GetCounts();
  const double fragments = static_cast<double>(counts.Fragments);
  std::cout << "fragments " << fragments << ", pieces of rays in cells by the oracle " << segments
            << ", lanes of blocks " << counts.LanesOfBlocks << ", covered " << counts.CoveredLanes
            << ", pieces " << counts.Pieces << ", lanes shaded " << counts.ShadedLanes << "\n";
  CHECK(segments > 0.0);
  CHECK_AT_MOST(std::abs(fragments - segments), Grazing * segments);
  CHECK(counts.CoveredLanes == counts.Fragments);
  CHECK(counts.CoveredLanes <= counts.LanesOfBlocks);
  CHECK(counts.Pieces >= counts.Fragments);
  CHECK(counts.Pieces <= counts.ShadedLanes);
  // Full vectors but for the last of a queue.
  CHECK(counts.Pieces > 0.8 * static_cast<double>(counts.ShadedLanes));
}

void CheckThreads(TestChecks& checks, TilesScene& scene, int threads)
{
  vtkSMPTools::Initialize(threads);
  scene.TimesStages = true;
  CHECK(scene.DrawTiles());
  scene.LookFrom(1.0, 0.0, 2.0);
  CHECK(scene.DrawTiles());
  scene.LookFrom(0.5, 0.8, 2.2);
  CHECK(scene.DrawTiles());
  CheckTimes(checks, scene);
  CheckCounts(checks, scene, static_cast<double>(scene.Oracle->GetNumberOfSegments()));
  CheckShare(checks, scene);
  const std::vector<float> image = scene.Engine.GetImage();
  scene.TimesStages = false;
  CHECK(scene.DrawTiles());
  CHECK(scene.Engine.GetImage() == image);
  CHECK(scene.Engine.GetStages().GetSum() == 0.0);
  CHECK(scene.Engine.GetCounts().LanesOfBlocks == 0);
}

// First and last column and row that the oracle covers.
std::array<int, 4> FindBox(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  std::array<int, 4> box{ { size[0], size[1], -1, -1 } };
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      if (image->GetScalarComponentAsDouble(x, y, 0, 3) > 0.0)
      {
        box = { { std::min(box[0], x), std::min(box[1], y), std::max(box[2], x), std::max(box[3], y) } };
      }
    }
  }
  return box;
}

// One cell in one tile: its rows hold no pixel that it does not cover, and full vectors but for the last.
void CheckRows(TestChecks& checks)
{
  TilesScene scene(60, 50);
  scene.SetTetrahedra(TestMeshes::Tetrahedron());
  scene.SetConstant(0.5);
  scene.LookFrom(0.5, 0.8, 2.2);
  scene.TimesStages = true;
  CHECK_AT_MOST(scene.TilesError("tetrahedron"), 1e-4);
  const std::array<int, 4> box = FindBox(scene.Oracle->GetImage());
  const int width = box[2] - box[0] + 1, height = box[3] - box[1] + 1;
  const TileCounts& counts = scene.Engine.GetCounts();
  std::cout << "box " << width << " x " << height << ", lanes of blocks " << counts.LanesOfBlocks << "\n";
  CHECK(width > 10 && height > 10);
  CHECK(counts.CoveredLanes == scene.Oracle->GetNumberOfSegments());
  CHECK(counts.LanesOfBlocks >= counts.CoveredLanes);
  CHECK(counts.LanesOfBlocks < counts.CoveredLanes + 16);
}
}

int TestTilesStages(int, char*[])
{
  TestChecks checks;
  TilesScene scene(150, 140);
  scene.SetTetrahedra(TestMeshes::Delaunay(200));
  scene.SetSmooth();
  scene.LookFrom(0.5, 0.8, 2.2);
  CHECK_AT_MOST(scene.TilesError("Delaunay"), 1e-4);
  vtkSMPTools::SetBackend("STDThread");
  for (const int threads : { 1, 2, 3 })
  {
    CheckThreads(checks, scene, threads);
  }
  vtkSMPTools::Initialize(0);
  CheckRows(checks);
  return checks.Result();
}
