// M4: with the camera inside the mesh every pixel is lit, and exact.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkConvexCells.h"

#include <sstream>

namespace
{
/// From within the mesh, `nearPlane` before the eye.
void CheckNearPlane(TestChecks& checks, TestScene& scene, double nearPlane, double bound)
{
  scene.Renderer->GetActiveCamera()->SetClippingRange(nearPlane, 10.0);
  std::ostringstream name;
  name << "near plane at " << nearPlane;
  const double error = scene.MaximumError(name.str());
  CHECK(error >= 0.0);
  // Parts of a ray keep their order.
  CHECK(scene.GetStatistic("RepairedPixels") <= 16);
  CHECK_AT_MOST(error, bound);
  CHECK(scene.Oracle->GetNumberOfCoveredPixels() == 128 * 128);
  int dark = 0;
  for (int i = 0; i < 128 * 128; ++i)
  {
    dark += scene.Pixel(i % 128, i / 128)[3] > 0.0 ? 0 : 1;
  }
  CHECK(dark == 0);
}
}

int TestCameraInside(int, char*[])
{
  TestChecks checks;
  TestScene scene;
  vtkNew<vtkConvexCells> cut;
  cut->SetInputData(TestMeshes::Curvilinear(5));
  cut->TetrahedraOnlyOn();
  cut->Update();
  scene.SetGrid(cut->GetOutput());
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(0.4, 0.2, 0.1);
  camera->SetPosition(0.05, 0.02, 0.11);
  // Before a plane this near a ray's weight is a thousand million times what it is behind.
  for (const double nearPlane : { 1e-15, 1e-12, 1e-9, 1e-7, 1e-3, 0.1, 0.3 })
  {
    CheckNearPlane(checks, scene, nearPlane, 2e-4);
  }
  // Light is approximated within fragments, the same with any near plane.
  scene.Property->ShadeOn();
  for (const double nearPlane : { 1e-9, 1e-3 })
  {
    CheckNearPlane(checks, scene, nearPlane, 3e-4);
  }
  scene.Property->ShadeOff();
  // The near plane cuts through the mesh that the camera looks at from outside; the far one too.
  scene.LookFrom(0.3, 0.4, 2.0);
  camera->SetClippingRange(1.9, 2.2);
  const double error = scene.MaximumError("near and far plane through the mesh");
  CHECK(error >= 0.0);
  CHECK_AT_MOST(error, 2e-4);
  return checks.Result();
}
