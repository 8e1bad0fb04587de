// M5: an opaque plane through the cells hides what lies behind it, per pixel; multisampled windows
// too.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <cmath>

namespace
{
// A slanted opaque plane through the middle of the unit cube.
void AddPlane(TestScene& scene)
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-2.0, -2.0, -0.4);
  source->SetPoint1(2.0, -2.0, 0.4);
  source->SetPoint2(-2.0, 2.0, -0.4);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  actor->GetProperty()->LightingOff();
  scene.Renderer->AddActor(actor);
}

// The plane's own depth at the centre of every pixel: z = .2 x on a ray of the parallel view.
vtkSmartPointer<vtkFloatArray> PlaneDepths(TestScene& scene)
{
  const int* size = scene.Renderer->GetSize();
  const double* range = scene.Renderer->GetActiveCamera()->GetClippingRange();
  auto depths = vtkSmartPointer<vtkFloatArray>::New();
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const double worldX = 0.9 * (2.0 * (x + 0.5) / size[0] - 1.0);
      const double distance = 2.0 - 0.2 * worldX;
      depths->InsertNextValue(static_cast<float>((distance - range[0]) / (range[1] - range[0])));
    }
  }
  return depths;
}

void CheckWindow(TestChecks& checks, int samples)
{
  TestScene scene;
  scene.Window->SetMultiSamples(samples);
  scene.SetGrid(TestMeshes::SixTetrahedra());
  AddPlane(scene);
  scene.LookFrom(0.0, 0.0, 2.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.9);
  camera->SetClippingRange(1.0, 3.0);
  scene.Oracle->SetOpaqueDepth(PlaneDepths(scene));
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
