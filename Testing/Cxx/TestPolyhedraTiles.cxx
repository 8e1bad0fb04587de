// The Tiles engine for convex cells with every instruction set that this machine has, within the
// bounds of each mapper; the same bytes for any number of threads and as after another view; the
// same image as Raster's.

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"
#include "TestMeshes.h"

#include "vtkSMPTools.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <hwy/targets.h>

namespace
{
void CheckTargets(TestChecks& checks, PolyhedraScene& scene, const std::string& name)
{
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    hwy::GetChosenTarget().Update(target);
    scene.CheckWithOracle(checks, name + ", " + hwy::TargetName(target), __LINE__);
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

void CheckThreads(TestChecks& checks, PolyhedraScene& scene)
{
  vtkSMPTools::Initialize(1);
  scene.SetView(0);
  scene.Render();
  auto image = scene.CopyCaptured();
  for (const int threads : { 1, 2, 3, 7 })
  {
    vtkSMPTools::Initialize(threads);
    // Moved and back: nothing of the frame before is used again.
    scene.SetView(1);
    scene.Render();
    CHECK(TestScene::Difference(image, scene.Mapper->GetCapturedImage()) > 0.01);
    scene.SetView(0);
    scene.Render();
    CHECK(TestScene::Difference(image, scene.Mapper->GetCapturedImage()) == 0.0);
  }
  vtkSMPTools::Initialize(0);
}

void CheckRaster(TestChecks& checks, PolyhedraScene& scene)
{
  scene.SetView(0);
  scene.Render();
  auto tiles = scene.CopyCaptured();
  CHECK(scene.Mapper->GetLastStatistics()->GetValueByName(0, "Engine").ToString() == "Tiles");
  scene.Mapper->SetEngineToRaster();
  scene.Render();
  CHECK(scene.Mapper->GetLastStatistics()->GetValueByName(0, "Engine").ToString() == "Raster");
  const double bound = 2.0 * scene.GetBound();
  // Pixels at silhouettes belong to either.
  CHECK_AT_MOST(TestScene::CountDifferent(tiles, scene.Mapper->GetCapturedImage(), bound), 5);
  scene.Mapper->SetEngineToTiles();
}
}

int TestPolyhedraTiles(int, char*[])
{
  TestChecks checks;
  // Others take no more threads than there are cores.
  vtkSMPTools::SetBackend("STDThread");
  auto curvilinear = TestMeshes::Curvilinear(4);
  PolyhedraMeshes::SetWaves(curvilinear);
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::Exact())
  {
    PolyhedraScene scene(mapper.Make(), 80, 72);
    scene.Mapper->SetEngineToTiles();
    scene.SetMesh(curvilinear);
    CheckThreads(checks, scene);
    CheckTargets(checks, scene, mapper.Name);
    CheckRaster(checks, scene);
  }
  return checks.Result();
}
