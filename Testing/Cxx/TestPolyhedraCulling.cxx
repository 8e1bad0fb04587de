// Convex cells outside the view, behind clipping planes or opaque depth and those that are transparent
// are left out, in clusters and in each tile: they are most of those there, the image is that of all
// cells to the last byte, also after any other view or cut, and a new function asks for no new order.

#include "EmissionTilesEngine.h"
#include "ExtremumTilesEngine.h"
#include "HexahedraArrays.h"
#include "PolyhedraScene.h"
#include "PolyhedraTiles.h"
#include "TestMeshes.h"
#include "TileArrays.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace
{
constexpr int Width = 150, Height = 140;
constexpr int Cells = 32;

/// What is seen, and what hides it.
struct View
{
  const char* Name;
  glm::dvec3 Eye;
  double Angle;
  std::vector<glm::vec4> Planes;
  /// Distance of something opaque from the eye; 0 for nothing. On the left half of the pixels alone, or
  /// on all.
  double Opaque;
  bool OnHalf;
  /// Share of the cells outside, at least, and whether others are hidden in tiles.
  double Outside;
  bool Hides;
};

const std::vector<View>& Views()
{
  const glm::dvec3 eye(0.9, 1.5, 3.5);
  static const std::vector<View> views = { { "whole", eye, 35.0, {}, 0.0, false, 0.0, false },
    { "zoomed in", eye, 12.0, {}, 0.0, false, 0.2, false },
    { "from inside", { 0.1, 0.05, 0.02 }, 60.0, {}, 0.0, false, 0.7, false },
    { "clipping plane", eye, 35.0, { { 0.3f, 0.9f, 0.1f, 0.1f } }, 0.0, false, 0.4, true },
    { "opaque", eye, 35.0, {}, 3.5, false, 0.5, true },
    { "opaque on a half", eye, 35.0, {}, 3.5, true, 0.08, true } };
  return views;
}

void SetView(const View& view, std::vector<float>& depth, ConvexTilesFrame::Scene& scene)
{
  TileArrays arrays(1);
  arrays.LookFrom(view.Eye, view.Angle, Width, Height);
  scene.Camera = arrays.Scene.Camera;
  scene.ClippingPlanes = view.Planes;
  depth.assign(Width * Height, 1.0f);
  for (int i = 0; i < Width * Height && view.Opaque > 0.0; ++i)
  {
    const bool isOpen = view.OnHalf && i % Width >= Width / 2;
    depth[i] = isOpen ? 1.0f : static_cast<float>(20.0 / 19.99 * (1.0 - 0.01 / view.Opaque));
  }
  scene.OpaqueDepth = depth.data();
}

template <class Engine>
void CheckViews(TestChecks& checks, Engine& engine, Engine& all)
{
  TileArrays arrays(1);
  arrays.SetFunction(false, 10.0);
  ConvexTilesFrame::Scene scene;
  scene.Function = arrays.Scene.Function;
  std::vector<float> depth;
  long long hidden = 0;
  for (const View& view : Views())
  {
    SetView(view, depth, scene);
    scene.LeavesOut = false;
    CHECK(all.Render(scene));
    CHECK(all.CountCellsOutside() == 0);
    CHECK(all.GetCounts().HiddenCells == 0);
    scene.LeavesOut = true;
    CHECK(engine.Render(scene));
    const double outside = static_cast<double>(engine.CountCellsOutside()) / (Cells * Cells * Cells);
    std::cout << view.Name << ": " << outside << " of the cells outside, "
              << engine.GetCounts().HiddenCells << " hidden in tiles\n";
    CHECK(outside >= view.Outside);
    CHECK(outside < 1.0);
    CHECK((outside > 0.0) == (view.Outside > 0.0));
    CHECK((engine.GetCounts().HiddenCells > 0) == view.Hides);
    hidden += engine.GetCounts().HiddenCells;
    CHECK(engine.GetImage() == all.GetImage());
    CHECK(*std::max_element(all.GetImage().begin(), all.GetImage().end()) > 0.01f);
    // The camera stays, what hides the cells goes.
    scene.OpaqueDepth = nullptr;
    scene.ClippingPlanes.clear();
    CHECK(engine.Render(scene));
    CHECK(engine.GetCounts().HiddenCells == 0);
    SetView(view, depth, scene);
    CHECK(engine.Render(scene));
    CHECK(engine.GetImage() == all.GetImage());
  }
  CHECK(hidden > 3000);
}

// Clusters of transparent cells have no place on the screen.
template <class Engine>
void CheckDrawn(TestChecks& checks, Engine& engine, const HexahedraArrays& mesh)
{
  TileArrays arrays(1);
  arrays.SetFunction(false, 10.0);
  ConvexTilesFrame::Scene scene;
  scene.Function = arrays.Scene.Function;
  std::vector<float> depth;
  SetView(Views()[0], depth, scene);
  engine.SetDrawn(mesh.Drawn);
  CHECK(engine.Render(scene));
  CHECK(engine.CountCellsSeen() == Cells * Cells * Cells);
  const std::vector<float> image = engine.GetImage();
  // A corner of the mesh.
  std::vector<unsigned int> few;
  std::copy_if(mesh.Drawn.begin(), mesh.Drawn.end(), std::back_inserter(few), [](unsigned int cell)
    { return cell % Cells < 11 && cell / Cells % Cells < 11 && cell / Cells / Cells < 11; });
  engine.SetDrawn(few);
  CHECK(engine.Render(scene));
  CHECK(engine.CountCellsOutside() == 0);
  CHECK(engine.CountCellsSeen() >= static_cast<long long>(few.size()));
  CHECK(engine.CountCellsSeen() < Cells * Cells * Cells / 5);
  CHECK(engine.GetImage() != image);
  engine.SetDrawn(mesh.Drawn);
  CHECK(engine.Render(scene));
  CHECK(engine.GetImage() == image);
}

template <class Engine, class SetScalars>
void CheckEngine(
  TestChecks& checks, Engine& engine, const HexahedraArrays& mesh, const SetScalars& setScalars)
{
  Engine all;
  for (Engine* each : { &engine, &all })
  {
    mesh.SetMesh(*each);
    setScalars(*each);
    each->SetDrawn(mesh.Drawn);
  }
  CheckViews(checks, engine, all);
  CheckDrawn(checks, engine, mesh);
}

void CheckStatistics(TestChecks& checks)
{
  auto grid = TestMeshes::Curvilinear(16);
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::Exact())
  {
    PolyhedraScene scene(mapper.Make(), 80, 72);
    scene.Mapper->SetEngineToTiles();
    scene.SetMesh(grid);
    scene.SetView(0);
    scene.CheckCellsLeftOut(checks, 40.0, grid->GetNumberOfCells());
  }
}

