// Cyclic groups in scenes: beside opaque geometry, in several viewports, among cells in order, with
// cells that are not drawn; nothing of the window's state is left changed.

#include "GroupSort.h"
#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkActor.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <limits>

namespace
{
void AddBall(TestScene& scene)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(0.3);
  source->SetCenter(0.1, 0.2, 0.1);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  scene.Renderer->AddActor(actor);
}

// The image in a proven order; then the same scene again with every cell in one group.
double DifferenceToSorted(TestScene& scene)
{
  vtkNew<GroupSort> group;
  scene.Render();
  auto sorted = scene.CopyCaptured();
  vtkSmartPointer<vtkVisibilitySort> before = scene.GetTetrahedraMapper()->GetVisibilitySort();
  scene.GetTetrahedraMapper()->SetVisibilitySort(group);
  scene.Render();
  const double difference = TestScene::Difference(sorted, scene.Mapper->GetCapturedImage());
  scene.GetTetrahedraMapper()->SetVisibilitySort(before);
  return difference;
}

void CheckBall(TestChecks& checks, int samples)
{
  TestScene scene;
  scene.Window->SetMultiSamples(samples);
  scene.SetGrid(TestMeshes::SixTetrahedra());
  scene.Render();
  auto whole = scene.CopyCaptured();
  AddBall(scene);
  const double difference = DifferenceToSorted(scene);
  CHECK(difference >= 0.0);
  CHECK_AT_MOST(difference, 1e-5);
  CHECK(TestScene::Difference(whole, scene.Mapper->GetCapturedImage()) > 0.1);
}

void CheckViewports(TestChecks& checks)
{
  TestScene scene(256, 128);
  vtkNew<GroupSort> sort;
  scene.GetTetrahedraMapper()->SetVisibilitySort(sort);
  scene.SetGrid(TestMeshes::SixTetrahedra());
  scene.AddSecondViewport();
  for (int frame = 0; frame < 2; ++frame)
  {
    const double error = scene.MaximumError("second viewport");
    CHECK(error >= 0.0);
    CHECK_AT_MOST(error, 2e-4);
  }
  // Another size means other targets.
  scene.Window->SetSize(300, 150);
  const double resized = scene.MaximumError("another size");
  CHECK(resized >= 0.0);
  CHECK_AT_MOST(resized, 2e-4);
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  const double released = scene.MaximumError("after a release");
  CHECK(released >= 0.0);
  CHECK_AT_MOST(released, 2e-4);
}

// A mesh of several groups between runs of ordered cells, some cells without colour or value.
void CheckRuns(TestChecks& checks)
{
  TestScene scene;
  auto grid = TestMeshes::Delaunay(60);
  scene.SetGrid(grid);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.5, 0.0);
  scene.Opacity->AddPoint(1.0, 3.0);
  vtkNew<GroupSort> sort;
  sort->Inner = vtkSmartPointer<FaceOrderSort>::New();
  scene.GetTetrahedraMapper()->SetVisibilitySort(sort);
  for (const int size : { 1, 20, 60, 100000 })
  {
    sort->GroupSize = size;
    sort->Modified();
    const double error = scene.MaximumError("groups of " + std::to_string(size));
    CHECK(error >= 0.0);
    CHECK_AT_MOST(error, 2e-4);
    vtkTable* table = scene.Mapper->GetLastStatistics();
    CHECK(table->GetValueByName(0, "CellsSkippedTransparent").ToInt() > 0);
    CHECK(table->GetValueByName(0, "Cycles").ToInt() > 0);
  }
}

void CheckInvalid(TestChecks& checks)
{
  TestScene scene;
  vtkNew<GroupSort> sort;
  scene.GetTetrahedraMapper()->SetVisibilitySort(sort);
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  auto grid = TestMeshes::SixTetrahedra();
  grid->GetPointData()->GetScalars()->SetComponent(1, 0, std::numeric_limits<double>::quiet_NaN());
  scene.SetGrid(grid);
  scene.Render();
  vtkTable* table = scene.Mapper->GetLastStatistics();
  CHECK(table->GetValueByName(0, "CellsSkippedInvalid").ToInt() == 2);
  CHECK(table->GetValueByName(0, "CellsDrawn").ToInt() == 4);
  CHECK(scene.CenterPixel()[3] > 0.1 && scene.CenterPixel()[3] <= 1.0);
  CHECK(messages->Count() == 1);
}
}

int TestCyclicScenes(int, char*[])
{
  TestChecks checks;
  CheckBall(checks, 0);
  CheckBall(checks, 4);
  CheckViewports(checks);
  CheckRuns(checks);
  CheckInvalid(checks);
  return checks.Result();
}
