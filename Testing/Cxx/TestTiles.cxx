// The Tiles engine, with no window: its image against the oracle, at most 1e-4 everywhere; the
// order is that of the tiles, of the mesh given, or any at all.

#include "TestMeshes.h"
#include "TilesScene.h"
#include "vtkUnstructuredGrid.h"

#include <numeric>

namespace
{
void CheckError(TestChecks& checks, TilesScene& scene, const std::string& name)
{
  const double error = scene.TilesError(name);
  CHECK(error >= 0.0);
  CHECK_AT_MOST(error, 1e-4);
}

void CheckViews(TestChecks& checks, TilesScene& scene, const std::string& name)
{
  const double eyes[5][3] = { { 0.5, 0.8, 2.2 }, { -1.9, 0.3, -0.9 }, { 0.0, 0.0, 2.5 },
    { 0.1, 0.05, 0.02 }, { 0.0, 0.0, 0.3 } };
  for (const auto& eye : eyes)
  {
    scene.LookFrom(eye[0], eye[1], eye[2]);
    for (const bool spiky : { false, true })
    {
      spiky ? scene.SetSpiky() : scene.SetSmooth();
      CheckError(checks, scene, name + (spiky ? ", spiky" : ", smooth"));
    }
  }
}

void CheckBothProjections(TestChecks& checks, TilesScene& scene, const std::string& name)
{
  CheckViews(checks, scene, name);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(0.9);
  CheckViews(checks, scene, name + ", parallel");
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
}

// Any order comes out right: every pixel that it draws wrong is repaired.
void CheckAnyOrder(TestChecks& checks, TilesScene& scene)
{
  auto grid = TestMeshes::Delaunay(60);
  scene.SetTetrahedra(grid);
  scene.LookFrom(0.5, 0.8, 2.2);
  scene.SetSpiky();
  CheckError(checks, scene, "in the tiles' order");
  CHECK(scene.Engine.GetCounts().RepairedPixels == 0);
  scene.BackToFront.resize(static_cast<size_t>(grid->GetNumberOfCells()));
  std::iota(scene.BackToFront.begin(), scene.BackToFront.end(), 0);
  CheckError(checks, scene, "in the order of ids");
  CHECK(scene.Engine.GetCounts().RepairedPixels > 1000);
  scene.BackToFront.clear();
  CheckError(checks, scene, "in the tiles' order again");
  CHECK(scene.Engine.GetCounts().RepairedPixels == 0);
}
}

int TestTiles(int, char*[])
{
  TestChecks checks;
  TilesScene scene(100, 90);
  scene.SetTetrahedra(TestMeshes::Tetrahedron());
  CheckBothProjections(checks, scene, "tetrahedron");
  scene.SetTetrahedra(TestMeshes::SixTetrahedra());
  CheckBothProjections(checks, scene, "six tetrahedra");
  scene.SetTetrahedra(TestMeshes::Delaunay(100));
  CheckBothProjections(checks, scene, "Delaunay");
  CheckAnyOrder(checks, scene);
  return checks.Result();
}
