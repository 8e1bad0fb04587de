// Cells behind pixels that are nearly opaque are left out: most of a dense lattice; the image is the
// oracle's, and but for a millionth that of all cells, on concave meshes and circles, in orders that are
// wrong, with clipping planes and light, and the same bytes for any number of threads.

#include "SortMeshes.h"
#include "TileArrays.h"
#include "TilesScene.h"

#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <numeric>

namespace
{
using Image = std::vector<float>;

double ShareHidden(const TilesEngine& engine)
{
  const TileCounts& counts = engine.GetCounts();
  return static_cast<double>(counts.HiddenCells) / static_cast<double>(counts.Cells);
}

// Rays of an optical depth of 600, 100 and 3; what lies behind depth 16 shows nothing.
void CheckLattice(TestChecks& checks)
{
  TileArrays arrays(24);
  arrays.SetMesh();
  arrays.LookFrom({ 1.5, 2.0, 3.5 }, 32.0, 300, 280);
  const double units[3] = { 0.0025, 0.015, 0.5 };
  const double least[3] = { 0.6, 0.35, 0.0 }, most[3] = { 0.9, 0.9, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    arrays.SetFunction(false, units[i]);
    arrays.Scene.EndsEarly = false;
    CHECK(arrays.Render());
    const Image all = arrays.Engine.GetImage();
    const TileCounts counts = arrays.Engine.GetCounts();
    CHECK(counts.HiddenCells == 0);
    arrays.Scene.EndsEarly = true;
    CHECK(arrays.Render());
    const double hidden = ShareHidden(arrays.Engine);
    std::cout << "unit distance " << units[i] << ": hidden " << hidden << ", fragments "
              << arrays.Engine.GetCounts().Fragments << " of " << counts.Fragments << "\n";
    CHECK_AT_MOST(TileArrays::LargestDifference(arrays.Engine.GetImage(), all), 1e-6);
    CHECK(hidden >= least[i]);
    CHECK(hidden <= most[i]);
    CHECK(arrays.Engine.GetCounts().Cells == counts.Cells);
    CHECK(arrays.Engine.GetCounts().Fragments <= (1.0 - 0.8 * least[i]) * counts.Fragments);
  }
}

void CheckThreads(TestChecks& checks)
{
  TileArrays arrays(12);
  arrays.SetMesh();
  arrays.SetFunction(false, 0.005);
  arrays.LookFrom({ 1.5, 2.0, 3.5 }, 32.0, 200, 180);
  std::vector<Image> images;
  for (const int threads : { 1, 2, 5 })
  {
    vtkSMPTools::Initialize(threads);
    CHECK(arrays.Render());
    CHECK(ShareHidden(arrays.Engine) > 0.3);
    images.push_back(arrays.Engine.GetImage());
    CHECK(images.back() == images.front());
  }
  vtkSMPTools::Initialize(0);
}

// The oracle's image; returns the share of hidden cells.
double CheckScene(TestChecks& checks, TilesScene& scene, const std::string& name)
{
  const double error = scene.TilesError(name);
  CHECK(error >= 0.0);
  CHECK_AT_MOST(error, 1e-4);
  const Image early = scene.Engine.GetImage();
  const double hidden = ShareHidden(scene.Engine);
  std::cout << name << ": hidden " << hidden << "\n";
  scene.EndsEarly = false;
  CHECK(scene.DrawTiles());
  CHECK_AT_MOST(TileArrays::LargestDifference(early, scene.Engine.GetImage()), 1e-6);
  scene.EndsEarly = true;
  return hidden;
}

void CheckMeshes(TestChecks& checks)
{
  TilesScene scene(190, 180);
  for (const bool isRing : { true, false })
  {
    const auto grid = isRing ? SortMeshes::FineRing() : SortMeshes::FineBars();
    SortMeshes::AddScalar(grid);
    scene.SetTetrahedra(grid);
    scene.LookAt(grid, { 0.1, 0.2, 0.97 }, 1.3);
    scene.SetSmooth();
    scene.Property->SetScalarOpacityUnitDistance(0.003 * grid->GetLength());
    CHECK(CheckScene(checks, scene, isRing ? "ring" : "bars") >= (isRing ? 0.03 : 0.0));
  }
}

// In the order of ids pixels are done again: with the cells that others hid.
void CheckAnyOrder(TestChecks& checks)
{
  TilesScene scene(110, 100);
  auto grid = SortMeshes::Kuhn(SortMeshes::JitteredLattice(12, 0.2));
  SortMeshes::AddScalar(grid);
  scene.SetTetrahedra(grid);
  scene.LookAt(grid, { 0.1, 0.2, 0.97 }, 1.3);
  scene.SetSmooth();
  scene.Property->SetScalarOpacityUnitDistance(0.01 * grid->GetLength());
  CHECK(CheckScene(checks, scene, "lattice") > 0.25);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(grid->GetCenter());
  plane->SetNormal(0.6, 0.0, 0.8);
  scene.Mapper->AddClippingPlane(plane);
  CHECK(CheckScene(checks, scene, "clipped") > 0.1);
  scene.Mapper->RemoveAllClippingPlanes();
  scene.BackToFront.resize(static_cast<std::size_t>(grid->GetNumberOfCells()));
  std::iota(scene.BackToFront.begin(), scene.BackToFront.end(), 0);
  CHECK(CheckScene(checks, scene, "in the order of ids") > 0.0);
  CHECK(scene.Engine.GetCounts().RepairedPixels > 1000);
}

// By the mapper, lit.
void CheckLight(TestChecks& checks)
{
  TestScene scene(110, 100);
  auto grid = SortMeshes::Kuhn(SortMeshes::JitteredLattice(8, 0.2));
  SortMeshes::AddScalar(grid);
  scene.SetGrid(grid);
  scene.Mapper->SetEngineToTiles();
  scene.SetSmooth();
  scene.Property->ShadeOn();
  scene.Property->SetSpecular(0.3);
  scene.Property->SetScalarOpacityUnitDistance(0.01 * grid->GetLength());
  const double error = scene.MaximumError("lit");
  CHECK(error >= 0.0);
  CHECK_AT_MOST(error, 1e-4);
}
}

int TestTilesOcclusion(int, char*[])
{
  TestChecks checks;
  CheckLattice(checks);
  CheckThreads(checks);
  CheckMeshes(checks);
  CheckAnyOrder(checks);
  CheckLight(checks);
  return checks.Result();
}
