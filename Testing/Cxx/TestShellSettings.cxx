// Distances and numbers of samples: the last one set counts, those that make no sense are refused
// by name; the number of samples per shell changes no image; counts are those of the last frame,
// which ends where all is opaque.

#include "TestMeshes.h"
#include "TestScene.h"
#include "vtkBarycentricShellMapper.h"

#include "vtkContourValues.h"

#include <cmath>
#include <limits>

namespace
{
void CheckDistances(TestChecks& checks, TestScene& scene, vtkBarycentricShellMapper* mapper)
{
  mapper->SetSamplesPerRay(100.0);
  scene.Render();
  auto byNumber = scene.CopyCaptured();
  mapper->SetSampleDistance(0.5);
  scene.Render();
  CHECK(TestScene::Difference(byNumber, scene.Mapper->GetCapturedImage()) > 1e-5);
  // The diagonal of the unit cube.
  mapper->SetSampleDistance(std::sqrt(3.0) / 100.0);
  scene.Render();
  CHECK_AT_MOST(TestScene::Difference(byNumber, scene.Mapper->GetCapturedImage()), 1e-6);
  // World lengths: twice the size takes twice the distance.
  mapper->SetSamplesPerRay(100.0);
  scene.Volume->SetScale(2.0);
  scene.Render();
  auto large = scene.CopyCaptured();
  mapper->SetSampleDistance(std::sqrt(3.0) / 50.0);
  scene.Render();
  CHECK_AT_MOST(TestScene::Difference(large, scene.Mapper->GetCapturedImage()), 1e-6);
  scene.Volume->SetScale(1.0);
}

void CheckSamplesPerShell(TestChecks& checks, TestScene& scene, vtkBarycentricShellMapper* mapper)
{
  mapper->SetSamplesPerRay(130.0);
  for (const int integration :
    { vtkBarycentricShellMapper::POINT, vtkBarycentricShellMapper::PRE_INTEGRATED })
  {
    mapper->SetIntegration(integration);
    mapper->SetSamplesPerShell(4);
    scene.Render();
    auto four = scene.CopyCaptured();
    const vtkIdType elements = mapper->GetNumberOfElementsDrawn();
    for (const int samples : { 8, 16 })
    {
      mapper->SetSamplesPerShell(samples);
      scene.Render();
      // Ends of the mesh are kept in steps of 1 / 2047 of a slab.
      const double bound = integration == vtkBarycentricShellMapper::POINT ? 1e-6 : 2e-5;
      CHECK_AT_MOST(TestScene::Difference(four, scene.Mapper->GetCapturedImage()), bound);
      CHECK(mapper->GetNumberOfElementsDrawn() < elements);
    }
  }
}

void CheckRefused(TestChecks& checks, TestScene& scene, vtkBarycentricShellMapper* mapper)
{
  vtkNew<MessageObserver> messages;
  messages->Watch(mapper);
  mapper->SetSampleDistance(0.25);
  for (const double wrong : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    mapper->SetSampleDistance(wrong);
    mapper->SetSamplesPerRay(wrong);
  }
  CHECK(messages->Count() == 6);
  CHECK(mapper->GetSampleDistance() == 0.25);
  mapper->SetSamplesPerShell(5);
  CHECK(messages->CountOf("it is 4, 8 or 16") == 1);
  CHECK(mapper->GetSamplesPerShell() == 16);
  mapper->SetSampleDistance(1e-9);
  scene.Render();
  // Between the nearest and the farthest of the mesh.
  CHECK(messages->CountOf("1e-09 between samples would take 1.") == 1);
  CHECK(messages->CountOf("e+09 slices a frame, more than 65536") == 1);
  CHECK(!mapper->GetCapturedImage());
  mapper->SetSamplesPerRay(200.0);
  scene.Render();
  CHECK(scene.CenterPixel()[3] > 0.1);
  CHECK(messages->Count() == 8);
}

// From inside, where the mesh fills the view, nothing is drawn behind what is opaque everywhere.
void CheckEarlyEnd(TestChecks& checks)
{
  TestScene scene(vtkNew<vtkBarycentricShellMapper>(), 64, 64);
  auto* mapper = vtkBarycentricShellMapper::SafeDownCast(scene.Mapper);
  scene.SetGrid(TestMeshes::JitteredCube(4));
  scene.LookFrom(0.0, 0.0, 0.3);
  scene.SetConstant(1.0);
  scene.Render();
  const int shells = mapper->GetNumberOfShells();
  const vtkIdType elements = mapper->GetNumberOfElementsDrawn();
  scene.SetConstant(100.0);
  scene.Render();
  CHECK_AT_MOST(2 * mapper->GetNumberOfShells(), shells);
  CHECK(mapper->GetNumberOfElementsDrawn() < elements);
  CHECK_NEAR(scene.CenterPixel()[3], 1.0, 1e-4);
}

// What is said of the last frame's shells, where it had none.
void CheckCounts(TestChecks& checks, TestScene& scene, vtkBarycentricShellMapper* mapper)
{
  CHECK(mapper->GetNumberOfElementsDrawn() >= 6);
  CHECK(mapper->GetNumberOfShells() > 1);
  CHECK(mapper->GetTargetBytes() == 4 * 2 * 16 * 64 * 64);
  for (const bool inOrder : { true, false })
  {
    inOrder ? mapper->SetMethodToCellProjection() : mapper->SetBlendModeToIsoSurface();
    scene.Property->GetIsoSurfaceValues()->SetValue(0, 0.5);
    scene.Render();
    CHECK(mapper->GetNumberOfElementsDrawn() == 0);
    CHECK(mapper->GetNumberOfShells() == 0);
    CHECK(mapper->GetTargetBytes() == 0);
  }
}
}

int TestShellSettings(int, char*[])
{
  TestChecks checks;
  TestScene scene(vtkNew<vtkBarycentricShellMapper>(), 64, 64);
  auto* mapper = vtkBarycentricShellMapper::SafeDownCast(scene.Mapper);
  scene.SetGrid(TestMeshes::SixTetrahedra());
  CheckDistances(checks, scene, mapper);
  CheckSamplesPerShell(checks, scene, mapper);
  CheckEarlyEnd(checks);
  CheckRefused(checks, scene, mapper);
  CheckCounts(checks, scene, mapper);
  return checks.Result();
}
