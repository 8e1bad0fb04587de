// M1: a slab of optical depth 2 has alpha 1 - exp(-2 / cos) at every thickness.

#include "TestMeshes.h"
#include "TestScene.h"

#include <cmath>

namespace
{
// The cosine between the view axis and the ray through the centre of a pixel.
double CosineOfRay(TestScene& scene, int x, int y)
{
  const int* size = scene.Renderer->GetSize();
  const double tangent =
    std::tan(0.5 * scene.Renderer->GetActiveCamera()->GetViewAngle() * std::acos(-1.0) / 180.0);
  const double u = tangent * (2.0 * (x + 0.5) / size[0] - 1.0);
  const double v = tangent * (2.0 * (y + 0.5) / size[1] - 1.0);
  return 1.0 / std::sqrt(1.0 + u * u + v * v);
}
}

int TestThinSlabs(int, char*[])
{
  TestChecks checks;
  TestScene scene;
  scene.LookFrom(0.0, 0.0, 3.0);
  for (double thickness = 1.0; thickness > 1e-5; thickness *= 0.1)
  {
    const double size[3] = { 2.0, 2.0, thickness };
    const int cells[3] = { 4, 4, 1 };
    scene.SetGrid(TestMeshes::Slab(size, cells));
    scene.SetConstant(2.0 / thickness);
    scene.Render();
    for (const int x : { 64, 50, 75, 40 })
    {
      const double expected = 1.0 - std::exp(-2.0 / CosineOfRay(scene, x, 60));
      const std::array<double, 4> pixel = scene.Pixel(x, 60);
      CHECK_NEAR(pixel[3], expected, 1e-4);
      CHECK_NEAR(pixel[0], expected, 1e-4);
    }
  }
  return checks.Result();
}
