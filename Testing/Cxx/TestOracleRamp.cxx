/**
 * A scalar that is linear in space with linear functions: kappa = (s, 1/2, 1 - s), tau = 2 s. With
 * s = a + g t on the ray the depth is 2 a t + g t^2, so alpha is exact, the composite colour has a
 * closed form in erf (g > 0), the additive colour is a polynomial and the extrema are end values.
 */

#include "TestOracleScene.h"

namespace
{
struct Ray
{
  double First;  // scalar at entry
  double Last;   // scalar at exit
  double Length; // 0: misses
};

const TestOracleBox Ramp(int cellType)
{
  TestOracleBox box;
  box.CellType = cellType;
  box.Field = [](double, double, double z) { return (z + 1.0) / 2.0; };
  return box;
}

void SetUp(TestOracleScene& scene, double side, int mode)
{
  scene.Color->RemoveAllPoints();
  scene.Color->AddRGBPoint(0.0, 0.0, 0.5, 1.0);
  scene.Color->AddRGBPoint(1.0, 1.0, 0.5, 0.0);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.0);
  scene.Opacity->AddPoint(1.0, 1.0);
  scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(0.5);
  scene.Camera->SetPosition(1.1, 0.7, 4.0 * side);
  scene.Oracle->SetBlendMode(mode);
}

Ray GetRay(const TestOracleScene& scene, int column, int row)
{
  const std::array<double, 2> interval = scene.GetInterval(column, row, TestOracleBox().Bounds);
  double start[3], direction[3], cosine;
  scene.GetRay(column, row, start, direction, cosine);
  const double first = (start[2] + interval[0] * direction[2] + 1.0) / 2.0;
  const double last = (start[2] + interval[1] * direction[2] + 1.0) / 2.0;
  return { first, last, std::max(0.0, interval[1] - interval[0]) };
}

/** int s tau exp(-depth) dt = s alpha - int alpha ds, by parts. */
double GetRedByErf(const Ray& ray, double alpha)
{
  const double g = (ray.Last - ray.First) / ray.Length, root = std::sqrt(g);
  const double ends = std::erf(root * ray.Length + ray.First / root) - std::erf(ray.First / root);
  const double transmitted =
    std::exp(ray.First * ray.First / g) * std::sqrt(vtkMath::Pi()) / (2.0 * root) * ends;
  return ray.Last * alpha - g * (ray.Length - transmitted);
}

/** The same by Simpson's rule on 2000 intervals, for either direction. */
double GetRedBySimpson(const Ray& ray)
{
  const int count = 2000;
  double sum = 0.0;
  for (int i = 0; i <= count; ++i)
  {
    const double t = ray.Length * i / count, g = (ray.Last - ray.First) / ray.Length;
    const double s = ray.First + g * t;
    const double weight = i == 0 || i == count ? 1.0 : (i % 2 ? 4.0 : 2.0);
    sum += weight * 2.0 * s * s * std::exp(-2.0 * ray.First * t - g * t * t);
  }
  return sum * ray.Length / (3.0 * count);
}

std::array<double, 4> GetExpected(const Ray& ray, int mode)
{
  const double a = ray.First, b = ray.Last, length = ray.Length;
  const double depth = length * (a + b);
  if (mode == vtkCellProjectionOracle::COMPOSITE_BLEND)
  {
    const double alpha = -std::expm1(-depth);
    const double red = b > a ? GetRedByErf(ray, alpha) : GetRedBySimpson(ray);
    return { red, 0.5 * alpha, alpha - red, alpha };
  }
  if (mode == vtkCellProjectionOracle::ADDITIVE_BLEND)
  {
    const double red = 2.0 * length * (a * a + a * b + b * b) / 3.0;
    return { red, 0.5 * depth, depth - red, 0.0 };
  }
  const bool isMaximum = mode == vtkCellProjectionOracle::MAXIMUM_INTENSITY_BLEND;
  const double s = isMaximum ? std::max(a, b) : std::min(a, b);
  return { s * s, 0.5 * s, (1.0 - s) * s, s };
}

void CheckRamp(TestOracleChecks& checks, int cellType, double side, int mode)
{
  TestOracleScene scene;
  SetUp(scene, side, mode);
  CHECK_TRUE(checks, scene.Draw(Ramp(cellType).Build()));
  int covered = 0;
  for (int row = 0; row < scene.Height; ++row)
  {
    for (int column = 0; column < scene.Width; ++column)
    {
      const Ray ray = GetRay(scene, column, row);
      const bool hits = ray.Length > 0.0;
      const auto expected = hits ? GetExpected(ray, mode) : std::array<double, 4>{};
      covered += hits;
      for (int component = 0; component < 4; ++component)
      {
        CHECK_NEAR(checks, scene.GetValue(column, row, component), expected[component], 1e-10);
      }
    }
  }
  CHECK_TRUE(checks, covered > 50);
}
}

int TestOracleRamp(int, char*[])
{
  TestOracleChecks checks(__FILE__);
  for (int cellType :
    { VTK_TETRA, VTK_HEXAHEDRON, VTK_VOXEL, VTK_WEDGE, VTK_PYRAMID, VTK_POLYHEDRON })
  {
    for (double side : { -1.0, 1.0 })
    {
      for (int mode : { 0, 1, 2, 4 })
      {
        CheckRamp(checks, cellType, side, mode);
      }
    }
  }
  return checks.GetResult();
}
