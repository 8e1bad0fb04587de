/**
 * One tetrahedron by hand: the corner of the unit cube, s = x + 2 y + 4 z, seen along -z, where a
 * ray at (x, y) enters at z = 1 - x - y and leaves at z = 0. In all 24 vertex numberings.
 */

#include "TestOracleScene.h"

namespace
{
vtkSmartPointer<vtkUnstructuredGrid> BuildTetrahedron(const std::array<int, 4>& order)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, 0.0);
  points->InsertNextPoint(0.0, 0.0, 1.0);
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("corner");
  for (double scalar : { 0.0, 1.0, 2.0, 4.0 })
  {
    scalars->InsertNextValue(scalar);
  }
  grid->SetPoints(points);
  grid->GetPointData()->AddArray(scalars);
  const vtkIdType ids[4] = { order[0], order[1], order[2], order[3] };
  grid->InsertNextCell(VTK_TETRA, 4, ids);
  return grid;
}

void SetUp(TestOracleScene& scene)
{
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.0);
  scene.Opacity->AddPoint(10.0, 1.0);
  scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(1.0);
  // 20 pixels over [-1, 1]: centres at -0.95, -0.85 ... 0.95.
  scene.Camera->SetPosition(0.0, 0.0, 5.0);
  scene.Camera->SetFocalPoint(0.0, 0.0, 0.0);
  scene.Camera->SetParallelProjection(true);
  scene.Camera->SetParallelScale(1.0);
  scene.Oracle->SetSize(20, 20);
  scene.Oracle->SetArrayName("corner");
}

void CheckPixels(TestOracleChecks& checks, const std::array<int, 4>& order)
{
  struct Pixel
  {
    int Column, Row;
    double Length, First, Last;
  };
  const Pixel pixels[] = {
    { 12, 12, 0.5, 2.75, 0.75 }, // x = .25, y = .25: enters at z = .5
    { 10, 10, 0.9, 3.75, 0.15 }, // x = .05, y = .05: enters at z = .9
    { 14, 11, 0.4, 2.35, 0.75 }, // x = .45, y = .15: enters at z = .4
    { 10, 17, 0.2, 2.35, 1.55 }, // x = .05, y = .75: enters at z = .2
    { 9, 10, 0.0, 0.0, 0.0 },    // x = -.05: outside
    { 16, 14, 0.0, 0.0, 0.0 },   // x + y = 1.1: outside
  };
  TestOracleScene scene;
  SetUp(scene);
  CHECK_TRUE(checks, scene.Draw(BuildTetrahedron(order)));
  CHECK_TRUE(checks, scene.Oracle->GetNumberOfSegments() >= 45);
  CHECK_TRUE(checks, scene.Oracle->GetNumberOfSegments() <= 55);
  for (const Pixel& pixel : pixels)
  {
    const double depth = pixel.Length * (pixel.First + pixel.Last) / 20.0;
    const double alpha = 1.0 - std::exp(-depth);
    CHECK_NEAR(checks, scene.GetValue(pixel.Column, pixel.Row, 3), alpha, 1e-12);
    CHECK_NEAR(checks, scene.GetValue(pixel.Column, pixel.Row, 1), 0.5 * alpha, 1e-12);
  }
  for (int mode : { 1, 2 })
  {
    scene.Oracle->SetBlendMode(mode);
    CHECK_TRUE(checks, scene.Oracle->Update());
    for (const Pixel& pixel : pixels)
    {
      const double opacity = (mode == 1 ? pixel.First : pixel.Last) / 10.0;
      CHECK_NEAR(checks, scene.GetValue(pixel.Column, pixel.Row, 3), opacity, 1e-12);
      CHECK_NEAR(checks, scene.GetValue(pixel.Column, pixel.Row, 2), 0.9 * opacity, 1e-12);
    }
  }
}

/** One pixel in perspective from (.2, .1, 3): the axis itself, entering at z = .7. */
void CheckPerspective(TestOracleChecks& checks)
{
  TestOracleScene scene;
  SetUp(scene);
  scene.Camera->SetParallelProjection(false);
  scene.Camera->SetPosition(0.2, 0.1, 3.0);
  scene.Camera->SetFocalPoint(0.2, 0.1, 0.0);
  scene.Oracle->SetSize(1, 1);
  CHECK_TRUE(checks, scene.Draw(BuildTetrahedron({ 0, 1, 2, 3 })));
  CHECK_TRUE(checks, scene.Oracle->GetNumberOfSegments() == 1);
  // s falls from .2 + .2 + 2.8 = 3.2 to .4: the mean is 1.8, the depth .7 * .18.
  CHECK_NEAR(checks, scene.GetValue(0, 0, 3), 1.0 - std::exp(-0.126), 1e-12);
}
}

int TestOracleTetrahedron(int, char*[])
{
  TestOracleChecks checks(__FILE__);
  std::array<int, 4> order = { 0, 1, 2, 3 };
  do
  {
    CheckPixels(checks, order);
  } while (std::next_permutation(order.begin(), order.end()));
  CheckPerspective(checks);
  return checks.GetResult();
}
