// M5: an opaque plane through the cells hides what lies behind it, per pixel; multisampled windows
// too.

#include "OpaquePlane.h"
#include "TestMeshes.h"
#include "TestScene.h"


#include <cmath>

namespace
{
void CheckWindow(TestChecks& checks, int samples)
{
  TestScene scene;
  scene.Window->SetMultiSamples(samples);
  scene.SetGrid(TestMeshes::SixTetrahedra());
  OpaquePlane::AddSlanted(scene);
  scene.LookFrom(0.0, 0.0, 2.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.9);
  camera->SetClippingRange(1.0, 3.0);
  scene.Oracle->SetOpaqueDepth(OpaquePlane::DepthsOfSlanted(scene));
  const double error = scene.MaximumError("plane, samples " + std::to_string(samples));
  CHECK(error >= 0.0);
  // A sample of a multisampled pixel lies up to half a pixel away: .0014 of depth here.
  CHECK_AT_MOST(error, samples > 1 ? 5e-3 : 1e-3);

  // Half of a constant cube is before the plane on the ray through its centre.
  scene.SetConstant(1.0);
  scene.Render();
  CHECK_NEAR(
    scene.CenterPixel()[3], 1.0 - std::exp(-0.5 + 0.2 * 0.9 / 128.0), samples > 1 ? 2e-3 : 1e-4);
}
}

int TestOpaqueGeometry(int, char*[])
{
  TestChecks checks;
  CheckWindow(checks, 0);
  CheckWindow(checks, 4);
  return checks.Result();
}
