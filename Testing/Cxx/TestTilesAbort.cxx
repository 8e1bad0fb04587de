// A frame that is given up: no tile after the answer, nothing of it in the window, and the next frame
// is that of a fresh engine or mapper to the last byte, with every backend of vtkSMPTools.

#include "PolyhedraScene.h"
#include "TestMeshes.h"
#include "TilesScene.h"

#include "vtkCallbackCommand.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <string>

namespace
{
constexpr int Width = 200, Height = 190; // 4 x 3 tiles

void SetScene(TilesScene& scene)
{
  scene.SetTetrahedra(TestMeshes::Delaunay(80));
  scene.SetSpiky();
  scene.LookFrom(0.5, 0.8, 2.2);
}

void CheckEngine(TestChecks& checks, const std::string& backend)
{
  vtkSMPTools::SetBackend(backend.c_str());
  TilesScene fresh(Width, Height), scene(Width, Height);
  SetScene(fresh);
  SetScene(scene);
  CHECK(fresh.DrawTiles());
  const long long all = fresh.Engine.GetCounts().Fragments;
  for (const int goodAnswers : { 0, 1 })
  {
    int asked = 0;
    scene.IsAborted = [&] { return asked++ >= goodAnswers; };
    const bool isDrawn = scene.DrawTiles();
    // Two threads may share the tiles so that the one that asks is done before.
    CHECK(!isDrawn || (backend == "TBB" && goodAnswers > 0));
    CHECK(isDrawn == (scene.Engine.GetCounts().Fragments == all));
    CHECK(isDrawn || asked == goodAnswers + 1);
    CHECK(backend != "Sequential" || goodAnswers > 0 ||
      scene.Engine.GetCounts().Fragments == 0);
  }
  scene.IsAborted = [] { return false; };
  CHECK(scene.DrawTiles());
  CHECK(scene.Engine.GetCounts().Fragments == all);
  CHECK(scene.Engine.GetImage() == fresh.Engine.GetImage());
}

void Abort(vtkObject* caller, unsigned long, void*, void*)
{
  vtkRenderWindow::SafeDownCast(caller)->SetAbortRender(1);
}

vtkIdType Drawn(TestScene& scene)
{
  return scene.Mapper->GetLastStatistics()->GetValueByName(0, "CellsDrawn").ToTypeInt64();
}

void CheckMapper(TestChecks& checks, TestScene& scene, TestScene& fresh)
{
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(Abort);
  const unsigned long tag = scene.Window->AddObserver(vtkCommand::AbortCheckEvent, abort);
  scene.Render();
  CHECK(scene.Mapper->GetCapturedImage() == nullptr);
  CHECK(Drawn(scene) == 0);
  scene.Window->RemoveObserver(tag);
  scene.Window->SetAbortRender(0);
  scene.Render();
  fresh.Render();
  CHECK(Drawn(scene) > 0);
  CHECK(TestScene::Difference(
          scene.Mapper->GetCapturedImage(), fresh.Mapper->GetCapturedImage()) == 0.0);
}
}

int TestTilesAbort(int, char*[])
{
  TestChecks checks;
  for (const char* backend : { "STDThread", "TBB", "Sequential" })
  {
    CheckEngine(checks, backend);
  }
  TestScene scene(Width, Height), fresh(Width, Height);
  for (TestScene* each : { &scene, &fresh })
  {
    each->SetGrid(TestMeshes::Delaunay(60));
    each->Mapper->SetEngineToTiles();
  }
  CheckMapper(checks, scene, fresh);
  auto mesh = TestMeshes::Curvilinear(3);
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::Exact())
  {
    PolyhedraScene polyhedra(mapper.Make(), 80, 72), freshPolyhedra(mapper.Make(), 80, 72);
    for (PolyhedraScene* each : { &polyhedra, &freshPolyhedra })
    {
      each->SetMesh(mesh);
      each->SetView(0);
      each->Mapper->SetEngineToTiles();
    }
    CheckMapper(checks, polyhedra, freshPolyhedra);
  }
  return checks.Result();
}
