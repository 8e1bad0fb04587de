// The order of cells, holes, cycles and convexity play no role: shuffled cells give the same image
// within rounding, and meshes that cannot be sorted are exact. Views along the faces and diagonals
// of a lattice count no face twice and miss none.

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"
#include "SortMeshes.h"

#include "vtkIdList.h"
#include "vtkPointData.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace
{
using PolyhedraMeshes::Grid;

// The same points, the cells in another order.
Grid WithShuffledCells(vtkUnstructuredGrid* grid, unsigned int seed)
{
  std::vector<vtkIdType> order(grid->GetNumberOfCells());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  auto shuffled = Grid::New();
  shuffled->SetPoints(grid->GetPoints());
  shuffled->GetPointData()->ShallowCopy(grid->GetPointData());
  vtkNew<vtkIdList> ids;
  for (const vtkIdType cell : order)
  {
    grid->GetCellPoints(cell, ids);
    shuffled->InsertNextCell(grid->GetCellType(cell), ids);
  }
  return shuffled;
}

void CheckMesh(TestChecks& checks, const std::string& mesh, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make(), 64, 64);
  Grid grid = SortMeshes::Make(mesh);
  PolyhedraMeshes::FitUnitCube(grid);
  PolyhedraMeshes::SetWaves(grid);
  scene.SetMesh(grid);
  for (const int view : { 0, 1 })
  {
    scene.SetView(view);
    const std::string name = mesh + ", " + mapper.Name + ", view " + std::to_string(view);
    if (mapper.ThreePasses)
    {
      scene.Render();
    }
    else
    {
      scene.CheckWithOracle(checks, name, __LINE__);
    }
    auto ordered = scene.CopyCaptured();
    for (const unsigned int seed : { 1, 2 })
    {
      scene.Mapper->SetInputData(WithShuffledCells(grid, seed));
      scene.Render();
      const double difference = TestScene::Difference(ordered, scene.Mapper->GetCapturedImage());
      // An extremum is the same number; a sum is rounded differently.
      const double bound = scene.IsAdditive() ? 2e-6 : 0.0;
      checks.Check(difference >= 0.0 && difference <= bound, (name + ", shuffled").c_str(),
        __LINE__, std::to_string(1e6 * difference) + "e-6");
      CHECK(scene.GetStatistic("Cycles") == 0 && scene.GetStatistic("MisorderedFaces") == 0);
    }
    scene.Mapper->SetInputData(grid);
  }
}

void CheckLattice(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make());
  Grid grid = SortMeshes::Lattice(8);
  PolyhedraMeshes::FitUnitCube(grid);
  PolyhedraMeshes::SetWaves(grid);
  scene.SetMesh(grid);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  const double eyes[4][3] = { { 0, 0, 3 }, { 3, 0, 0 }, { 2, 0, 2 }, { 2, 2, 2 } };
  for (const auto& eye : eyes)
  {
    for (const double scale : { 0.5, 0.5 * 127.0 / 128.0 })
    {
      // Pixel centres between the lattice's planes, and exactly on them.
      scene.Renderer->GetActiveCamera()->SetParallelScale(scale);
      scene.LookFrom(eye[0], eye[1], eye[2]);
      const PolyhedraScene::Errors errors = scene.CompareWithOracle(mapper.Name + ", lattice");
      CHECK(errors.Compared >= 0.0);
      CHECK_AT_MOST(errors.Compared, scene.GetBound());
    }
  }
}
}

int TestPolyhedraOrder(int, char*[])
{
  TestChecks checks;
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::All())
  {
    for (const char* mesh : { "gears", "torus", "hollowSphere", "slantedGear", "checkerboard",
           "warpedThree", "bars", "missingCell" })
    {
      CheckMesh(checks, mesh, mapper);
    }
    if (!mapper.ThreePasses)
    {
      CheckLattice(checks, mapper);
    }
  }
  return checks.Result();
}
