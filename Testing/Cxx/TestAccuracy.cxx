// The captured float image against the oracle where the order is right: at most 2e-4 everywhere
// (asked: 1e-3).

#include "FaceOrderSort.h"
#include "TestMeshes.h"
#include "TestScene.h"
#include "vtkConvexCells.h"

#include "vtkCellType.h"
#include "vtkTransform.h"

namespace
{
void CheckViews(TestChecks& checks, TestScene& scene, const std::string& name)
{
  const double eyes[3][3] = { { 0.5, 0.8, 2.2 }, { -1.9, 0.3, -0.9 }, { 0.0, 0.0, 2.5 } };
  for (const auto& eye : eyes)
  {
    scene.LookFrom(eye[0], eye[1], eye[2]);
    for (const bool spiky : { false, true })
    {
      spiky ? scene.SetSpiky() : scene.SetSmooth();
      const double error = scene.MaximumError(name + (spiky ? ", spiky" : ", smooth"));
      CHECK(error >= 0.0);
      CHECK_AT_MOST(error, 2e-4);
    }
  }
}

void CheckParallel(TestChecks& checks, TestScene& scene, const std::string& name)
{
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(0.9);
  CheckViews(checks, scene, name + ", parallel");
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
}

vtkSmartPointer<vtkUnstructuredGrid> CutSlab(double thickness)
{
  const double size[3] = { 1.0, 1.0, thickness };
  const int cells[3] = { 8, 8, 2 };
  auto slab = TestMeshes::Slab(size, cells);
  TestMeshes::SetField(slab, TestMeshes::Waves);
  // The oracle sees the tetrahedra that are drawn: in a hexahedron its scalar is another one.
  vtkNew<vtkConvexCells> cut;
  cut->SetInputData(slab);
  cut->TetrahedraOnlyOn();
  cut->Update();
  return cut->GetOutput();
}

// Rays along faces that nothing but rounding tilts: which cell comes first must not hang on it.
void CheckTurned(TestChecks& checks, vtkUnstructuredGrid* grid, const std::string& name)
{
  vtkNew<vtkTransform> turn;
  turn->RotateWXYZ(37.0, 0.3, 0.8, -0.5);
  vtkNew<vtkPoints> turned;
  turned->SetDataTypeToDouble();
  turn->TransformPoints(grid->GetPoints(), turned);
  grid->SetPoints(turned);
  TestScene scene;
  scene.SetGrid(grid);
  scene.SetSpiky();
  for (const double distance : { 1.3, 2.0, 2.5, 3.1 })
  {
    scene.LookFrom(0.0, 0.0, distance);
    scene.Renderer->GetActiveCamera()->SetViewUp(0.0, 1.0, 0.0);
    scene.Renderer->GetActiveCamera()->ApplyTransform(turn);
    const double error = scene.MaximumError(name + ", turned");
    CHECK(error >= 0.0);
    CHECK_AT_MOST(error, 2e-4);
  }
}
}

int TestAccuracy(int, char*[])
{
  TestChecks checks;
  TestScene scene;
  CheckTurned(checks, TestMeshes::SixTetrahedra(), "six tetrahedra");
  CheckTurned(checks, CutSlab(0.5), "slab");
  scene.SetGrid(TestMeshes::Tetrahedron());
  CheckViews(checks, scene, "tetrahedron");
  CheckParallel(checks, scene, "tetrahedron");
  scene.SetGrid(TestMeshes::SixTetrahedra());
  CheckViews(checks, scene, "six tetrahedra");
  CheckParallel(checks, scene, "six tetrahedra");
  for (const double thickness : { 0.5, 0.05, 0.005 })
  {
    scene.SetGrid(CutSlab(thickness));
    CheckViews(checks, scene, "slab of " + std::to_string(thickness));
  }
  return checks.Result();
}
