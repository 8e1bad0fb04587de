// M9: after a change of anything, the next frame is that of a fresh mapper.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <functional>

namespace
{
double DifferenceToFresh(TestScene& scene)
{
  scene.Render();
  auto kept = scene.CopyCaptured();
  vtkNew<vtkPreIntegratedTetrahedraMapper> fresh;
  fresh->SetEngine(scene.Mapper->GetEngine());
  fresh->SetInputData(scene.Mapper->GetInput());
  fresh->SetVisibilitySort(scene.GetTetrahedraMapper()->GetVisibilitySort());
  fresh->SetClippingPlanes(scene.Mapper->GetClippingPlanes());
  fresh->SetScalarMode(scene.Mapper->GetScalarMode());
  fresh->SelectScalarArray("other");
  fresh->CaptureImageOn();
  scene.Volume->SetMapper(fresh);
  scene.Render();
  const double difference = TestScene::Difference(kept, fresh->GetCapturedImage());
  scene.Volume->SetMapper(scene.Mapper);
  return difference;
}

struct Change
{
  const char* Name;
  std::function<void(TestScene&, vtkUnstructuredGrid*)> Apply;
};

std::vector<Change> Changes()
{
  return {
    { "scalars replaced", [](TestScene&, vtkUnstructuredGrid* grid)
      { TestMeshes::SetField(grid, [](const double* p) { return 7.0 * p[0]; }); } },
    { "scalars written in place",
      [](TestScene&, vtkUnstructuredGrid* grid)
      {
        vtkDataArray* scalars = grid->GetPointData()->GetScalars();
        scalars->SetComponent(3, 0, 0.9);
        scalars->Modified();
      } },
    { "colour", [](TestScene& s, vtkUnstructuredGrid*) { s.Color->AddRGBPoint(0.3, 0, 1, 0); } },
    { "opacity", [](TestScene& s, vtkUnstructuredGrid*) { s.Opacity->AddPoint(0.4, 5.0); } },
    { "unit distance",
      [](TestScene& s, vtkUnstructuredGrid*) { s.Property->SetScalarOpacityUnitDistance(0.3); } },
    { "points moved",
      [](TestScene&, vtkUnstructuredGrid* grid)
      {
        grid->GetPoints()->SetPoint(8, 0.1, 0.1, 0.1);
        grid->GetPoints()->SetPoint(6, 0.8, 0.7, 0.6);
        grid->GetPoints()->Modified();
      } },
    { "camera", [](TestScene& s, vtkUnstructuredGrid*) { s.LookFrom(-1.5, 0.7, -1.6); } },
    { "volume moved", [](TestScene& s, vtkUnstructuredGrid*) { s.Volume->RotateY(100.0); } },
    { "another array",
      [](TestScene& s, vtkUnstructuredGrid* grid)
      {
        vtkNew<vtkDoubleArray> other;
        other->SetName("other");
        for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
        {
          other->InsertNextValue(id % 3);
        }
        grid->GetPointData()->AddArray(other);
        s.Mapper->SetScalarModeToUsePointFieldData();
        s.Mapper->SelectScalarArray("other");
      } },
  };
}
}

int TestChanges(int, char*[])
{
  TestChecks checks;
  TestScene scene;
  auto grid = TestMeshes::SixTetrahedra();
  scene.SetGrid(grid);
  scene.Render();
  for (const Change& change : Changes())
  {
    auto before = scene.CopyCaptured();
    change.Apply(scene, grid);
    const double difference = DifferenceToFresh(scene);
    scene.Render();
    const double effect = TestScene::Difference(before, scene.Mapper->GetCapturedImage());
    std::cout << change.Name << ": changes the image by " << effect << "\n";
    checks.Check(difference == 0.0, change.Name, __LINE__, std::to_string(difference));
    checks.Check(effect > 1e-3, "has an effect", __LINE__, change.Name);
  }
  // Another property with an older time stamp is another transfer function all the same.
  vtkNew<vtkVolumeProperty> older;
  auto before = scene.CopyCaptured();
  scene.Color->Modified();
  scene.Render();
  scene.Volume->SetProperty(older);
  older->SetInterpolationTypeToLinear();
  CHECK(DifferenceToFresh(scene) == 0.0);
  scene.Render();
  CHECK(TestScene::Difference(before, scene.Mapper->GetCapturedImage()) > 1e-3);
  return checks.Result();
}
