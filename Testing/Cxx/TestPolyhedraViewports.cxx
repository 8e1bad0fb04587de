// M7: every viewport shows the volume, blended where it belongs: emission is added to what is
// behind, an extremum is put over it; two volumes, two windows.

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"

#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace
{
std::array<int, 3> ColorAt(vtkRenderWindow* window, int x, int y)
{
  vtkNew<vtkUnsignedCharArray> pixel;
  window->GetPixelData(x, y, x, y, 0, pixel);
  return { { static_cast<int>(pixel->GetComponent(0, 0)),
    static_cast<int>(pixel->GetComponent(0, 1)), static_cast<int>(pixel->GetComponent(0, 2)) } };
}

void SetHalfOpaqueRed(PolyhedraScene& scene)
{
  scene.Color->RemoveAllPoints();
  scene.Color->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.4);
}

// Red of the captured image, blue of what it leaves of the background.
void CheckPixel(TestChecks& checks, PolyhedraScene& scene, int left, int line)
{
  const std::array<double, 4> center = scene.CenterPixel();
  const std::array<int, 3> shown = ColorAt(scene.Window, left + 64, 64);
  checks.Check(center[0] > 0.3 && (center[3] == 0.0) == scene.IsAdditive(), "drawn", line,
    std::to_string(center[0]) + " " + std::to_string(center[3]));
  const double red = std::min(1.0, center[0]), blue = 1.0 - center[3];
  checks.Check(std::abs(shown[0] / 255.0 - red) <= 1.0 / 255.0, "red", line,
    std::to_string(shown[0]) + " for " + std::to_string(255.0 * red));
  checks.Check(std::abs(shown[2] / 255.0 - blue) <= 1.0 / 255.0, "blue", line,
    std::to_string(shown[2]) + " for " + std::to_string(255.0 * blue));
}

void CheckTwoViewports(TestChecks& checks, const PolyhedraMappers::Entry& mapper, int samples)
{
  PolyhedraScene scene(mapper.Make(), 256, 128);
  scene.Window->SetMultiSamples(samples);
  scene.SetMesh(PolyhedraMeshes::Hexahedra(3));
  SetHalfOpaqueRed(scene);
  auto second = scene.AddSecondViewport();
  scene.LookFrom(0.5, 0.8, 4.0);
  scene.Renderer->SetBackground(0.0, 0.0, 1.0);
  second->SetBackground(0.0, 0.0, 1.0);
  scene.Window->Render();
  const int* size = scene.Mapper->GetCapturedImage()->GetDimensions();
  CHECK(size[0] == 128 && size[1] == 128);
  for (const int left : { 0, 128 })
  {
    CheckPixel(checks, scene, left, __LINE__);
    CHECK(ColorAt(scene.Window, left + 2, 2)[2] == 255);
    CHECK(ColorAt(scene.Window, left + 125, 125)[0] == 0);
  }
}

void CheckTwoVolumes(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make());
  scene.SetMesh(PolyhedraMeshes::Hexahedra(2));
  SetHalfOpaqueRed(scene);
  scene.Renderer->SetBackground(0.0, 0.0, 1.0);
  scene.LookFrom(0.0, 0.0, 6.0);
  vtkSmartPointer<vtkConvexCellMapper> otherMapper = mapper.Make();
  otherMapper->SetInputData(PolyhedraMeshes::Hexahedra(3));
  vtkNew<vtkVolume> other;
  other->SetMapper(otherMapper);
  other->SetProperty(scene.Property);
  other->SetPosition(0.0, 1.0, 0.0);
  scene.Volume->SetPosition(0.0, -1.0, 0.0);
  scene.Renderer->AddVolume(other);
  scene.Render();
  CHECK(ColorAt(scene.Window, 64, 24)[0] > 60);
  CHECK(ColorAt(scene.Window, 64, 104)[0] > 60);
  CHECK(ColorAt(scene.Window, 64, 64)[0] == 0);
  CHECK(ColorAt(scene.Window, 64, 64)[2] == 255);
}

// The same mapper in a second window of another size, then again in the first, then after its
// resources were released.
void CheckTwoWindows(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make());
  scene.SetMesh(PolyhedraMeshes::Hexahedra(3));
  scene.SetView(2);
  scene.Render();
  auto first = scene.CopyCaptured();
  CHECK(scene.CountLitPixels() == 128 * 128);
  {
    vtkNew<vtkRenderer> renderer;
    renderer->SetActiveCamera(scene.Renderer->GetActiveCamera());
    renderer->AddVolume(scene.Volume);
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetSize(150, 100);
    window->AddRenderer(renderer);
    window->Render();
    CHECK(scene.Mapper->GetCapturedImage()->GetDimensions()[0] == 150);
    CHECK(scene.CountLitPixels() == 150 * 100);
    scene.Render();
    CHECK(TestScene::Difference(first, scene.Mapper->GetCapturedImage()) == 0.0);
    window->Render();
  }
  scene.Render();
  CHECK(TestScene::Difference(first, scene.Mapper->GetCapturedImage()) == 0.0);
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  scene.Render();
  CHECK(TestScene::Difference(first, scene.Mapper->GetCapturedImage()) == 0.0);
}
}

int TestPolyhedraViewports(int, char*[])
{
  TestChecks checks;
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::All())
  {
    CheckTwoViewports(checks, mapper, 0);
    CheckTwoViewports(checks, mapper, 4);
    CheckTwoVolumes(checks, mapper);
    CheckTwoWindows(checks, mapper);
  }
  return checks.Result();
}
