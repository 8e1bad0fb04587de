// Something opaque that comes and goes: Tiles look for it while they draw, and draw again where it is there. Every
// frame is that of a mapper that knew before, and counts the same, whoever of vtkSMPTools' backends draws.

#include "OpaquePlane.h"
#include "PolyhedraScene.h"
#include "TestMeshes.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <iostream>
#include <vector>

namespace
{
/// What a frame shows and counts.
struct Shown
{
  std::vector<unsigned char> Colors;
  vtkIdType Drawn, Outside;

  bool operator==(const Shown& other) const
  {
    return this->Colors == other.Colors && this->Drawn == other.Drawn && this->Outside == other.Outside;
  }
};

Shown Show(TestScene& scene)
{
  scene.Window->Render();
  const int* size = scene.Window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  scene.Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  return { { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() },
    scene.GetStatistic("CellsDrawn"), scene.GetStatistic("CellsSkippedOutside") };
}

// The window's own pixels are read as well where no image is captured.
void Prepare(TestScene& scene)
{
  scene.SetMesh(TestMeshes::JitteredCube(10));
  scene.Mapper->SetEngineToTiles();
  scene.Mapper->CaptureImageOff();
  scene.Renderer->SetBackground(0.2, 0.5, 0.3);
  scene.LookFrom(0.5, 0.8, 2.2);
  // Some cells lie outside in any case.
  scene.Renderer->GetActiveCamera()->SetViewAngle(5.0);
}

// A plane through the mesh, or before it so that all of it is left out.
void CheckChanges(TestChecks& checks, TestScene& scene, double plane)
{
  Prepare(scene);
  const Shown without = Show(scene);
  OpaquePlane::Add(scene, plane, plane);
  const Shown found = Show(scene);
  const Shown known = Show(scene);
  CHECK(found == known);
  CHECK(found.Colors != without.Colors);
  // Other mappers do not count by Tiles what lies outside.
  CHECK(found.Outside > without.Outside || plane < 0.5 || !scene.GetTetrahedraMapper());
  CHECK(without.Outside > 0 || !scene.GetTetrahedraMapper());
  scene.Renderer->GetActors()->GetLastActor()->VisibilityOff();
  CHECK(Show(scene) == without);
  CHECK(Show(scene) == without);
  scene.Renderer->GetActors()->GetLastActor()->VisibilityOn();
  CHECK(Show(scene) == known);
}

// Of one tile some backends ask at the start only.
void CheckMappers(TestChecks& checks)
{
  struct
  {
    int Size;
    double Plane;
  } const cases[] = { { 40, 0.3 }, { 40, 0.7 }, { 190, 0.3 }, { 190, 0.7 } };
  for (const auto& each : cases)
  {
    TestScene scene(each.Size, each.Size);
    CheckChanges(checks, scene, each.Plane);
    for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::Exact())
    {
      PolyhedraScene polyhedra(mapper.Make(), each.Size, each.Size);
      CheckChanges(checks, polyhedra, each.Plane);
    }
  }
}
}

int TestOpaqueChanges(int, char*[])
{
  TestChecks checks;
  for (const char* backend : { "STDThread", "TBB", "Sequential" })
  {
    const bool isThere = vtkSMPTools::SetBackend(backend);
    std::cout << backend << (isThere ? "\n" : ": this VTK has none, left out\n");
    if (!isThere)
    {
      continue;
    }
    CheckMappers(checks);
  }
  return checks.Result();
}
