// Functions that leave most cells empty: those cells have no place on the screen, no tile and no order;
// the image is the oracle's on lattices, concave meshes and circles, few pixels are done again, and after
// any other function it is that of a fresh engine to the last byte.

#include "SortMeshes.h"
#include "TilesScene.h"

#include "vtkPiecewiseFunction.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace
{
constexpr int Width = 80, Height = 72;

// Opacity about one scalar alone.
void SetPeak(TilesScene& scene, double middle, double width)
{
  scene.SetSmooth();
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(middle - width, 0.0);
  scene.Opacity->AddPoint(middle, 4.0);
  scene.Opacity->AddPoint(middle + width, 0.0);
}

void LookAt(TilesScene& scene, vtkUnstructuredGrid* grid, const double (&direction)[3])
{
  scene.LookAt(grid, direction, 1.5);
  scene.Property->SetScalarOpacityUnitDistance(0.05 * grid->GetLength());
}

double ShareDrawn(const TilesEngine& engine)
{
  const std::vector<unsigned char>& drawn = engine.GetMesh().Drawn;
  return static_cast<double>(std::count(drawn.begin(), drawn.end(), 1)) / drawn.size();
}

vtkSmartPointer<vtkUnstructuredGrid> Lattice(int cells)
{
  auto grid = SortMeshes::Kuhn(SortMeshes::JitteredLattice(cells, 0.15));
  SortMeshes::AddScalar(grid);
  return grid;
}

void CheckCounts(TestChecks& checks)
{
  auto grid = Lattice(20);
  const auto cells = static_cast<double>(grid->GetNumberOfCells());
  TilesScene scene(Width, Height);
  scene.SetTetrahedra(grid);
  LookAt(scene, grid, { 0.5, 0.6, 0.7 });
  scene.SetSmooth();
  CHECK(scene.DrawTiles());
  CHECK(scene.Engine.CountCellsSeen() == grid->GetNumberOfCells());
  CHECK(scene.Engine.CountCellsInTiles() >= grid->GetNumberOfCells());
  SetPeak(scene, 0.9, 0.04);
  CHECK(scene.DrawTiles());
  const double share = ShareDrawn(scene.Engine);
  const double seen = static_cast<double>(scene.Engine.CountCellsSeen()) / cells;
  std::cout << "drawn " << share << ", in clusters that are seen " << seen << ", in tiles "
            << static_cast<double>(scene.Engine.CountCellsInTiles()) / cells << "\n";
  CHECK(share > 0.01);
  CHECK(seen < 4.0 * share);
  CHECK(scene.Engine.CountCellsInTiles() == scene.Engine.GetCounts().Cells);
  CHECK(scene.Engine.GetCounts().Cells < 2.0 * share * cells);
}

void CheckMesh(TestChecks& checks, vtkUnstructuredGrid* grid, const std::string& name)
{
  TilesScene scene(Width, Height);
  scene.SetTetrahedra(grid);
  const double directions[2][3] = { { 0.1, 0.2, 0.97 }, { 0.1, 0.05, 0.02 } };
  for (const auto& direction : directions)
  {
    LookAt(scene, grid, direction);
    for (const double middle : { 0.45, 0.75 })
    {
      SetPeak(scene, middle, 0.03);
      const double error = scene.TilesError(name);
      CHECK(error >= 0.0);
      CHECK_AT_MOST(error, 1e-4);
      CHECK(ShareDrawn(scene.Engine) < 0.5);
      CHECK_AT_MOST(
        scene.Engine.GetCounts().RepairedPixels, 0.1 * scene.Oracle->GetNumberOfCoveredPixels());
    }
  }
}

// Back and forth, by any number of threads.
void CheckChanges(TestChecks& checks)
{
  auto grid = Lattice(9);
  TilesScene scene(Width, Height);
  scene.SetTetrahedra(grid);
  LookAt(scene, grid, { 0.5, 0.6, 0.7 });
  int threads = 1;
  for (const double middle : { 0.2, 0.8, 0.0, 0.8, 0.2, 0.0, 0.21, 0.2 })
  {
    vtkSMPTools::Initialize(threads);
    threads = threads % 3 + 1;
    TilesScene fresh(Width, Height);
    fresh.SetTetrahedra(grid);
    LookAt(fresh, grid, { 0.5, 0.6, 0.7 });
    for (TilesScene* each : { &scene, &fresh })
    {
      middle > 0.0 ? SetPeak(*each, middle, 0.05) : each->SetSmooth();
      CHECK(each->DrawTiles());
    }
    CHECK((ShareDrawn(scene.Engine) < 0.5) == (middle > 0.0));
    CHECK(fresh.Engine.GetImage() == scene.Engine.GetImage());
  }
  vtkSMPTools::Initialize(0);
}
}

int TestTilesSparse(int, char*[])
{
  TestChecks checks;
  CheckCounts(checks);
  CheckChanges(checks);
  CheckMesh(checks, Lattice(9), "lattice");
  auto ring = SortMeshes::FineRing();
  SortMeshes::AddScalar(ring);
  CheckMesh(checks, ring, "ring");
  auto bars = SortMeshes::FineBars();
  SortMeshes::AddScalar(bars);
  CheckMesh(checks, bars, "bars");
  return checks.Result();
}
