// M9: after a change of anything, the next frame is that of a fresh mapper.

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"
#include "TestMeshes.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkProjectedPolyhedraMapper.h"

#include <functional>

namespace
{
double DifferenceToFresh(PolyhedraScene& scene, const PolyhedraMappers::Entry& mapper)
{
  scene.Render();
  auto kept = scene.CopyCaptured();
  vtkSmartPointer<vtkConvexCellMapper> fresh = mapper.Make(), before = scene.Mapper;
  fresh->SetInputData(before->GetInput());
  fresh->SetClippingPlanes(before->GetClippingPlanes());
  fresh->SetScalarMode(before->GetScalarMode());
  fresh->SetBlendMode(before->GetBlendMode());
  fresh->SetEngine(before->GetEngine());
  fresh->SelectScalarArray("other");
  fresh->CaptureImageOn();
  scene.Volume->SetMapper(fresh);
  scene.Render();
  const double difference = TestScene::Difference(kept, fresh->GetCapturedImage());
  scene.Volume->SetMapper(before);
  return difference;
}

struct Change
{
  const char* Name;
  std::function<void(PolyhedraScene&, vtkUnstructuredGrid*)> Apply;
};

vtkSmartPointer<vtkDoubleArray> OtherArray(vtkIdType count)
{
  auto other = vtkSmartPointer<vtkDoubleArray>::New();
  other->SetName("other");
  for (vtkIdType id = 0; id < count; ++id)
  {
    other->InsertNextValue(0.5 * (id % 3));
  }
  return other;
}

std::vector<Change> Changes()
{
  return {
    { "scalars replaced", [](PolyhedraScene&, vtkUnstructuredGrid* grid)
      { TestMeshes::SetField(grid, [](const double* p) { return 0.4 + 0.5 * p[0]; }); } },
    { "scalars written in place",
      [](PolyhedraScene&, vtkUnstructuredGrid* grid)
      {
        grid->GetPointData()->GetScalars()->FillComponent(0, 0.7);
        grid->GetPointData()->GetScalars()->Modified();
      } },
    { "waves",
      [](PolyhedraScene&, vtkUnstructuredGrid* grid) { PolyhedraMeshes::SetWaves(grid); } },
    { "colour",
      [](PolyhedraScene& s, vtkUnstructuredGrid*) { s.Color->AddRGBPoint(0.6, 0, 1, 0); } },
    { "opacity", [](PolyhedraScene& s, vtkUnstructuredGrid*) { s.Opacity->AddPoint(0.6, 0.3); } },
    { "opacity, some cells transparent",
      [](PolyhedraScene& s, vtkUnstructuredGrid*)
      {
        s.Opacity->AddPoint(0.0, 0.0);
        s.Opacity->AddPoint(0.5, 0.0);
      } },
    { "opacity, none transparent",
      [](PolyhedraScene& s, vtkUnstructuredGrid*)
      {
        s.Opacity->RemoveAllPoints();
        s.Opacity->AddPoint(0.0, 0.5);
      } },
    { "points moved",
      [](PolyhedraScene&, vtkUnstructuredGrid* grid)
      {
        grid->GetPoints()->SetPoint(0, -0.7, -0.6, -0.8);
        grid->GetPoints()->SetPoint(26, 0.8, 0.7, 0.6);
        grid->GetPoints()->Modified();
      } },
    { "camera", [](PolyhedraScene& s, vtkUnstructuredGrid*) { s.LookFrom(-1.5, 0.7, -1.6); } },
    { "camera inside", [](PolyhedraScene& s, vtkUnstructuredGrid*) { s.SetView(2); } },
    { "camera outside", [](PolyhedraScene& s, vtkUnstructuredGrid*) { s.SetView(0); } },
    { "volume moved", [](PolyhedraScene& s, vtkUnstructuredGrid*) { s.Volume->RotateY(100.0); } },
    { "clipping plane",
      [](PolyhedraScene& s, vtkUnstructuredGrid*)
      {
        vtkNew<vtkPlaneCollection> planes;
        vtkNew<vtkPlane> plane;
        plane->SetNormal(1.0, 0.2, 0.3);
        planes->AddItem(plane);
        s.Mapper->SetClippingPlanes(planes);
      } },
    { "another array",
      [](PolyhedraScene& s, vtkUnstructuredGrid* grid)
      {
        grid->GetPointData()->AddArray(OtherArray(grid->GetNumberOfPoints()));
        s.Mapper->SetScalarModeToUsePointFieldData();
        s.Mapper->SelectScalarArray("other");
      } },
    { "cell array",
      [](PolyhedraScene& s, vtkUnstructuredGrid* grid)
      {
        grid->GetCellData()->AddArray(OtherArray(grid->GetNumberOfCells()));
        s.Mapper->SetScalarModeToUseCellFieldData();
      } },
    { "point array again", [](PolyhedraScene& s, vtkUnstructuredGrid*)
      { s.Mapper->SetScalarModeToUsePointFieldData(); } },
    { "a cell more",
      [](PolyhedraScene&, vtkUnstructuredGrid* grid)
      {
        const vtkIdType apex = grid->GetPoints()->InsertNextPoint(0.1, 0.2, 1.5);
        const vtkIdType corners[4] = { 18, 19, 21, apex };
        grid->InsertNextCell(VTK_TETRA, 4, corners);
        grid->GetPointData()->GetArray("other")->InsertNextTuple1(1.0);
        grid->GetPointData()->GetScalars()->InsertNextTuple1(1.0);
        grid->Modified();
      } },
  };
}

void CheckModes(TestChecks& checks, PolyhedraScene& scene)
{
  auto before = scene.CopyCaptured();
  if (auto* polyhedra = vtkProjectedPolyhedraMapper::SafeDownCast(scene.Mapper))
  {
    polyhedra->SetPasses(4 - polyhedra->GetPasses());
    scene.Render();
    polyhedra->SetPasses(4 - polyhedra->GetPasses());
  }
  else
  {
    const int mode = scene.Mapper->GetBlendMode();
    scene.Mapper->SetBlendMode(3 - mode);
    scene.Render();
    CHECK(TestScene::Difference(before, scene.Mapper->GetCapturedImage()) > 1e-3);
    scene.Mapper->SetBlendMode(mode);
  }
  scene.Render();
  CHECK(TestScene::Difference(before, scene.Mapper->GetCapturedImage()) == 0.0);
}
}

int TestPolyhedraChanges(int, char*[])
{
  TestChecks checks;
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::All())
  {
    PolyhedraScene scene(mapper.Make(), 96, 96);
    auto grid = PolyhedraMeshes::Hexahedra(2);
    scene.SetMesh(grid);
    scene.Render();
    for (const Change& change : Changes())
    {
      auto before = scene.CopyCaptured();
      change.Apply(scene, grid);
      const double difference = DifferenceToFresh(scene, mapper);
      scene.Render();
      const double effect = TestScene::Difference(before, scene.Mapper->GetCapturedImage());
      const std::string name = mapper.Name + ", " + change.Name;
      std::cout << name << ": changes the image by " << effect << "\n";
      checks.Check(difference == 0.0, name.c_str(), __LINE__, std::to_string(difference));
      checks.Check(effect > 1e-3, "has an effect", __LINE__, name);
    }
    CheckModes(checks, scene);
  }
  return checks.Result();
}
