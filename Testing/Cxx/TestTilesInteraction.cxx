// While a window asks for a rate Tiles draw coarser: close to the full image, of the viewport's size,
// cut at opaque geometry and within its viewport; at rest the full image comes back to the last byte.

#include "ImageSampling.h"
#include "PolyhedraScene.h"
#include "TestMeshes.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <cmath>

namespace
{
constexpr int Width = 150, Height = 130;

// 1 where the statistics have no such column.
double CoarsenessOf(TestScene& scene)
{
  vtkTable* row = scene.Mapper->GetLastStatistics();
  return row->GetColumnByName("ImageSampleDistance")
    ? row->GetValueByName(0, "ImageSampleDistance").ToDouble()
    : 1.0;
}

double MeanDifference(vtkImageData* a, vtkImageData* b)
{
  vtkDataArray* first = a->GetPointData()->GetScalars();
  vtkDataArray* second = b->GetPointData()->GetScalars();
  double sum = 0.0;
  for (vtkIdType i = 0; i < first->GetNumberOfTuples(); ++i)
  {
    sum += std::abs(first->GetComponent(i, 3) - second->GetComponent(i, 3)) +
      std::abs(first->GetComponent(i, 0) - second->GetComponent(i, 0));
  }
  return sum / (2.0 * static_cast<double>(first->GetNumberOfTuples()));
}

void CheckChoice(TestChecks& checks)
{
  const ImageSampling::Limits limits;
  ImageSampling sampling;
  auto choose = [&](double seconds, double pixels = 1e4)
  { return sampling.Choose(seconds, pixels, limits); };
  CHECK(choose(0.01) == 1.0);
  sampling.Record({ 1e4, 1.0 }, 1.0);
  CHECK(choose(1e4) == 1.0);
  CHECK(choose(1.0) == 1.0);
  CHECK(choose(0.25) == 2.0);
  CHECK(choose(1e-5) == 10.0);
  // The frame that was drawn so keeps its time: nothing changes.
  sampling.Record({ 1e4, 2.0 }, 0.25);
  CHECK(choose(0.25) == 2.0);
  // A viewport of a quarter of the pixels has time for all of them.
  CHECK(choose(0.25, 2.5e3) == 1.0);
  CHECK(sampling.Choose(1e4, 1e4, { 3.0, 5.0 }) == 3.0);
  CHECK(sampling.Choose(1e-5, 1e4, { 3.0, 5.0 }) == 5.0);
  // A frame that was given up early says nothing, one that took long already does.
  sampling.RecordGivenUp({ 1e4, 1.0 }, 0.1);
  CHECK(choose(0.25) == 2.0);
  sampling.RecordGivenUp({ 1e4, 1.0 }, 4.0);
  CHECK(choose(0.25) == 4.0);
  // At rest, however slow the frames.
  CHECK(choose(20.0, 1e8) == 1.0);
}

void CheckCoarse(TestChecks& checks, TestScene& scene)
{
  scene.Render();
  auto full = scene.CopyCaptured();
  CHECK(CoarsenessOf(scene) == 1.0);
  scene.Mapper->AutoAdjustSampleDistancesOff();
  double last = 0.0;
  for (const float distance : { 1.5f, 2.0f, 4.0f })
  {
    scene.Mapper->SetImageSampleDistance(distance);
    scene.Render();
    vtkImageData* image = scene.Mapper->GetCapturedImage();
    CHECK(image->GetDimensions()[0] == full->GetDimensions()[0]);
    CHECK(image->GetDimensions()[1] == full->GetDimensions()[1]);
    CHECK(CoarsenessOf(scene) == static_cast<double>(distance));
    const double difference = MeanDifference(full, image);
    std::cout << scene.Mapper->GetClassName() << ", every " << distance << " pixels: mean difference "
              << difference << "\n";
    CHECK(difference > last);
    CHECK_AT_MOST(difference, 0.0015 * distance);
    last = difference;
  }
  scene.Mapper->AutoAdjustSampleDistancesOn();
}

void CheckInteraction(TestChecks& checks, TestScene& scene)
{
  scene.Render();
  auto full = scene.CopyCaptured();
  scene.Window->SetDesiredUpdateRate(1e7);
  scene.Mapper->SetMaximumImageSampleDistance(6.0);
  scene.Render();
  CHECK(CoarsenessOf(scene) == 6.0);
  CHECK(TestScene::Difference(full, scene.Mapper->GetCapturedImage()) > 0.0);
  scene.Window->SetDesiredUpdateRate(1e-4);
  scene.Render();
  CHECK(CoarsenessOf(scene) == 1.0);
  CHECK(TestScene::Difference(full, scene.Mapper->GetCapturedImage()) == 0.0);
}

// The half of the volume behind a plane's edge is hidden, also beside the edge.
void CheckOpaque(TestChecks& checks)
{
  TestScene scene(Width, Height);
  scene.SetGrid(TestMeshes::SixTetrahedra());
  scene.Mapper->SetEngineToTiles();
  scene.Mapper->AutoAdjustSampleDistancesOff();
  scene.SetConstant(1.0);
  scene.LookFrom(0.0, 0.0, 2.0);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.013, -2.0, 0.6);
  plane->SetPoint1(2.0, -2.0, 0.6);
  plane->SetPoint2(0.013, 2.0, 0.6);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
  scene.Render();
  auto full = scene.CopyCaptured();
  scene.Mapper->SetImageSampleDistance(4.0f);
  scene.Render();
  int hidden = 0;
  for (int x = 45; x < 105; ++x)
  {
    const double alpha = full->GetScalarComponentAsDouble(x, 65, 0, 3);
    hidden += alpha == 0.0 ? 1 : 0;
    CHECK_NEAR(scene.Pixel(x, 65)[3], alpha, 0.02);
  }
  CHECK(hidden > 20 && hidden < 40);
}