/// Counts what it is handed.
struct CountingEngine
{
  template <class... Arguments>
  void SetMesh(const Arguments&...)
  {
    ++this->Meshes;
  }
  void SetDrawn(const std::vector<unsigned int>&) { ++this->Selections; }
  int Meshes = 0, Scalars = 0, Selections = 0;
};

void CheckChanges(TestChecks& checks)
{
  auto grid = TestMeshes::Curvilinear(2);
  PreparedVolume prepared;
  prepared.TakeCells(grid);
  prepared.Scalars.Values.assign(static_cast<std::size_t>(grid->GetNumberOfPoints()), 0.5f);
  prepared.ScalarsTime.Modified();
  PreparedPolyhedra polyhedra;
  PolyhedraTiles tiles;
  CountingEngine engine;
  auto update = [&](int meshes, int scalars, int selections)
  {
    polyhedra.Prepare(prepared, [](float, float) { return false; }, [](double) {});
    tiles.Update(engine, prepared, polyhedra,
      [&](const std::vector<float>&, bool) { ++engine.Scalars; });
    CHECK(engine.Meshes == meshes && engine.Scalars == scalars && engine.Selections == selections);
  };
  prepared.FunctionTime.Modified();
  update(1, 1, 1);
  update(1, 1, 1);
  prepared.FunctionTime.Modified();
  update(1, 1, 2);
  prepared.ScalarsTime.Modified();
  prepared.FunctionTime.Modified();
  update(1, 2, 3);
  prepared.TakeCells(grid);
  update(2, 3, 4);
}
}

int TestPolyhedraCulling(int, char*[])
{
  TestChecks checks;
  const HexahedraArrays mesh(Cells);
  EmissionTilesEngine emission;
  CheckEngine(checks, emission, mesh,
    [&](EmissionTilesEngine& engine) { engine.SetScalars(mesh.Scalars, false); });
  for (const bool findsLeast : { false, true })
  {
    ExtremumTilesEngine extremum;
    CheckEngine(checks, extremum, mesh,
      [&](ExtremumTilesEngine& engine) { engine.SetScalars(mesh.Scalars, false, findsLeast); });
  }
  CheckStatistics(checks);
  CheckChanges(checks);
  return checks.Result();
}
