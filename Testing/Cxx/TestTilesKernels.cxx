// The Tiles engines on plain arrays, every stage of them: images of numbers between 0 and 1, the same
// bytes for every backend and number of threads, after other views, cuts and frames that were given up.
// It needs no window: the sanitizers run it.

#include "EmissionTilesEngine.h"
#include "ExtremumTilesEngine.h"
#include "HexahedraArrays.h"
#include "TestScene.h"
#include "TileArrays.h"

#include "vtkIdList.h"
#include "vtkSMPTools.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

namespace
{
using Image = std::vector<float>;
using Draw = std::function<Image(int view)>;
constexpr int Views = 3;

bool IsImage(const Image& image)
{
  return !image.empty() &&
    std::all_of(image.begin(), image.end(), [](float x) { return x >= 0.0f && x <= 1.001f; }) &&
    std::any_of(image.begin(), image.end(), [](float x) { return x > 0.01f; });
}

void CheckThreads(TestChecks& checks, const Draw& draw)
{
  std::vector<Image> images;
  vtkSMPTools::SetBackend("Sequential");
  for (int view = 0; view < Views; ++view)
  {
    images.push_back(draw(view));
    CHECK(IsImage(images.back()));
  }
  vtkSMPTools::SetBackend("STDThread");
  for (const int threads : { 2, 5 })
  {
    vtkSMPTools::Initialize(threads);
    for (int view = Views - 1; view >= 0; --view)
    {
      CHECK(draw(view) == images[view]);
    }
  }
  vtkSMPTools::Initialize(0);
}

void LookAt(TileArrays& arrays, int view)
{
  const glm::dvec3 eyes[Views] = { { 0.9, 1.5, 3.5 }, { 0.1, 0.05, 0.02 }, { -2.0, 0.5, 1.0 } };
  arrays.LookFrom(eyes[view], view == 1 ? 60.0 : 35.0, 150, 140);
}

void CheckTetrahedra(TestChecks& checks)
{
  TileArrays arrays(7);
  arrays.SetFunction(false);
  arrays.SetMesh();
  std::vector<vtkIdType> order(static_cast<std::size_t>(arrays.GetNumberOfCells()));
  std::iota(order.begin(), order.end(), 0);
  const std::vector<unsigned char> every(order.size(), 1);
  std::vector<unsigned char> few(order.size(), 0);
  std::generate(few.begin(), few.end(), [cell = 0]() mutable { return ++cell % 5 < 2 ? 1 : 0; });
  std::vector<float> depth;
  CheckThreads(checks,
    [&](int view)
    {
      LookAt(arrays, view);
      Image all;
      for (int part = 0; part < 6; ++part)
      {
        // The last are opaque, and next to empty.
        arrays.SetFunction(part == 1, part == 4 ? 0.004 : 0.2);
        arrays.Engine.SetDrawn(part == 5 ? few : every);
        arrays.Scene.BackToFront = part == 2 ? &order : nullptr;
        arrays.Scene.ClippingPlanes.clear();
        if (part == 3)
        {
          arrays.Scene.ClippingPlanes.emplace_back(0.3f, 0.9f, 0.1f, 0.1f);
        }
        depth.assign(150 * 140, part == 3 ? 0.996f : 1.0f);
        arrays.Scene.OpaqueDepth = depth.data();
        CHECK(arrays.Render());
        CHECK(part != 4 || view == 1 || arrays.Engine.GetCounts().HiddenCells > 0);
        const Image& image = arrays.Engine.GetImage();
        all.insert(all.end(), image.begin(), image.end());
      }
      return all;
    });
}

void CheckAbort(TestChecks& checks)
{
  vtkSMPTools::SetBackend("STDThread");
  TileArrays arrays(7);
  arrays.SetFunction(false);
  arrays.SetMesh();
  LookAt(arrays, 0);
  CHECK(arrays.Render());
  const Image image = arrays.Engine.GetImage();
  LookAt(arrays, 2);
  int asked = 0;
  arrays.Scene.IsAborted = [&asked] { return ++asked > 1; };
  CHECK(!arrays.Render());
  arrays.Scene.IsAborted = nullptr;
  LookAt(arrays, 0);
  CHECK(arrays.Render());
  CHECK(arrays.Engine.GetImage() == image);
}

template <class Engine>
void CheckConvexCells(TestChecks& checks, Engine& engine)
{
  TileArrays arrays(1);
  arrays.SetFunction(false, 10.0);
  CheckThreads(checks,
    [&](int view)
    {
      LookAt(arrays, view);
      ConvexTilesFrame::Scene scene;
      scene.Camera = arrays.Scene.Camera;
      scene.Function = arrays.Scene.Function;
      CHECK(engine.Render(scene));
      return engine.GetImage();
    });
}

// Images without pixels or with too many, matrices without an inverse, and one that keeps no far plane.
std::vector<TileView::Camera> CamerasOfNothing(const TileView::Camera& camera)
{
  std::vector<TileView::Camera> cameras;
  for (const auto& size : { std::array<int, 2>{ 0, 64 }, { 64, 0 }, { 0, 0 }, { -1, 64 },
         { TileSize::LargestImage + 1, 64 } })
  {
    cameras.push_back(camera);
    cameras.back().Width = size[0];
    cameras.back().Height = size[1];
  }
  cameras.push_back(camera);
  cameras.back().MeshToView[1] = glm::dvec4(0.0);
  cameras.push_back(camera);
  cameras.back().ViewToClip[0][0] = std::nan("");
  cameras.push_back(camera);
  cameras.back().ViewToClip = glm::perspective(0.6, 1.0, 1e-18, 10.0);
  return cameras;
}

// Such a camera makes no frame; the next one is drawn again.
template <class Engine, class Scene>
void CheckCameras(TestChecks& checks, Engine& engine, Scene scene)
{
  CHECK(engine.Render(scene));
  const Image image = engine.GetImage();
  const TileView::Camera good = scene.Camera;
  for (const TileView::Camera& camera : CamerasOfNothing(good))
  {
    scene.Camera = camera;
    CHECK(!engine.Render(scene));
    scene.Camera = good;
    CHECK(engine.Render(scene));
    CHECK(engine.GetImage() == image);
  }
}

void CheckCamerasOfTetrahedra(TestChecks& checks)
{
  TileArrays arrays(3);
  arrays.SetFunction(false);
  arrays.SetMesh();
  LookAt(arrays, 0);
  CheckCameras(checks, arrays.Engine, arrays.Scene);
}

template <class Engine>
void CheckCamerasOfConvexCells(TestChecks& checks, Engine& engine)
{
  TileArrays arrays(1);
  arrays.SetFunction(false, 10.0);
  LookAt(arrays, 0);
  ConvexTilesFrame::Scene scene;
  scene.Function = arrays.Scene.Function;
  scene.Camera = arrays.Scene.Camera;
  CheckCameras(checks, engine, scene);
}
}

int TestTilesKernels(int, char*[])
{
  TestChecks checks;
  CheckTetrahedra(checks);
  CheckAbort(checks);
  CheckCamerasOfTetrahedra(checks);
  const HexahedraArrays mesh(6);
  EmissionTilesEngine emission;
  emission.SetMesh(mesh.Points, mesh.Cells, mesh.Pieces, mesh.Planes);
  emission.SetScalars(mesh.Scalars, false);
  emission.SetDrawn(mesh.Drawn);
  CheckConvexCells(checks, emission);
  CheckCamerasOfConvexCells(checks, emission);
  ExtremumTilesEngine extremum;
  extremum.SetMesh(mesh.Points, mesh.Cells, mesh.Pieces, mesh.Planes);
  extremum.SetScalars(mesh.Scalars, false, false);
  extremum.SetDrawn(mesh.Drawn);
  CheckConvexCells(checks, extremum);
  CheckCamerasOfConvexCells(checks, extremum);
  return checks.Result();
}
