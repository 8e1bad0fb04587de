// No seam and no double sample: a slab of constant scalar has alpha 1 - exp(-tau n dz), n the
// slices inside; a cube of many cells is the same image as a cube of six.

#include "TestMeshes.h"
#include "TestScene.h"
#include "vtkBarycentricShellMapper.h"

#include <cmath>

namespace
{
constexpr double Thickness = 0.7;
constexpr double EyeDistance = 3.0;
constexpr double Extinction = 1.5;
constexpr double Spacing = 0.0123;

// World length of the ray through a pixel's centre per depth along the view axis.
double LengthPerDepth(TestScene& scene, int x, int y)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  if (camera->GetParallelProjection())
  {
    return 1.0;
  }
  const int* size = scene.Renderer->GetSize();
  const double tangent = std::tan(0.5 * camera->GetViewAngle() * std::acos(-1.0) / 180.0);
  const double u = tangent * (2.0 * (x + 0.5) / size[0] - 1.0);
  const double v = tangent * (2.0 * (y + 0.5) / size[1] - 1.0);
  return std::sqrt(1.0 + u * u + v * v);
}

// Every pixel but those of which an end is within rounding of a slice.
void CheckPixels(TestChecks& checks, TestScene& scene)
{
  int compared = 0;
  for (int y = 0; y < 64; y += 3)
  {
    for (int x = 0; x < 64; ++x)
    {
      const double length = LengthPerDepth(scene, x, y);
      const double begin = (EyeDistance - 0.5 * Thickness) * length / Spacing;
      const double end = (EyeDistance + 0.5 * Thickness) * length / Spacing;
      const double nearest =
        std::min(std::abs(begin - std::round(begin)), std::abs(end - std::round(end)));
      if (nearest > 0.01)
      {
        const double slices = std::floor(end) - std::floor(begin);
        CHECK_NEAR(scene.Pixel(x, y)[3], 1.0 - std::exp(-Extinction * slices * Spacing), 1e-5);
        ++compared;
      }
    }
  }
  CHECK_AT_MOST(1000, compared);
}

void CheckCube(TestChecks& checks, TestScene& scene)
{
  auto few = TestMeshes::SixTetrahedra();
  TestMeshes::SetField(few, [](const double*) { return 1.0; });
  scene.SetGrid(few);
  scene.LookFrom(1.1, 1.3, 1.9);
  scene.Render();
  auto six = scene.CopyCaptured();
  auto many = TestMeshes::JitteredCube(7);
  TestMeshes::SetField(many, [](const double*) { return 1.0; });
  scene.SetGrid(many);
  scene.Render();
  CHECK(scene.CenterPixel()[3] > 0.5);
  // At the hull a sample is in or out by the last digit of a float.
  const int different = TestScene::CountDifferent(six, scene.Mapper->GetCapturedImage(), 1e-5);
  CHECK_AT_MOST(different, 4);
}
}

int TestShellSlices(int, char*[])
{
  TestChecks checks;
  TestScene scene(vtkNew<vtkBarycentricShellMapper>(), 64, 64);
  auto* mapper = vtkBarycentricShellMapper::SafeDownCast(scene.Mapper);
  mapper->SetIntegrationToPoint();
  mapper->SetSampleDistance(Spacing);
  scene.SetConstant(Extinction);
  scene.LookFrom(0.0, 0.0, EyeDistance);
  const double size[3] = { 4.0, 4.0, Thickness };
  const int cells[3] = { 9, 9, 3 };
  scene.SetGrid(TestMeshes::Slab(size, cells));
  for (const bool parallel : { false, true })
  {
    scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    for (const int samples : { 4, 8, 16 })
    {
      mapper->SetSamplesPerShell(samples);
      scene.Render();
      CheckPixels(checks, scene);
    }
  }
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
  CheckCube(checks, scene);
  return checks.Result();
}
