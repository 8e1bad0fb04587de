// M13: an order is computed again where the eye, the mesh or the sort changed, and only there.

#include "GroupSort.h"
#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkCellArray.h"
#include "vtkConvexCells.h"
#include "vtkMPVOVisibilitySort.h"
#include "vtkPointData.h"

#include <functional>

namespace
{
struct Change
{
  const char* Name;
  int Sorts;
  std::function<void(TestScene&, vtkUnstructuredGrid*)> Apply;
};

std::vector<Change> Changes()
{
  return {
    { "first", 1, [](TestScene&, vtkUnstructuredGrid*) {} },
    { "nothing", 0, [](TestScene&, vtkUnstructuredGrid*) {} },
    { "scalars replaced", 0,
      [](TestScene&, vtkUnstructuredGrid* grid)
      { TestMeshes::SetField(grid, [](const double* p) { return p[0]; }); } },
    { "scalars in place", 0,
      [](TestScene&, vtkUnstructuredGrid* grid)
      {
        grid->GetPointData()->GetScalars()->SetComponent(3, 0, 0.9);
        grid->GetPointData()->GetScalars()->Modified();
      } },
    { "colour", 0, [](TestScene& s, vtkUnstructuredGrid*) { s.Color->AddRGBPoint(.3, 0, 1, 0); } },
    { "opacity", 0, [](TestScene& s, vtkUnstructuredGrid*) { s.Opacity->AddPoint(0.4, 5.0); } },
    { "camera", 1, [](TestScene& s, vtkUnstructuredGrid*) { s.LookFrom(-1.5, 0.7, -1.6); } },
    { "volume moved", 1, [](TestScene& s, vtkUnstructuredGrid*) { s.Volume->RotateY(100.0); } },
    { "points moved", 1,
      [](TestScene&, vtkUnstructuredGrid* grid)
      {
        grid->GetPoints()->SetPoint(6, 0.8, 0.7, 0.6);
        grid->GetPoints()->Modified();
      } },
    { "a cell less", 1,
      [](TestScene&, vtkUnstructuredGrid* grid)
      {
        vtkNew<vtkUnstructuredGrid> copy;
        copy->DeepCopy(grid);
        vtkNew<vtkIdList> ids;
        grid->Reset();
        for (vtkIdType cell = 1; cell < copy->GetNumberOfCells(); ++cell)
        {
          copy->GetCellPoints(cell, ids);
          grid->InsertNextCell(VTK_TETRA, ids);
        }
        grid->Modified();
      } },
    { "the sort itself", 1,
      [](TestScene& s, vtkUnstructuredGrid*)
      { s.GetTetrahedraMapper()->GetVisibilitySort()->Modified(); } },
    { "nothing at last", 0, [](TestScene&, vtkUnstructuredGrid*) {} },
  };
}

// The image is a fresh mapper's all the same.
double DifferenceToFresh(TestScene& scene)
{
  auto kept = scene.CopyCaptured();
  vtkNew<vtkPreIntegratedTetrahedraMapper> fresh;
  vtkNew<GroupSort> sort;
  fresh->SetEngine(scene.Mapper->GetEngine());
  fresh->SetInputData(scene.Mapper->GetInput());
  fresh->SetVisibilitySort(sort);
  fresh->CaptureImageOn();
  scene.Volume->SetMapper(fresh);
  scene.Render();
  scene.Volume->SetMapper(scene.Mapper);
  return TestScene::Difference(kept, fresh->GetCapturedImage());
}

// What the mapper relies on: data that change leave the points and cells of the output alone.
void CheckFilter(TestChecks& checks)
{
  auto grid = TestMeshes::Cube(VTK_WEDGE);
  vtkNew<vtkConvexCells> cells;
  cells->TetrahedraOnlyOn();
  cells->SetInputData(grid);
  cells->Update();
  vtkUnstructuredGrid* output = cells->GetOutput();
  const vtkMTimeType before = output->GetCells()->GetMTime();
  TestMeshes::SetField(grid, [](const double*) { return 0.25; });
  cells->Update();
  CHECK(output->GetCells()->GetMTime() == before);
  CHECK(output->GetNumberOfCells() == 6);
  CHECK_NEAR(output->GetPointData()->GetScalars()->GetTuple1(0), 0.25, 0.0);
  cells->TetrahedraOnlyOff();
  cells->Update();
  CHECK(output->GetCells()->GetMTime() > before);
  CHECK(output->GetNumberOfCells() == 2);
}

// An eye that turns, or moves without crossing the plane of a face, needs no new order.
void CheckEye(TestChecks& checks)
{
  TestScene scene;
  scene.SetGrid(TestMeshes::SixTetrahedra());
  vtkNew<vtkMPVOVisibilitySort> sort;
  scene.GetTetrahedraMapper()->SetVisibilitySort(sort);
  scene.Render();
  auto before = scene.CopyCaptured();
  CHECK(sort->GetNumberOfSorts() == 1);
  scene.Renderer->GetActiveCamera()->Roll(30.0);
  scene.Render();
  scene.Renderer->GetActiveCamera()->Dolly(1.01);
  scene.Render();
  CHECK(TestScene::Difference(before, scene.Mapper->GetCapturedImage()) > 1e-2);
  CHECK(sort->GetNumberOfSorts() == 1);
  scene.LookFrom(-0.5, -0.8, -2.2);
  scene.Render();
  CHECK(sort->GetNumberOfSorts() == 2);
}
}

int TestOrderReuse(int, char*[])
{
  TestChecks checks;
  CheckFilter(checks);
  CheckEye(checks);
  TestScene scene;
  auto grid = TestMeshes::SixTetrahedra();
  scene.SetGrid(grid);
  vtkNew<GroupSort> sort;
  scene.GetTetrahedraMapper()->SetVisibilitySort(sort);
  for (const Change& change : Changes())
  {
    const int before = sort->NumberOfSorts;
    change.Apply(scene, grid);
    scene.Render();
    const int sorts = sort->NumberOfSorts - before;
    checks.Check(sorts == change.Sorts, change.Name, __LINE__, std::to_string(sorts) + " sorts");
    const double difference = DifferenceToFresh(scene);
    checks.Check(difference == 0.0, change.Name, __LINE__, std::to_string(difference));
  }
  return checks.Result();
}