int RedAt(vtkRenderWindow* window, int x, int y)
{
  vtkNew<vtkUnsignedCharArray> pixel;
  window->GetPixelData(x, y, x, y, 0, pixel);
  return static_cast<int>(pixel->GetComponent(0, 0));
}

void CheckViewports(TestChecks& checks)
{
  TestScene scene(2 * Width, Height);
  scene.SetGrid(TestMeshes::SixTetrahedra());
  scene.Mapper->SetEngineToTiles();
  scene.Mapper->AutoAdjustSampleDistancesOff();
  scene.Mapper->SetImageSampleDistance(3.0f);
  scene.LookFrom(0.5, 0.8, 2.2);
  scene.AddSecondViewport();
  scene.Window->Render();
  CHECK(scene.Mapper->GetCapturedImage()->GetDimensions()[0] == Width);
  for (const int x : { 20, 60, 75, 90, 130 })
  {
    const double red = scene.Pixel(x, 60)[0];
    CHECK_NEAR(RedAt(scene.Window, x, 60) / 255.0, red, 1.0 / 255.0);
    CHECK_NEAR(RedAt(scene.Window, Width + x, 60) / 255.0, red, 1.0 / 255.0);
  }
  CHECK(RedAt(scene.Window, 75, 60) > 20);
}
}

int TestTilesInteraction(int, char*[])
{
  TestChecks checks;
  CheckChoice(checks);
  TestScene scene(Width, Height);
  scene.SetGrid(TestMeshes::Delaunay(60));
  scene.Mapper->SetEngineToTiles();
  CheckCoarse(checks, scene);
  CheckInteraction(checks, scene);
  auto mesh = TestMeshes::Curvilinear(3);
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::Exact())
  {
    PolyhedraScene polyhedra(mapper.Make(), Width, Height);
    polyhedra.SetMesh(mesh);
    polyhedra.SetView(0);
    polyhedra.Mapper->SetEngineToTiles();
    CheckInteraction(checks, polyhedra);
  }
  CheckOpaque(checks);
  CheckViewports(checks);
  return checks.Result();
}
