// Coordinates near 1e7 and 1e-7, slivers, lattices seen along their faces, shuffled and inverted
// cells: still within the bound.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkCellType.h"
#include "vtkConvexCells.h"

#include <cmath>

namespace
{
TestMeshes::Grid Cut(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkConvexCells> cut;
  cut->SetInputData(grid);
  cut->TetrahedraOnlyOn();
  cut->Update();
  return cut->GetOutput();
}

void CheckScaled(TestChecks& checks, double offset, double scale)
{
  TestScene scene;
  auto grid = Cut(TestMeshes::Curvilinear(4));
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double p[3];
    grid->GetPoint(id, p);
    grid->GetPoints()->SetPoint(
      id, offset + scale * p[0], offset + scale * p[1], scale * p[2] - offset);
  }
  scene.SetGrid(grid);
  scene.Property->SetScalarOpacityUnitDistance(scale);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(offset, offset, -offset);
  camera->SetPosition(offset + 0.5 * scale, offset + 0.8 * scale, 2.2 * scale - offset);
  camera->SetClippingRange(0.1 * scale, 20.0 * scale);
  const double error = scene.MaximumError(std::to_string(offset) + ", " + std::to_string(scale));
  CHECK(error >= 0.0);
  CHECK_AT_MOST(error, 1e-3);
}

// A lattice seen exactly along its faces and its diagonals: rays run inside thousands of faces.
void CheckLattice(TestChecks& checks)
{
  TestScene scene;
  const double size[3] = { 1.0, 1.0, 1.0 };
  const int cells[3] = { 8, 8, 8 };
  auto slab = TestMeshes::Slab(size, cells);
  TestMeshes::SetField(slab, TestMeshes::Waves);
  scene.SetGrid(Cut(slab));
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(0.5);
  const double directions[4][3] = { { 0, 0, 3 }, { 3, 0, 0 }, { 2, 0, 2 }, { 2, 2, 2 } };
  for (const auto& eye : directions)
  {
    scene.LookFrom(eye[0], eye[1], eye[2]);
    const double error = scene.MaximumError("lattice along its faces");
    CHECK(error >= 0.0);
    CHECK_AT_MOST(error, 1e-3);
  }
}

void CheckSlivers(TestChecks& checks)
{
  for (const double thickness : { 1e-2, 1e-4, 1e-6 })
  {
    TestScene scene;
    auto grid = TestMeshes::SixTetrahedra();
    for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
    {
      double p[3];
      grid->GetPoint(id, p);
      grid->GetPoints()->SetPoint(id, p[0], p[1] * thickness, p[2]);
    }
    scene.SetGrid(grid);
    scene.Property->SetScalarOpacityUnitDistance(thickness);
    scene.LookFrom(0.4, 2.0, 0.7);
    scene.Renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
    const double error = scene.MaximumError("slivers of " + std::to_string(thickness));
    CHECK(error >= 0.0);
    // Mesh coordinates are floats: 6e-8 of the mesh is 6 % of a cell that is 1e-6 of it.
    CHECK_AT_MOST(error, thickness < 1e-5 ? 2e-2 : 1e-3);
  }
}
}

int TestHardCoordinates(int, char*[])
{
  TestChecks checks;
  CheckScaled(checks, 0.0, 1.0);
  CheckScaled(checks, 1e7, 1.0);
  CheckScaled(checks, 1e7, 1e4);
  CheckScaled(checks, 0.0, 1e-7);
  CheckScaled(checks, 0.0, 1e12);
  CheckLattice(checks);
  CheckSlivers(checks);
  return checks.Result();
}
