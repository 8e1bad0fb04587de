// An image bound to a mesh: as its texture it is the same picture as its values at the mesh's
// points; a coarse mesh shows all of it, warped where the points have moved; wrong coordinates are
// named.

#include "TestMeshes.h"
#include "TestScene.h"
#include "vtkBarycentricShellMapper.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

namespace
{
void SetCoordinates(vtkUnstructuredGrid* grid, int components)
{
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("coordinates");
  coordinates->SetNumberOfComponents(components);
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    for (int axis = 0; axis < components; ++axis)
    {
      coordinates->InsertNextValue(static_cast<float>(grid->GetPoint(id)[axis] + 0.5));
    }
  }
  grid->GetPointData()->SetTCoords(coordinates);
}

// Waves over the unit cube about the origin.
vtkSmartPointer<vtkImageData> MakeImage(int cells)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(cells + 1, cells + 1, cells + 1);
  image->SetOrigin(-0.5, -0.5, -0.5);
  image->SetSpacing(1.0 / cells, 1.0 / cells, 1.0 / cells);
  vtkNew<vtkFloatArray> values;
  values->SetName("values");
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    values->InsertNextValue(static_cast<float>(TestMeshes::Waves(image->GetPoint(id))));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

void CheckFineMesh(TestChecks& checks, TestScene& scene, vtkBarycentricShellMapper* mapper)
{
  const double size[3] = { 1.0, 1.0, 1.0 };
  const int cells[3] = { 16, 16, 16 };
  auto grid = TestMeshes::Slab(size, cells);
  TestMeshes::SetField(grid, TestMeshes::Waves);
  SetCoordinates(grid, 3);
  scene.SetGrid(grid);
  scene.Render();
  auto byPoints = scene.CopyCaptured();
  mapper->SetVolumeTexture(MakeImage(16));
  scene.Render();
  // The image is linear along its axes, the mesh in its tetrahedra.
  const double difference = TestScene::Difference(byPoints, mapper->GetCapturedImage());
  std::cout << "texture and points differ by " << difference << "\n";
  CHECK(difference > 0.0);
  CHECK_AT_MOST(difference, 1e-2);
}

// Six tetrahedra show an image of 64^3 cells within its own error; moved ones warp it.
void CheckCoarseMesh(TestChecks& checks, TestScene& scene, vtkBarycentricShellMapper* mapper)
{
  const double size[3] = { 1.0, 1.0, 1.0 };
  const int cells[3] = { 32, 32, 32 };
  auto fine = TestMeshes::Slab(size, cells);
  auto coarse = TestMeshes::SixTetrahedra();
  SetCoordinates(coarse, 3);
  coarse->GetPointData()->SetScalars(nullptr);
  mapper->SetVolumeTexture(MakeImage(64));
  for (const double shear : { 0.0, 0.4 })
  {
    vtkNew<vtkPoints> moved;
    for (vtkIdType id = 0; id < coarse->GetNumberOfPoints(); ++id)
    {
      const double* p = coarse->GetPointData()->GetTCoords()->GetTuple3(id);
      moved->InsertNextPoint(p[0] - 0.5 + shear * (p[1] - 0.5), p[1] - 0.5, p[2] - 0.5);
    }
    coarse->SetPoints(moved);
    scene.SetGrid(coarse);
    scene.Render();
    auto textured = scene.CopyCaptured();
    TestMeshes::SetField(fine, [](const double* p)
      { return TestMeshes::Waves(p); });
    for (vtkIdType id = 0; shear > 0.0 && id < fine->GetNumberOfPoints(); ++id)
    {
      double p[3];
      fine->GetPoint(id, p);
      fine->GetPoints()->SetPoint(id, p[0] + shear * p[1], p[1], p[2]);
    }
    mapper->SetVolumeTexture(nullptr);
    scene.SetGrid(fine);
    scene.Render();
    const double difference = TestScene::Difference(textured, mapper->GetCapturedImage());
    std::cout << "sheared by " << shear << ": differs by " << difference << "\n";
    CHECK_AT_MOST(difference, 1e-2);
    mapper->SetVolumeTexture(MakeImage(64));
  }
}

void CheckMessages(TestChecks& checks, TestScene& scene, vtkBarycentricShellMapper* mapper)
{
  vtkNew<MessageObserver> messages;
  messages->Watch(mapper);
  auto grid = TestMeshes::SixTetrahedra();
  scene.SetGrid(grid);
  scene.Render();
  scene.Render();
  CHECK(messages->Count() == 1 && messages->CountOf("coordinates of 0 components") == 1);
  SetCoordinates(grid, 2);
  scene.Render();
  CHECK(messages->Count() == 2 && messages->CountOf("coordinates of 2 components") == 1);
  SetCoordinates(grid, 3);
  vtkNew<vtkImageData> empty;
  mapper->SetVolumeTexture(empty);
  scene.Render();
  CHECK(messages->Count() == 3 && messages->CountOf("no point scalars") == 1);
  mapper->SetVolumeTexture(MakeImage(4));
  mapper->SetBlendModeToIsoSurface();
  scene.Render();
  CHECK(messages->Count() == 4 && messages->CountOf("of a volume texture are not drawn") == 1);
  mapper->SetBlendModeToComposite();
  mapper->SetVolumeTexture(nullptr);
  scene.Render();
  CHECK(messages->Count() == 4);
  CHECK(scene.CenterPixel()[3] > 0.1);
}
}

int TestShellTexture(int, char*[])
{
  TestChecks checks;
  TestScene scene(vtkNew<vtkBarycentricShellMapper>(), 64, 64);
  auto* mapper = vtkBarycentricShellMapper::SafeDownCast(scene.Mapper);
  CheckFineMesh(checks, scene, mapper);
  CheckCoarseMesh(checks, scene, mapper);
  CheckMessages(checks, scene, mapper);
  return checks.Result();
}
