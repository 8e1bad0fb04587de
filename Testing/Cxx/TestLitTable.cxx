// Lit tetrahedra by pre-integration table: its entries in closed form, its error by samples, with
// gradient opacity, and the table that is built where light goes on or off.

#include "PreIntegrationTable.h"
#include "SegmentIntegral.h"
#include "TestMeshes.h"
#include "TestScene.h"
#include "TransferFunction.h"

#include <cmath>

namespace
{
void CheckEntries(TestChecks& checks)
{
  TransferFunction constant;
  const double range[2] = { 0.0, 1.0 };
  constant.Build({ 0.0, 1.0 },
    [](double) {
      return TransferFunction::Sample{ { 0.25, 0.5, 1.0, 1.0 } };
    },
    range, range, 1.0);
  const SegmentIntegral segment(constant, 0.2, 0.9);
  for (const double depth : { 1e-14, 0.5, 4.0 })
  {
    const SegmentIntegral::Means means = segment.FindMeans(depth);
    // int (1 - t) depth e^(-depth t) dt over 1 - e^(-depth): 1/2 where it is thin.
    const double passed =
      depth < 1e-3 ? 0.5 : 1.0 / depth - std::exp(-depth) / -std::expm1(-depth);
    CHECK_NEAR(means.Ahead, 1.0 - passed, 1e-4);
    CHECK_NEAR(means.Front[1], 0.5 * (1.0 - passed), 1e-4);
    CHECK_NEAR(means.Color[1], 0.5, 1e-6);
  }
  CHECK_NEAR(segment.FindMeans(1e-14).AheadSquared, 1.0 / 3.0, 1e-6);
  // Nothing but the last tenth, seen from either side.
  TransferFunction step;
  step.Build({ 0.0, 0.9, 1.0 },
    [](double s) {
      return TransferFunction::Sample{ { 1.0, 1.0, 1.0, s > 0.9 ? 1.0 : 0.0 } };
    },
    range, range, 1.0);
  CHECK_NEAR(SegmentIntegral(step, 0.0, 1.0).FindMeans(1e-3).Ahead, 0.05, 1e-3);
  CHECK_NEAR(SegmentIntegral(step, 1.0, 0.0).FindMeans(1e-3).Ahead, 0.95, 1e-3);
  PreIntegrationTable table;
  const float ends[2] = { 0.0f, 1.0f };
  table.Build(constant, ends, 32, true);
  // Red 1/4: 1/8 by the front's light, 1/8 by the back's; w 1/2, its spread sqrt(1/12).
  CHECK_NEAR(table.Front[0], 0.125, 1e-6);
  CHECK_NEAR(table.Back[0], 0.125, 1e-6);
  CHECK_NEAR(table.Front[3], 0.5, 1e-6);
  CHECK_NEAR(table.Back[3], std::sqrt(1.0 / 12.0), 1e-6);
  table.Build(constant, ends, 32, false);
  CHECK(!table.IsLit() && table.Back.empty());
}

double Error(TestScene& scene, const std::string& name, int samples)
{
  scene.GetTetrahedraMapper()->SetSamplesPerSegment(samples);
  return scene.MaximumError(name + ", samples " + std::to_string(samples));
}

void CheckPictures(TestChecks& checks, bool spiky)
{
  TestScene scene(64, 64);
  auto grid = TestMeshes::Delaunay(200);
  TestMeshes::SetField(grid, TestMeshes::Waves);
  scene.SetGrid(grid);
  if (spiky)
  {
    scene.SetSpiky();
  }
  scene.GetTetrahedraMapper()->SetIntegrationToTable();
  const double unlitOnce = Error(scene, "unlit", 1);
  const double unlit = Error(scene, "unlit", 4);
  scene.Property->ShadeOn();
  scene.Property->SetSpecular(0.4);
  const double litOnce = Error(scene, "lit", 1);
  const double lit = Error(scene, "lit", 4);
  CHECK(unlit > 0.0 && lit >= 0.0 && litOnce >= 0.0);
  CHECK_AT_MOST(lit, 1.25 * unlit);
  CHECK_AT_MOST(litOnce, 2.0 * unlitOnce);
  // Taken at the middle of each part.
  const double bound = spiky ? 2e-2 : 1e-3;
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.2, 0.0);
  function->AddPoint(1.5, 1.0);
  scene.Property->SetGradientOpacity(function);
  const double both = Error(scene, "and gradient opacity", 4);
  CHECK(both >= 0.0);
  CHECK_AT_MOST(both, bound);
  scene.Property->ShadeOff();
  const double opacity = Error(scene, "gradient opacity", 4);
  CHECK(opacity >= 0.0);
  CHECK_AT_MOST(opacity, bound);
}
}

int TestLitTable(int, char*[])
{
  TestChecks checks;
  CheckEntries(checks);
  CheckPictures(checks, false);
  CheckPictures(checks, true);
  return checks.Result();
}
