// Cell projection by the barycentric stages: exact where the order is right, thin slabs keep their
// opacity (M1), moved points are ordered anew, and cells that hide each other in a circle are put in
// order per pixel.

#include "GroupSort.h"
#include "PolyhedraMeshes.h"
#include "SortMeshes.h"
#include "TestMeshes.h"
#include "TestScene.h"
#include "vtkBarycentricShellMapper.h"
#include "vtkConvexCells.h"

#include "vtkTable.h"
#include "vtkVariant.h"

#include <cmath>

namespace
{
void CheckExact(TestChecks& checks, TestScene& scene, const std::string& name)
{
  const double error = scene.MaximumError(name);
  CHECK(error >= 0.0);
  CHECK_AT_MOST(error, 2e-4);
}

void CheckViews(TestChecks& checks, TestScene& scene)
{
  vtkNew<vtkConvexCells> cut;
  cut->SetInputData(TestMeshes::JitteredCube(4));
  cut->TetrahedraOnlyOn();
  cut->Update();
  scene.SetGrid(cut->GetOutput());
  for (const bool spiky : { false, true })
  {
    spiky ? scene.SetSpiky() : scene.SetSmooth();
    scene.LookFrom(0.5, 0.8, 2.2);
    CheckExact(checks, scene, "outside");
    scene.LookFrom(0.1, 0.05, 0.15);
    CheckExact(checks, scene, "inside");
  }
  CHECK(scene.Mapper->GetLastStatistics()->GetValueByName(0, "Method").ToString() ==
        "BarycentricCellProjection");
}

void CheckThinSlabs(TestChecks& checks, TestScene& scene)
{
  scene.LookFrom(0.0, 0.0, 3.0);
  for (double thickness = 1.0; thickness > 1e-5; thickness *= 0.1)
  {
    const double size[3] = { 2.0, 2.0, thickness };
    const int cells[3] = { 4, 4, 1 };
    scene.SetGrid(TestMeshes::Slab(size, cells));
    scene.SetConstant(2.0 / thickness);
    scene.Render();
    const double tangent = std::tan(0.5 * 30.0 * std::acos(-1.0) / 180.0) / 64.0;
    CHECK_NEAR(scene.CenterPixel()[3],
      1.0 - std::exp(-2.0 * std::sqrt(1.0 + 2.0 * tangent * tangent)), 1e-4);
  }
}

// Half a turn of the points while the camera stays.
void CheckMoved(TestChecks& checks, TestScene& scene)
{
  auto grid = TestMeshes::SixTetrahedra();
  scene.SetGrid(grid);
  scene.SetSpiky();
  scene.LookFrom(0.5, 0.8, 2.2);
  CheckExact(checks, scene, "before");
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double p[3];
    grid->GetPoint(id, p);
    grid->GetPoints()->SetPoint(id, -p[0], p[1], -p[2]);
  }
  grid->GetPoints()->Modified();
  CheckExact(checks, scene, "after");
}

// The meshes whose cells do hide each other, from where they do.
void CheckTangles(TestChecks& checks, TestScene& scene)
{
  scene.SetSmooth();
  int tangles = 0;
  for (const SortMeshes::Entry& entry : SortMeshes::All())
  {
    if (!entry.Tangle)
    {
      continue;
    }
    auto grid = entry.Make();
    PolyhedraMeshes::FitUnitCube(grid);
    TestMeshes::SetField(grid, TestMeshes::Waves);
    vtkNew<vtkConvexCells> cut;
    cut->SetInputData(grid);
    cut->TetrahedraOnlyOn();
    cut->Update();
    scene.SetGrid(cut->GetOutput());
    scene.LookFrom(0.0, 0.0, 3.0);
    CheckExact(checks, scene, entry.Name);
    const int cycles = scene.Mapper->GetLastStatistics()->GetValueByName(0, "Cycles").ToInt();
    checks.Check(cycles > 0, entry.Name.c_str(), __LINE__);
    ++tangles;
  }
  CHECK(tangles > 0);
}

// No order at all: every cell is in one group, shuffled.
void CheckGroup(TestChecks& checks, TestScene& scene)
{
  vtkNew<GroupSort> group;
  vtkBarycentricShellMapper::SafeDownCast(scene.Mapper)->SetVisibilitySort(group);
  scene.SetGrid(TestMeshes::Delaunay(60));
  for (const bool spiky : { false, true })
  {
    spiky ? scene.SetSpiky() : scene.SetSmooth();
    scene.LookFrom(0.5, 0.8, 2.2);
    CheckExact(checks, scene, "one group");
    scene.LookFrom(0.1, 0.05, 0.15);
    CheckExact(checks, scene, "one group, from inside");
  }
}
}

int TestShellProjection(int, char*[])
{
  TestChecks checks;
  TestScene scene(vtkNew<vtkBarycentricShellMapper>(), 64, 64);
  auto* mapper = vtkBarycentricShellMapper::SafeDownCast(scene.Mapper);
  mapper->SetMethodToCellProjection();
  CheckViews(checks, scene);
  CheckThinSlabs(checks, scene);
  CheckMoved(checks, scene);
  CheckTangles(checks, scene);
  CheckGroup(checks, scene);
  return checks.Result();
}
