// M1: a slab of hexahedra emits kappa tau L / cos at every thickness; its scalar's extrema do not
// depend on it.

#include "PolyhedraScene.h"
#include "TestMeshes.h"

#include <cmath>

namespace
{
double InverseCosineOfRay(TestScene& scene, int x, int y)
{
  const int* size = scene.Renderer->GetSize();
  const double tangent =
    std::tan(0.5 * scene.Renderer->GetActiveCamera()->GetViewAngle() * std::acos(-1.0) / 180.0);
  const double u = tangent * (2.0 * (x + 0.5) / size[0] - 1.0);
  const double v = tangent * (2.0 * (y + 0.5) / size[1] - 1.0);
  return std::sqrt(1.0 + u * u + v * v);
}

TestMeshes::Grid Slab(double thickness)
{
  const double size[3] = { 2.0, 2.0, thickness };
  const int cells[3] = { 4, 4, 1 };
  return TestMeshes::Slab(size, cells);
}

void CheckEmission(TestChecks& checks, const PolyhedraMappers::Entry& mapper, double thickness)
{
  PolyhedraScene scene(mapper.Make());
  scene.LookFrom(0.0, 0.0, 3.0);
  scene.SetMesh(Slab(thickness));
  scene.SetConstant(2.0 / thickness);
  scene.Render();
  // Three passes keep a length as a share of the cell's diameter (.71) in a float: three roundings.
  const double rounding = mapper.ThreePasses ? 3.0 * std::ldexp(1.0, -24) * 0.71 / thickness : 0.0;
  for (const int x : { 64, 50, 75, 40 })
  {
    const double expected = 2.0 * InverseCosineOfRay(scene, x, 60);
    const std::array<double, 4> pixel = scene.Pixel(x, 60);
    CHECK_NEAR(pixel[0], expected, expected * (1e-4 + rounding));
    CHECK_NEAR(pixel[2], expected, expected * (1e-4 + rounding));
    CHECK(pixel[3] == 0.0);
  }
}

void CheckExtremum(TestChecks& checks, const PolyhedraMappers::Entry& mapper, double thickness)
{
  PolyhedraScene scene(mapper.Make(), 64, 64);
  auto slab = Slab(thickness);
  TestMeshes::SetField(
    slab, [=](const double* p) { return 0.5 + 0.2 * p[0] - 0.1 * p[1] + 0.3 * p[2] / thickness; });
  scene.SetMesh(slab);
  for (const double tilt : { 0.0, 1.5 })
  {
    scene.LookFrom(0.0, tilt, 3.0);
    scene.CheckWithOracle(
      checks, mapper.Name + " of a slab of " + std::to_string(thickness), __LINE__);
  }
}
}

int TestPolyhedraThinSlabs(int, char*[])
{
  TestChecks checks;
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::All())
  {
    const bool additive = PolyhedraScene(mapper.Make()).IsAdditive();
    for (const double thickness : { 1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-5 })
    {
      additive ? CheckEmission(checks, mapper, thickness)
               : CheckExtremum(checks, mapper, thickness);
    }
  }
  return checks.Result();
}
