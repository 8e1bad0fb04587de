// The preparation of a new mesh reports its progress by every mapper and engine: never backwards, up
// to 1, in ten steps at least by Tiles; frames of the same mesh report none, whatever else changes.

#include "PolyhedraScene.h"
#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkCallbackCommand.h"

namespace
{
struct ProgressCount
{
  int Events = 0;
  int Backwards = 0;
  double Last = 0.0;
};

void Count(vtkObject*, unsigned long, void* client, void* data)
{
  auto* count = static_cast<ProgressCount*>(client);
  const double progress = *static_cast<double*>(data);
  // VTK's pipeline has said 0 and 1 before the mapper begins.
  count->Backwards += progress < count->Last && count->Last < 1.0 ? 1 : 0;
  count->Last = progress;
  ++count->Events;
}

ProgressCount CountProgress(TestScene& scene)
{
  ProgressCount count;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(Count);
  observer->SetClientData(&count);
  const unsigned long tag = scene.Mapper->AddObserver(vtkCommand::ProgressEvent, observer);
  scene.Render();
  scene.Mapper->RemoveObserver(tag);
  return count;
}

void CheckProgress(TestChecks& checks, TestScene& scene, vtkUnstructuredGrid* mesh, int leastEvents)
{
  for (int round = 0; round < 2; ++round)
  {
    vtkNew<vtkUnstructuredGrid> copy;
    copy->DeepCopy(mesh);
    scene.SetGrid(copy);
    const ProgressCount count = CountProgress(scene);
    CHECK(count.Events >= leastEvents);
    CHECK(count.Backwards == 0);
    CHECK(count.Last == 1.0);
    CHECK(CountProgress(scene).Events == 0);
    scene.LookFrom(1.0, 0.2 + round, 2.0);
    scene.Opacity->AddPoint(0.4, 3.0 + round);
    CHECK(CountProgress(scene).Events == 0);
  }
}
}

int TestProgress(int, char*[])
{
  TestChecks checks;
  TestScene scene;
  auto mesh = TestMeshes::Curvilinear(3);
  scene.Mapper->SetEngineToTiles();
  CheckProgress(checks, scene, mesh, 10);
  scene.Mapper->SetEngineToRaster();
  CheckProgress(checks, scene, mesh, 5);
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::Exact())
  {
    PolyhedraScene polyhedra(mapper.Make());
    polyhedra.Mapper->SetEngineToTiles();
    CheckProgress(checks, polyhedra, mesh, 10);
  }
  return checks.Result();
}
