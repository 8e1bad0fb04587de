// The Tiles engine with every instruction set that this machine has: each within 1e-4 of the
// oracle, transfer functions of few points and of many. Same bytes from run to run and for any
// number of threads.

#include "TestMeshes.h"
#include "TilesScene.h"

#include "vtkSMPTools.h"

#include <hwy/highway.h>
#include <hwy/targets.h>

#include <cmath>

namespace
{
// More points than any vector has lanes.
void SetManyPoints(TilesScene& scene)
{
  scene.SetSmooth();
  scene.Opacity->RemoveAllPoints();
  for (int i = 0; i <= 40; ++i)
  {
    scene.Opacity->AddPoint(i / 40.0, 3.0 + 3.0 * std::cos(2.0 * i));
  }
}

void CheckError(TestChecks& checks, TilesScene& scene, const std::string& name)
{
  const double error = scene.TilesError(name);
  CHECK(error >= 0.0);
  CHECK_AT_MOST(error, 1e-4);
}

// Fragments that a node cuts count as two pieces, whatever else is in their vector.
void CheckPieces(TestChecks& checks, TilesScene& scene, double& piecesOfFirst)
{
  scene.SetSmooth();
  CHECK(scene.DrawTiles());
  const double pieces = static_cast<double>(scene.Engine.GetCounts().Pieces);
  piecesOfFirst = piecesOfFirst > 0.0 ? piecesOfFirst : pieces;
  CHECK(pieces > 1.05 * static_cast<double>(scene.Engine.GetCounts().Fragments));
  CHECK_NEAR(pieces, piecesOfFirst, 1e-3 * piecesOfFirst);
}

void CheckTargets(TestChecks& checks, TilesScene& scene)
{
  double pieces = 0.0;
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    hwy::GetChosenTarget().Update(target);
    const std::string name = hwy::TargetName(target);
    scene.SetSpiky();
    CheckError(checks, scene, name + ", 9 points");
    SetManyPoints(scene);
    CheckError(checks, scene, name + ", 41 points");
    CHECK(scene.Engine.GetCounts().Pieces > scene.Engine.GetCounts().Fragments);
    CheckPieces(checks, scene, pieces);
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

void CheckThreads(TestChecks& checks, TilesScene& scene)
{
  // Others take no more threads than there are cores.
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(1);
  CHECK(scene.DrawTiles());
  const std::vector<float> image = scene.Engine.GetImage();
  for (const int threads : { 1, 2, 3, 7 })
  {
    vtkSMPTools::Initialize(threads);
    // Moved and back: nothing of the frame before is used again.
    scene.LookFrom(1.0, 0.0, 2.0);
    CHECK(scene.DrawTiles());
    CHECK(scene.Engine.GetImage() != image);
    scene.LookFrom(0.5, 0.8, 2.2);
    CHECK(scene.DrawTiles());
    CHECK(scene.Engine.GetImage() == image);
  }
  vtkSMPTools::Initialize(0);
}
}

int TestTilesTargets(int, char*[])
{
  TestChecks checks;
  TilesScene scene(90, 80);
  scene.SetTetrahedra(TestMeshes::Delaunay(60));
  scene.LookFrom(0.5, 0.8, 2.2);
  CheckTargets(checks, scene);
  CheckThreads(checks, scene);
  return checks.Result();
}
