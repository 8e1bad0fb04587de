// How emission and absorption of a segment are found: exactly, by table, by the mean of its ends.

#include "PreIntegrationTable.h"
#include "SegmentIntegral.h"
#include "TestMeshes.h"
#include "TestScene.h"
#include "TransferFunction.h"

#include <cmath>

namespace
{
void CheckSegments(TestChecks& checks)
{
  // Colour and opacity rise with the scalar.
  TransferFunction ramp;
  const double range[2] = { 0.0, 1.0 };
  ramp.Build(
    { 0.0, 1.0 },
    [](double s) {
      return TransferFunction::Sample{ { s, 1.0 - s, 0.5, s } };
    },
    range, range, 0.5);
  const SegmentIntegral whole(ramp, 0.0, 1.0);
  CHECK_NEAR(whole.GetMeanExtinction(), 1.0, 1e-6);
  // Thin: the mean of s weighted by s is 2/3.
  CHECK_NEAR(whole.FindMeans(1e-14).Color[0], 2.0 / 3.0, 1e-6);
  CHECK_NEAR(whole.FindMeans(1e-3).Color[0], 2.0 / 3.0, 1e-3);
  // Thick and from the front: colour over alpha of int s 2 s L e^(-s^2 L) ds = sqrt(pi / L) / 2.
  CHECK_NEAR(whole.FindMeans(100.0).Color[0], std::sqrt(3.14159265358979 / 100.0) / 2.0, 1e-4);
  // From behind the densest part comes first.
  const SegmentIntegral reversed(ramp, 1.0, 0.0);
  CHECK(reversed.FindMeans(100.0).Color[0] > 0.99);
  CHECK_NEAR(reversed.GetMeanExtinction(), 1.0, 1e-6);
  const SegmentIntegral point(ramp, 0.25, 0.25);
  CHECK_NEAR(point.GetMeanExtinction(), 0.5, 1e-6);
  CHECK_NEAR(point.FindMeans(3.0).Color[0], 0.25, 1e-6);

  PreIntegrationTable table;
  const float ends[2] = { 0.0f, 1.0f };
  table.Build(ramp, ends, 32, false);
  CHECK(table.Texels.size() == 4u * 32u * 32u * 8u);
  // Front 0, back 1, length 0: then the last front scalar, front and back 1.
  CHECK_NEAR(table.Texels[4 * 32 * 31 + 3], 1.0, 1e-6);
  CHECK_NEAR(table.Texels[4 * (32 * 31 + 31) + 3], 2.0, 1e-6);
  CHECK_NEAR(table.Texels[4 * 32 * 31], 2.0 / 3.0, 1e-6);
}

void CheckPictures(TestChecks& checks, bool spiky)
{
  TestScene scene(64, 64);
  auto* mapper = scene.GetTetrahedraMapper();
  auto grid = TestMeshes::Delaunay(200);
  TestMeshes::SetField(grid, TestMeshes::Waves);
  scene.SetGrid(grid);
  if (spiky)
  {
    scene.SetSpiky();
  }
  const double exact = scene.MaximumError("exact");
  CHECK(exact >= 0.0);
  CHECK_AT_MOST(exact, 1e-4);
  mapper->SetIntegrationToAverage();
  const double average = scene.MaximumError("average");
  // It is what it is: spikes between the ends are missed.
  CHECK(average > (spiky ? 0.1 : 0.01) && average < (spiky ? 0.7 : 0.05));

  mapper->SetIntegrationToTable();
  double last = 1.0, smallest = 1.0;
  for (const int size : { 32, 64, 128, 256 })
  {
    mapper->SetTableSize(size);
    const double error = scene.MaximumError("table of size " + std::to_string(size));
    CHECK(error >= 0.0);
    // First order or better while the table is what limits the error.
    CHECK(error < last / (size <= 128 ? 1.7 : 1.0));
    last = error;
    smallest = std::min(smallest, error);
  }
  CHECK_AT_MOST(smallest, 2e-2);
  CHECK(smallest < 0.1 * average);
}

void CheckChanges(TestChecks& checks)
{
  TestScene scene, fresh;
  auto grid = TestMeshes::Delaunay(60);
  for (TestScene* each : { &scene, &fresh })
  {
    auto* mapper = each->GetTetrahedraMapper();
    mapper->SetTableSize(32);
    mapper->SetSamplesPerSegment(2);
    each->SetGrid(grid);
  }
  auto* mapper = scene.GetTetrahedraMapper();
  auto* freshMapper = fresh.GetTetrahedraMapper();
  scene.Render();
  auto exact = scene.CopyCaptured();
  mapper->SetIntegrationToTable();
  scene.Render();
  CHECK(TestScene::Difference(exact, scene.Mapper->GetCapturedImage()) > 1e-4);
  scene.SetSpiky();
  scene.Render();
  freshMapper->SetIntegrationToTable();
  fresh.SetSpiky();
  fresh.Render();
  const auto image = fresh.CopyCaptured();
  CHECK(TestScene::Difference(image, scene.Mapper->GetCapturedImage()) == 0.0);
  mapper->SetSamplesPerSegment(4);
  scene.Render();
  CHECK(TestScene::Difference(image, scene.Mapper->GetCapturedImage()) > 0.0);
}
}

int TestIntegration(int, char*[])
{
  TestChecks checks;
  CheckSegments(checks);
  CheckPictures(checks, false);
  CheckPictures(checks, true);
  CheckChanges(checks);
  return checks.Result();
}
