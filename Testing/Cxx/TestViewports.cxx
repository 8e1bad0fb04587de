// M7: every viewport shows the volume, blended where it belongs; two volumes, two windows.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkUnsignedCharArray.h"

namespace
{
// Blue of the window's pixel: the background is blue, the volume hides some of it.
int BlueAt(vtkRenderWindow* window, int x, int y)
{
  vtkNew<vtkUnsignedCharArray> pixel;
  window->GetPixelData(x, y, x, y, 0, pixel);
  return static_cast<int>(pixel->GetComponent(0, 2));
}

void CheckTwoViewports(TestChecks& checks, int samples)
{
  TestScene scene(256, 128);
  scene.Window->SetMultiSamples(samples);
  scene.SetGrid(TestMeshes::SixTetrahedra());
  scene.SetConstant(5.0);
  scene.Color->RemoveAllPoints();
  scene.Color->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  auto second = scene.AddSecondViewport();
  scene.LookFrom(0.5, 0.8, 4.0);
  scene.Renderer->SetBackground(0.0, 0.0, 1.0);
  second->SetBackground(0.0, 0.0, 1.0);
  scene.Window->Render();
  const int* size = scene.Mapper->GetCapturedImage()->GetDimensions();
  CHECK(size[0] == 128 && size[1] == 128);
  for (const int left : { 0, 128 })
  {
    CHECK(BlueAt(scene.Window, left + 64, 64) < 30);
    CHECK(BlueAt(scene.Window, left + 2, 2) == 255);
    CHECK(BlueAt(scene.Window, left + 125, 125) == 255);
  }
  const std::array<double, 4> center = scene.CenterPixel();
  // Premultiplied over the background, whatever was drawn there before.
  CHECK_NEAR(BlueAt(scene.Window, 64, 64) / 255.0, 1.0 - center[3], 1.0 / 255.0);
  CHECK_NEAR(BlueAt(scene.Window, 192, 64) / 255.0, 1.0 - center[3], 1.0 / 255.0);
}

void CheckTwoVolumes(TestChecks& checks)
{
  TestScene scene;
  scene.SetGrid(TestMeshes::SixTetrahedra());
  scene.Renderer->SetBackground(0.0, 0.0, 1.0);
  scene.LookFrom(0.0, 0.0, 6.0);
  vtkNew<vtkPreIntegratedTetrahedraMapper> mapper;
  mapper->SetInputData(TestMeshes::SixTetrahedra());
  vtkNew<vtkVolume> other;
  other->SetMapper(mapper);
  other->SetProperty(scene.Property);
  other->SetPosition(0.0, 1.0, 0.0);
  scene.Volume->SetPosition(0.0, -1.0, 0.0);
  scene.SetConstant(5.0);
  scene.Color->RemoveAllPoints();
  scene.Color->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  scene.Renderer->AddVolume(other);
  scene.Render();
  CHECK(BlueAt(scene.Window, 64, 24) < 60);
  CHECK(BlueAt(scene.Window, 64, 104) < 60);
  CHECK(BlueAt(scene.Window, 64, 64) == 255);
}

// The same mapper in a second window, then again in the first, after resources were released.
void CheckTwoWindows(TestChecks& checks)
{
  TestScene scene;
  scene.SetGrid(TestMeshes::SixTetrahedra());
  scene.Render();
  auto first = scene.CopyCaptured();
  CHECK(scene.CenterPixel()[3] > 0.1);
  {
    vtkNew<vtkRenderer> renderer;
    renderer->SetActiveCamera(scene.Renderer->GetActiveCamera());
    renderer->AddVolume(scene.Volume);
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetSize(128, 128);
    window->AddRenderer(renderer);
    window->Render();
    CHECK(TestScene::Difference(first, scene.Mapper->GetCapturedImage()) == 0.0);
    scene.Render();
    window->Render();
    CHECK(TestScene::Difference(first, scene.Mapper->GetCapturedImage()) == 0.0);
  }
  scene.Render();
  CHECK(TestScene::Difference(first, scene.Mapper->GetCapturedImage()) == 0.0);
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  scene.Render();
  CHECK(TestScene::Difference(first, scene.Mapper->GetCapturedImage()) == 0.0);
}
}

int TestViewports(int, char*[])
{
  TestChecks checks;
  CheckTwoViewports(checks, 0);
  CheckTwoViewports(checks, 4);
  CheckTwoVolumes(checks);
  CheckTwoWindows(checks);
  return checks.Result();
}
