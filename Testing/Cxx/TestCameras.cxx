// Cameras of every kind: sheared, off axis, with a moved window centre, stereo, with a scaled view.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkTransform.h"

#include <cmath>

namespace
{
void CheckScene(TestChecks& checks, TestScene& scene, const std::string& name)
{
  const double error = scene.MaximumError(name);
  checks.Check(error >= 0.0 && error <= 1e-4, name.c_str(), __LINE__, std::to_string(error));
}

void CheckMatrices(TestChecks& checks)
{
  for (const bool parallel : { false, true })
  {
    TestScene scene;
    scene.SetGrid(TestMeshes::SixTetrahedra());
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    const std::string suffix = parallel ? ", parallel" : ", perspective";
    camera->SetWindowCenter(0.4, -0.2);
    CheckScene(checks, scene, "window centre" + suffix);
    camera->SetWindowCenter(0.0, 0.0);
    // One cell: a sort takes the camera's position for the eye, and a sheared view has another.
    scene.SetGrid(TestMeshes::Tetrahedron());
    camera->SetViewShear(0.3, 0.1, 1.0);
    CheckScene(checks, scene, "view shear" + suffix);
  }
}

// Half of the pictures of a stereo pair is no pair: each eye must see the volume.
void CheckStereo(TestChecks& checks)
{
  TestScene scene;
  scene.SetGrid(TestMeshes::SixTetrahedra());
  scene.Window->StereoCapableWindowOn();
  scene.Render();
  auto mono = scene.CopyCaptured();
  scene.Window->SetStereoTypeToLeft();
  scene.Window->StereoRenderOn();
  scene.Render();
  CHECK(scene.CenterPixel()[3] > 0.1);
  const double difference = TestScene::Difference(mono, scene.Mapper->GetCapturedImage());
  CHECK(difference > 1e-3);
}

// World lengths are those before the camera's own transformation.
void CheckScaledView(TestChecks& checks)
{
  TestScene scene;
  const double size[3] = { 1.0, 1.0, 1.0 };
  const int cells[3] = { 2, 2, 2 };
  scene.SetGrid(TestMeshes::Slab(size, cells));
  scene.SetConstant(1.0);
  scene.LookFrom(0.0, 0.0, 2.0);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  vtkNew<vtkTransform> twice;
  twice->Scale(2.0, 2.0, 2.0);
  scene.Renderer->GetActiveCamera()->SetUserViewTransform(twice);
  scene.Render();
  CHECK_NEAR(scene.CenterPixel()[3], 1.0 - std::exp(-1.0), 1e-5);
}
}

int TestCameras(int, char*[])
{
  TestChecks checks;
  CheckMatrices(checks);
  CheckStereo(checks);
  CheckScaledView(checks);
  return checks.Result();
}
