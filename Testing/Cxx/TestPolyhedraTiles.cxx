// The Tiles engine for convex cells with every instruction set that this machine has, within the
// bounds of each mapper; the same bytes for any number of threads and as after another view; the
// same image as Raster's.

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"
#include "TestMeshes.h"

#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include <hwy/targets.h>

namespace
{
void CheckTargets(TestChecks& checks, PolyhedraScene& scene, const std::string& name)
{
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    hwy::GetChosenTarget().Update(target);
    scene.CheckWithOracle(checks, name + ", " + hwy::TargetName(target), __LINE__);
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

void CheckThreads(TestChecks& checks, PolyhedraScene& scene)
{
  vtkSMPTools::Initialize(1);
  scene.SetView(0);
  scene.Render();
  auto image = scene.CopyCaptured();
  for (const int threads : { 1, 2, 3, 7 })
  {
    vtkSMPTools::Initialize(threads);
    // Moved and back: nothing of the frame before is used again.
    scene.SetView(1);
    scene.Render();
    CHECK(TestScene::Difference(image, scene.Mapper->GetCapturedImage()) > 0.01);
    scene.SetView(0);
    scene.Render();
    CHECK(TestScene::Difference(image, scene.Mapper->GetCapturedImage()) == 0.0);
  }
  vtkSMPTools::Initialize(0);
}

void CheckRaster(TestChecks& checks, PolyhedraScene& scene)
{
  scene.SetView(0);
  scene.Render();
  auto tiles = scene.CopyCaptured();
  CHECK(scene.Mapper->GetLastStatistics()->GetValueByName(0, "Engine").ToString() == "Tiles");
  scene.Mapper->SetEngineToRaster();
  scene.Render();
  CHECK(scene.Mapper->GetLastStatistics()->GetValueByName(0, "Engine").ToString() == "Raster");
  const double bound = 2.0 * scene.GetBound();
  // Pixels at silhouettes belong to either.
  CHECK_AT_MOST(TestScene::CountDifferent(tiles, scene.Mapper->GetCapturedImage(), bound), 5);
  scene.Mapper->SetEngineToTiles();
}

// A cube as a polyhedron that names the first `named` of its corners; its faces name all of them.
PolyhedraMeshes::Grid Cube(vtkIdType named)
{
  auto grid = PolyhedraMeshes::Grid::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("scalar");
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2) - 0.5);
    scalars->InsertNextValue(i / 7.0);
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(scalars);
  const vtkIdType corners[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  const vtkIdType faces[30] = { 4, 0, 4, 6, 2, 4, 1, 3, 7, 5, 4, 0, 1, 5, 4, 4, 2, 6, 7, 3, 4, 0, 2, 3, 1, 4, 4, 5, 7,
    6 };
  grid->InsertNextCell(VTK_POLYHEDRON, named, corners, 6, faces);
  return grid;
}

// It is drawn as if it named them all, or left out and said so: never another picture.
void CheckUnnamedCorner(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make(), 80, 72);
  scene.Mapper->SetEngineToTiles();
  scene.SetMesh(Cube(8));
  scene.SetView(0);
  scene.Render();
  auto image = scene.CopyCaptured();
  scene.SetMesh(Cube(7));
  scene.SetView(0);
  scene.Render();
  const double drawn = scene.Mapper->GetLastStatistics()->GetValueByName(0, "CellsDrawn").ToDouble();
  const double difference = TestScene::Difference(image, scene.Mapper->GetCapturedImage());
  std::cout << mapper.Name << ", a corner that is not named: drawn " << drawn << ", difference " << difference << "\n";
  CHECK(drawn > 0.0 ? difference < scene.GetBound() : scene.CountLitPixels() == 0);
}
}

int TestPolyhedraTiles(int, char*[])
{
  TestChecks checks;
  // Others take no more threads than there are cores.
  vtkSMPTools::SetBackend("STDThread");
  auto curvilinear = TestMeshes::Curvilinear(4);
  PolyhedraMeshes::SetWaves(curvilinear);
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::Exact())
  {
    PolyhedraScene scene(mapper.Make(), 80, 72);
    scene.Mapper->SetEngineToTiles();
    scene.SetMesh(curvilinear);
    CheckThreads(checks, scene);
    CheckTargets(checks, scene, mapper.Name);
    CheckRaster(checks, scene);
    CheckUnnamedCorner(checks, mapper);
  }
  return checks.Result();
}
