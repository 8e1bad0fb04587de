// Cells outside the view, behind clipping planes and behind opaque depth are left out in clusters: they
// are most of those there, the image is the oracle's, and after any other view or cut that of a fresh
// engine to the last byte.

#include "TestMeshes.h"
#include "TilesScene.h"

#include "vtkFloatArray.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"

#include <functional>

namespace
{
constexpr int Width = 72, Height = 70;

void SetOpaque(TilesScene& scene, float depth)
{
  scene.OpaqueDepth.assign(depth < 1.0f ? Width * Height : 0, depth);
  vtkNew<vtkFloatArray> depths;
  for (int i = 0; i < Width * Height; ++i)
  {
    depths->InsertNextValue(depth);
  }
  scene.Oracle->SetOpaqueDepth(depth < 1.0f ? depths.GetPointer() : nullptr);
}

// The window depth of a distance from the eye.
float DepthOf(TilesScene& scene, double distance)
{
  const double* range = scene.Renderer->GetActiveCamera()->GetClippingRange();
  return static_cast<float>(
    range[1] / (range[1] - range[0]) * (1.0 - range[0] / distance));
}

struct View
{
  const char* Name;
  std::function<void(TilesScene&)> Set;
  /// Share of the cells that is left out, at least.
  double Outside;
};

const std::vector<View>& Views()
{
  static const std::vector<View> views = {
    { "whole", [](TilesScene&) {}, 0.0 },
    { "zoomed in", [](TilesScene& s) { s.Renderer->GetActiveCamera()->SetViewAngle(5.0); }, 0.03 },
    { "looking past the middle",
      [](TilesScene& s) { s.Renderer->GetActiveCamera()->SetFocalPoint(0.9, 0.5, 0.0); }, 0.05 },
    { "from inside", [](TilesScene& s) { s.LookFrom(0.1, 0.05, 0.02); }, 0.2 },
    { "far plane within", [](TilesScene& s)
      { s.Renderer->GetActiveCamera()->SetClippingRange(0.1, 2.1); }, 0.2 },
    { "near plane within", [](TilesScene& s)
      { s.Renderer->GetActiveCamera()->SetClippingRange(2.4, 20.0); }, 0.05 },
    { "clipping plane",
      [](TilesScene& s)
      {
        vtkNew<vtkPlane> plane;
        plane->SetNormal(0.6, 0.8, 0.0);
        plane->SetOrigin(0.1, 0.1, 0.0);
        s.Mapper->AddClippingPlane(plane);
      },
      0.1 },
    { "opaque", [](TilesScene& s) { SetOpaque(s, DepthOf(s, 2.1)); }, 0.2 }
  };
  return views;
}

void Reset(TilesScene& scene)
{
  scene.LookFrom(0.5, 0.8, 2.2);
  scene.Renderer->GetActiveCamera()->SetViewAngle(30.0);
  scene.Mapper->RemoveAllClippingPlanes();
  SetOpaque(scene, 1.0f);
}

void CheckViews(TestChecks& checks, vtkUnstructuredGrid* grid)
{
  TilesScene scene(Width, Height);
  scene.SetTetrahedra(grid);
  for (const View& view : Views())
  {
    Reset(scene);
    view.Set(scene);
    const double error = scene.TilesError(view.Name);
    CHECK(error >= 0.0);
    CHECK_AT_MOST(error, 1e-4);
    const double outside = static_cast<double>(scene.Engine.CountCellsOutside()) /
      static_cast<double>(grid->GetNumberOfCells());
    std::cout << view.Name << ": " << outside << " of the cells left out\n";
    CHECK(outside >= view.Outside);
    CHECK(outside < 1.0);
    TilesScene fresh(Width, Height);
    fresh.SetTetrahedra(grid);
    Reset(fresh);
    view.Set(fresh);
    CHECK(fresh.DrawTiles());
    CHECK(fresh.Engine.GetImage() == scene.Engine.GetImage());
    // The camera stays, what hides the cells comes and goes.
    SetOpaque(scene, 0.5f);
    CHECK(scene.DrawTiles());
    SetOpaque(scene, fresh.OpaqueDepth.empty() ? 1.0f : fresh.OpaqueDepth[0]);
    CHECK(scene.DrawTiles());
    CHECK(fresh.Engine.GetImage() == scene.Engine.GetImage());
  }
}

void CheckStatistics(TestChecks& checks, vtkUnstructuredGrid* grid)
{
  TestScene scene(Width, Height);
  scene.SetGrid(grid);
  scene.SetSpiky();
  scene.Mapper->SetEngineToTiles();
  scene.CheckCellsLeftOut(checks, 30.0, grid->GetNumberOfCells());
}
}

int TestTilesCulling(int, char*[])
{
  TestChecks checks;
  auto grid = TestMeshes::Delaunay(1000);
  CheckViews(checks, grid);
  CheckStatistics(checks, grid);
  return checks.Result();
}
