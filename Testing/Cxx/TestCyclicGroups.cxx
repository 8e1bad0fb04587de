// MPVO-C: cells that no order satisfies are put in order per pixel. Here none is sorted: all cells
// of a mesh are one group, and the image is the oracle's all the same.

#include "GroupSort.h"
#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkActor.h"
#include "vtkConvexCells.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"

namespace
{
void CheckImage(TestChecks& checks, TestScene& scene, const std::string& name)
{
  const double error = scene.MaximumError(name);
  checks.Check(error >= 0.0, "drawn", __LINE__, name);
  checks.Check(error <= 2e-4, "exact", __LINE__, name + " " + std::to_string(error));
}

void CheckEyes(TestChecks& checks, TestScene& scene, const std::string& name)
{
  const double eyes[4][3] = { { 0.5, 0.8, 2.2 }, { -1.4, 0.3, -0.9 }, { 0.1, 0.05, 0.2 },
    { 0.0, 0.0, 2.5 } };
  for (const auto& eye : eyes)
  {
    scene.LookFrom(eye[0], eye[1], eye[2]);
    for (const bool spiky : { false, true })
    {
      spiky ? scene.SetSpiky() : scene.SetSmooth();
      CheckImage(checks, scene, name + " from " + std::to_string(eye[0]));
    }
  }
  scene.SetSmooth();
  scene.LookFrom(0.5, 0.8, 2.2);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  CheckImage(checks, scene, name + ", parallel");
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
}

void CheckClipped(TestChecks& checks, TestScene& scene, const std::string& name)
{
  vtkNew<vtkPlaneCollection> planes;
  const double numbers[2][6] = { { 0.1, 0.0, 0.0, 1.0, 0.3, 0.2 },
    { 0.0, 0.0, 0.2, 0.2, 0.1, -2.0 } };
  for (const auto& number : numbers)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(number);
    plane->SetNormal(number + 3);
    planes->AddItem(plane);
  }
  scene.Mapper->SetClippingPlanes(planes);
  scene.Oracle->SetClippingPlanes(planes);
  CheckImage(checks, scene, name + ", clipped");
  scene.Renderer->GetActiveCamera()->SetClippingRange(2.2, 2.5);
  CheckImage(checks, scene, name + ", near and far plane inside");
  planes->RemoveAllItems();
  scene.Renderer->GetActiveCamera()->SetClippingRange(0.1, 20.0);
}

void CheckMesh(TestChecks& checks, vtkUnstructuredGrid* grid, const std::string& name)
{
  TestScene scene(64, 64);
  vtkNew<GroupSort> sort;
  scene.GetTetrahedraMapper()->SetVisibilitySort(sort);
  scene.SetGrid(grid);
  CheckEyes(checks, scene, name);
  CheckClipped(checks, scene, name);
}
}

int TestCyclicGroups(int, char*[])
{
  TestChecks checks;
  const double size[3] = { 1.0, 1.0, 1.0 };
  const int cells[3] = { 3, 3, 3 };
  auto lattice = TestMeshes::Slab(size, cells);
  TestMeshes::SetField(lattice, TestMeshes::Waves);
  vtkNew<vtkConvexCells> cut;
  cut->SetInputData(lattice);
  cut->TetrahedraOnlyOn();
  cut->Update();
  CheckMesh(checks, cut->GetOutput(), "lattice");
  CheckMesh(checks, TestMeshes::Delaunay(200), "Delaunay");
  return checks.Result();
}
