// The approximations in a scene: each setter changes the image, and what the scene cuts is cut.

#include "OpaquePlane.h"
#include "GroupSort.h"
#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkConvexCells.h"
#include "vtkPlane.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <cmath>
#include <functional>
#include <set>

namespace
{
using Mapper = vtkPreIntegratedTetrahedraMapper;

constexpr int Approximations = 6;

void LookAlongZ(TestScene& scene)
{
  scene.LookFrom(0.0, 0.0, 2.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.9);
  camera->SetClippingRange(1.0, 3.0);
}

// What of the pixel's ray through the cube is seen: its depths, from the eye.
double ConstantAlpha(double depth, double unitLength)
{
  return 1.0 - std::exp(-depth * unitLength);
}

void CheckSetters(TestChecks& checks)
{
  TestScene scene;
  auto* mapper = scene.GetTetrahedraMapper();
  scene.SetGrid(TestMeshes::Delaunay(60));
  CHECK(mapper->GetApproximation() == Mapper::NONE);
  CHECK_NEAR(mapper->GetCentroidThickness(), 2.75, 0.0);
  CHECK_NEAR(mapper->GetCentroidRimOpacity(), 0.3, 0.0);
  const std::vector<std::function<void()>> setters = {
    [&] { mapper->SetApproximationToShirleyTuchman(); },
    [&] { mapper->SetApproximationToShirleyTuchmanExponential(); },
    [&] { mapper->SetApproximationToVoxel(); },
    [&] { mapper->SetApproximationToUniformThickness1(); },
    [&] { mapper->SetApproximationToUniformThickness2(); },
    [&] { mapper->SetApproximationToCentroid(); },
    [&] { mapper->SetCentroidThickness(2.5); },
    [&] { mapper->SetCentroidRimOpacity(0.0); },
    [&] { mapper->SetApproximationToNone(); },
  };
  scene.Render();
  const auto exact = scene.CopyCaptured();
  std::set<std::string> methods;
  for (size_t i = 0; i < setters.size(); ++i)
  {
    const auto before = scene.CopyCaptured();
    setters[i]();
    scene.Render();
    const double change = TestScene::Difference(before, mapper->GetCapturedImage());
    checks.Check(change > 1e-3, "changes the image", __LINE__, std::to_string(i));
    vtkTable* statistics = mapper->GetLastStatistics();
    methods.insert(statistics->GetValueByName(0, "Method").ToString());
    CHECK(statistics->GetValueByName(0, "CellsDrawn").ToInt() > 0);
  }
  CHECK(methods.size() == 7);
  CHECK(TestScene::Difference(exact, mapper->GetCapturedImage()) == 0.0);
  // It overrides how segments are integrated.
  mapper->SetApproximationToVoxel();
  scene.Render();
  const auto voxel = scene.CopyCaptured();
  mapper->SetIntegrationToTable();
  scene.Render();
  CHECK(TestScene::Difference(voxel, mapper->GetCapturedImage()) == 0.0);
}

// The mean opacity of the middle 16 x 16 pixels, which rays of the same length pass. The rasteriser moves corners
// onto its grid, so that each pixel alone has lengths that are a little longer or shorter.
double MeanOpacity(TestScene& scene)
{
  constexpr int half = 8;
  const int* size = scene.Renderer->GetSize();
  double sum = 0.0;
  for (int y = -half; y < half; ++y)
  {
    for (int x = -half; x < half; ++x)
    {
      sum += scene.Pixel(size[0] / 2 + x, size[1] / 2 + y)[3];
    }
  }
  return sum / (4.0 * half * half);
}

// A cube of constant extinction 1: the length inside a cell is linear on its triangles.
void CheckSlab(TestChecks& checks)
{
  TestScene scene;
  auto* mapper = scene.GetTetrahedraMapper();
  const double size[3] = { 1.2, 1.2, 0.7 };
  const int cells[3] = { 4, 3, 5 };
  scene.SetGrid(TestMeshes::Slab(size, cells));
  scene.SetConstant(1.0);
  LookAlongZ(scene);
  mapper->SetApproximationToShirleyTuchmanExponential();
  CHECK_AT_MOST(scene.MaximumError("constant, along an axis"), 1e-5);
  CHECK_NEAR(scene.CenterPixel()[3], ConstantAlpha(0.7, 1.0), 1e-5);
  scene.LookFrom(1.0, 0.6, 2.0);
  CHECK_AT_MOST(scene.MaximumError("constant, parallel projection"), 2e-2);
  // In the middle of the screen, and wherever no edge of a silhouette runs through the pixel.
  CHECK_NEAR(MeanOpacity(scene), ConstantAlpha(0.7 * std::sqrt(5.36) / 2.0, 1.0), 1e-5);
  mapper->SetApproximationToShirleyTuchman();
  scene.Render();
  CHECK(std::abs(scene.CenterPixel()[3] - ConstantAlpha(0.7 * std::sqrt(5.36) / 2.0, 1.0)) > 1e-4);
  // World lengths: half the size, twice the extinction.
  mapper->SetApproximationToShirleyTuchmanExponential();
  scene.Volume->SetScale(0.5);
  scene.Property->SetScalarOpacityUnitDistance(0.5);
  scene.Render();
  CHECK_NEAR(MeanOpacity(scene), ConstantAlpha(0.7 * std::sqrt(5.36) / 2.0, 1.0), 1e-5);
}

// Halves of a constant cube, by a clipping plane and by an opaque one across the view.
void CheckCuts(TestChecks& checks)
{
  for (int approximation = 1; approximation <= Approximations; ++approximation)
  {
    TestScene scene;
    auto* mapper = scene.GetTetrahedraMapper();
    mapper->SetApproximation(approximation);
    const double size[3] = { 1.2, 1.2, 0.8 };
    const int cells[3] = { 6, 6, 8 };
    scene.SetGrid(TestMeshes::Slab(size, cells));
    scene.SetConstant(1.0);
    LookAlongZ(scene);
    scene.Render();
    const double whole = -std::log(1.0 - scene.CenterPixel()[3]);
    std::cout << approximation << ": optical depth " << whole << "\n";
    CHECK(approximation != Mapper::SHIRLEY_TUCHMAN_EXPONENTIAL || std::abs(whole - 0.8) < 1e-5);

    vtkNew<vtkPlane> plane;
    plane->SetOrigin(0.0, 0.0, 0.05);
    plane->SetNormal(0.0, 0.0, -1.0);
    mapper->AddClippingPlane(plane);
    scene.Render();
    const double clipped = -std::log(1.0 - scene.CenterPixel()[3]);
    CHECK_NEAR(clipped / whole, 0.45 / 0.8, 0.1);
    mapper->RemoveAllClippingPlanes();

    OpaquePlane::Add(scene, -0.1, -0.1);
    scene.Render();
    const double seen = -std::log(1.0 - scene.CenterPixel()[3]);
    CHECK_NEAR(seen / whole, 0.5 / 0.8, 0.1);
  }
}

// Every pixel is lit, and by what the exact image has within what the approximation can.
void CheckCameraInside(TestChecks& checks)
{
  TestScene scene;
  auto* mapper = scene.GetTetrahedraMapper();
  vtkNew<vtkConvexCells> cut;
  cut->SetInputData(TestMeshes::Curvilinear(5));
  cut->TetrahedraOnlyOn();
  cut->Update();
  scene.SetGrid(cut->GetOutput());
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(0.4, 0.2, 0.1);
  camera->SetPosition(0.05, 0.02, 0.11);
  for (const double nearPlane : { 1e-3, 0.1 })
  {
    camera->SetClippingRange(nearPlane, 10.0);
    for (int approximation = 1; approximation <= Approximations; ++approximation)
    {
      mapper->SetApproximation(approximation);
      const double error = scene.MaximumError("inside, " + std::to_string(approximation));
      const bool isThick = approximation <= Mapper::SHIRLEY_TUCHMAN_EXPONENTIAL;
      CHECK(error >= 0.0);
      // Linear over the whole screen is coarse for the cell around the eye.
      CHECK_AT_MOST(error, !isThick ? 0.3 : nearPlane < 0.01 ? 0.16 : 0.05);
      const auto pixels = static_cast<int>(scene.Oracle->GetNumberOfCoveredPixels());
      CHECK(pixels == 128 * 128);
      int dark = 0;
      for (int i = 0; i < 128 * 128; ++i)
      {
        dark += scene.Pixel(i % 128, i / 128)[3] > 0.0 ? 0 : 1;
      }
      CHECK(dark == 0);
    }
  }
}

// Half of the window shows what the whole of a window of that size shows.
void CheckViewport(TestChecks& checks)
{
  TestScene half(128, 64), whole(64, 64);
  half.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  for (TestScene* scene : { &half, &whole })
  {
    scene->SetGrid(TestMeshes::Delaunay(60));
    scene->GetTetrahedraMapper()->SetApproximationToCentroid();
    scene->Render();
  }
  CHECK(TestScene::Difference(half.Mapper->GetCapturedImage(), whole.CopyCaptured()) == 0.0);
}

void MovePoint(vtkUnstructuredGrid* grid)
{
  double point[3];
  grid->GetPoint(8, point);
  grid->GetPoints()->SetPoint(8, point[0], point[1] + 1e-3, point[2]);
  grid->GetPoints()->Modified();
}

// Another matrix, function, field, point: as from a fresh mapper.
void CheckChanges(TestChecks& checks, int approximation)
{
  auto grid = TestMeshes::Delaunay(60);
  using Step = std::function<void(TestScene&)>;
  const std::vector<Step> steps = {
    [](TestScene& scene) { scene.Volume->SetScale(1.0, 1.5, 0.8); },
    [](TestScene& scene) { scene.SetSpiky(); },
    [&](TestScene&) { TestMeshes::SetField(grid, [](const double* p) { return 0.5 + p[0]; }); },
    [&](TestScene&) { MovePoint(grid); },
  };
  TestScene kept;
  kept.SetGrid(grid);
  kept.GetTetrahedraMapper()->SetApproximation(approximation);
  kept.Render();
  for (size_t i = 0; i < steps.size(); ++i)
  {
    const auto before = kept.CopyCaptured();
    TestScene fresh;
    fresh.SetGrid(grid);
    fresh.GetTetrahedraMapper()->SetApproximation(approximation);
    steps[i](kept);
    kept.Render();
    fresh.Volume->SetScale(kept.Volume->GetScale());
    if (i > 0)
    {
      fresh.SetSpiky();
    }
    fresh.Render();
    CHECK(TestScene::Difference(kept.CopyCaptured(), fresh.Mapper->GetCapturedImage()) == 0.0);
    CHECK(TestScene::Difference(before, fresh.Mapper->GetCapturedImage()) > 1e-4);
  }
}

void CheckCircle(TestChecks& checks)
{
  TestScene scene;
  auto* mapper = scene.GetTetrahedraMapper();
  vtkNew<MessageObserver> messages;
  messages->Watch(mapper);
  vtkNew<GroupSort> sort;
  mapper->SetVisibilitySort(sort);
  mapper->SetApproximationToShirleyTuchman();
  scene.SetGrid(TestMeshes::SixTetrahedra());
  scene.Render();
  scene.LookFrom(1.0, 1.0, 1.0);
  scene.Render();
  // Where the whole suite asks for Tiles that these are by Raster is said, too, once.
  const int engines = messages->CountOf("drawn by Raster");
  CHECK(engines <= 1 && messages->Count() == 1 + engines);
  CHECK(messages->CountOf("SetApproximationToNone") == 1);
}
}

int TestApproximations(int, char*[])
{
  TestChecks checks;
  CheckSetters(checks);
  CheckSlab(checks);
  CheckCuts(checks);
  CheckCameraInside(checks);
  CheckViewport(checks);
  for (const int approximation : { Mapper::SHIRLEY_TUCHMAN, Mapper::VOXEL, Mapper::CENTROID })
  {
    CheckChanges(checks, approximation);
  }
  CheckCircle(checks);
  return checks.Result();
}
