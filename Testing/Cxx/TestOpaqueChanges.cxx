// Something opaque that comes and goes: Tiles look for it while they draw, and draw again where it is there. Every
// frame is that of a mapper that knew before, and counts the same, whoever of vtkSMPTools' backends draws: of frames
// that are drawn coarser, and of viewports that share a mapper, too.

#include "OpaquePlane.h"
#include "PolyhedraScene.h"
#include "TestMeshes.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
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

// The plane at `z` in one of two viewports, or in none.
enum Place
{
  Nowhere,
  First,
  Second
};
constexpr float Coarse = 3.0f;
using Make = std::function<std::unique_ptr<TestScene>()>;

/// A scene, and which of its viewports has a plane.
struct ChangingScene
{
  std::unique_ptr<TestScene> Scene;
  vtkSmartPointer<vtkRenderer> Beside;
  vtkSmartPointer<vtkActor> Plane;

  ChangingScene(const Make& make, bool hasTwo)
    : Scene(make())
  {
    Prepare(*this->Scene);
    this->Beside = hasTwo ? this->Scene->AddSecondViewport() : nullptr;
    OpaquePlane::Add(*this->Scene, 0.3, 0.3);
    this->Plane = this->Scene->Renderer->GetActors()->GetLastActor();
    if (hasTwo)
    {
      // From elsewhere: what is known of the one viewport is wrong in the other.
      vtkNew<vtkCamera> camera;
      camera->DeepCopy(this->Scene->Renderer->GetActiveCamera());
      camera->Azimuth(50.0);
      camera->SetViewAngle(25.0);
      this->Beside->SetActiveCamera(camera);
      this->Beside->SetBackground(0.4, 0.1, 0.3);
    }
  }

  Shown ShowWith(Place place)
  {
    this->Scene->Renderer->RemoveActor(this->Plane);
    if (this->Beside)
    {
      this->Beside->RemoveActor(this->Plane);
    }
    if (place != Nowhere)
    {
      (place == First ? this->Scene->Renderer : this->Beside)->AddActor(this->Plane);
    }
    return Show(*this->Scene);
  }
};

/// What a mapper shows first of all, every pixel or as coarsely as that.
Shown ShowFresh(const Make& make, bool hasTwo, Place place, bool isCoarse)
{
  ChangingScene fresh(make, hasTwo);
  fresh.Scene->Mapper->AutoAdjustSampleDistancesOff();
  fresh.Scene->Mapper->SetImageSampleDistance(isCoarse ? Coarse : 1.0f);
  return fresh.ShowWith(place);
}

// Of fine frames and of coarse ones.
using Expected = std::array<std::vector<Shown>, 2>;

Expected ShowAllFresh(const Make& make, bool hasTwo)
{
  const std::vector<Place> places =
    hasTwo ? std::vector<Place>{ Nowhere, First, Second } : std::vector<Place>{ Nowhere, First };
  Expected expected;
  for (const bool isCoarse : { false, true })
  {
    for (const Place place : places)
    {
      expected[isCoarse ? 1 : 0].push_back(ShowFresh(make, hasTwo, place, isCoarse));
    }
  }
  return expected;
}

// In turns at rest and while the window asks for more frames than there is time for.
void CheckFrames(TestChecks& checks, const Make& make, bool hasTwo)
{
  ChangingScene scene(make, hasTwo);
  scene.Scene->Mapper->SetMaximumImageSampleDistance(Coarse);
  scene.ShowWith(Nowhere);
  const Expected expected = ShowAllFresh(make, hasTwo);
  CHECK(expected[1][0].Colors != expected[0][0].Colors);
  CHECK(expected[1][1].Colors != expected[0][1].Colors && expected[1][1].Colors != expected[1][0].Colors);
  struct
  {
    Place At;
    bool IsCoarse;
  } const frames[] = { { Nowhere, true }, { First, true }, { First, true }, { First, false }, { Nowhere, true },
    { First, false }, { Nowhere, false }, { First, true }, { Second, true }, { Second, false }, { First, false },
    { Second, true }, { Nowhere, true }, { Nowhere, false } };
  for (const auto& frame : frames)
  {
    const Place place = frame.At == Second && !hasTwo ? First : frame.At;
    scene.Scene->Window->SetDesiredUpdateRate(frame.IsCoarse ? 1e7 : 1e-4);
    const Shown shown = scene.ShowWith(place);
    CHECK(shown == expected[frame.IsCoarse ? 1 : 0][place]);
    vtkTable* statistics = scene.Scene->Mapper->GetLastStatistics();
    // Said of coarse frames alone.
    CHECK((statistics->GetColumnByName("ImageSampleDistance") != nullptr) == frame.IsCoarse);
  }
}

void CheckSharing(TestChecks& checks)
{
  std::vector<Make> makers = { [] { return std::make_unique<TestScene>(150, 140); } };
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::Exact())
  {
    makers.push_back([mapper] { return std::make_unique<PolyhedraScene>(mapper.Make(), 150, 140); });
  }
  for (const Make& make : makers)
  {
    CheckFrames(checks, make, false);
    CheckFrames(checks, make, true);
  }
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
    if (std::string(backend) == "STDThread")
    {
      CheckSharing(checks);
    }
  }
  return checks.Result();
}
