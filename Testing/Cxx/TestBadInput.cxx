// Bad input: one message that names the offender, the rest drawn, never a crash.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkVariant.h"
#include "vtkVisibilitySort.h"

#include <cmath>
#include <limits>

namespace
{
/// A scene whose messages are collected; shows six tetrahedra unless told otherwise.
class BadScene : public TestScene
{
public:
  BadScene()
  {
    this->Messages->Watch(this->Mapper);
    this->Grid = TestMeshes::SixTetrahedra();
    this->SetGrid(this->Grid);
  }
  /// Two frames: a message that is still true is not said again.
  void RenderTwice()
  {
    this->Render();
    this->Render();
  }
  bool SaysOnce(const std::string& text)
  {
    const bool good = this->Messages->Count() == 1 && this->Messages->CountOf(text) == 1;
    for (const std::string& line : this->Messages->Texts)
    {
      std::cout << (good ? "" : "unexpected: ") << line.substr(line.find('\n') + 1);
    }
    return good;
  }
  bool DrawsSomething() { return this->CenterPixel()[3] > 0.1; }
  double Statistic(const char* column)
  {
    return this->Mapper->GetLastStatistics()->GetValueByName(0, column).ToDouble();
  }

  vtkNew<MessageObserver> Messages;
  TestMeshes::Grid Grid;
};

void CheckMissingInput(TestChecks& checks)
{
  BadScene scene;
  scene.Mapper->SetInputConnection(nullptr);
  scene.RenderTwice();
  CHECK(scene.SaysOnce("No input"));
  CHECK(scene.Mapper->GetCapturedImage() == nullptr);

  BadScene empty;
  vtkNew<vtkUnstructuredGrid> nothing;
  empty.Mapper->SetInputData(nothing);
  empty.RenderTwice();
  CHECK(empty.SaysOnce("0 points and 0 cells"));

  BadScene pointsOnly;
  vtkNew<vtkUnstructuredGrid> cloud;
  cloud->SetPoints(pointsOnly.Grid->GetPoints());
  pointsOnly.Mapper->SetInputData(cloud);
  pointsOnly.RenderTwice();
  CHECK(pointsOnly.SaysOnce("9 points and 0 cells"));
}

void CheckMissingScalars(TestChecks& checks)
{
  BadScene scene;
  scene.Grid->GetPointData()->Initialize();
  scene.RenderTwice();
  CHECK(scene.SaysOnce("no active scalars"));

  BadScene named;
  named.Mapper->SetScalarModeToUsePointFieldData();
  named.Mapper->SelectScalarArray("velocity");
  named.RenderTwice();
  CHECK(named.SaysOnce("no array velocity"));
  named.Mapper->SetScalarModeToUseCellFieldData();
  named.Mapper->SelectScalarArray(7);
  named.RenderTwice();
  CHECK(named.Messages->Count() == 2 && named.Messages->CountOf("no array number 7") == 1);
  // And recovers: the messages change nothing.
  named.Mapper->SetScalarModeToDefault();
  named.RenderTwice();
  CHECK(named.DrawsSomething());
}

void CheckArrayLengths(TestChecks& checks)
{
  for (const int tuples : { 0, 3, 40 })
  {
    BadScene scene;
    vtkNew<vtkDoubleArray> array;
    array->SetName("short");
    array->SetNumberOfTuples(tuples);
    array->FillComponent(0, 0.5);
    scene.Grid->GetPointData()->AddArray(array);
    scene.Grid->GetCellData()->AddArray(array);
    // Beside good scalars it does no harm.
    scene.RenderTwice();
    CHECK(scene.Messages->Count() == 0);
    CHECK(scene.DrawsSomething());
    scene.Mapper->SetScalarModeToUsePointFieldData();
    scene.Mapper->SelectScalarArray("short");
    scene.RenderTwice();
    CHECK(scene.SaysOnce("array short has " + std::to_string(tuples) + " tuples for 9 points"));
  }
}

// One value far outside what the transfer function knows costs the others nothing.
void CheckOutliers(TestChecks& checks)
{
  for (const double outlier : { -1e10, 1e10 })
  {
    BadScene scene;
    scene.Render();
    auto good = scene.CopyCaptured();
    // The ninth point is in no cell.
    scene.Grid->GetPointData()->GetScalars()->SetComponent(8, 0, outlier);
    scene.Grid->GetPointData()->GetScalars()->Modified();
    scene.Render();
    CHECK_AT_MOST(TestScene::Difference(good, scene.Mapper->GetCapturedImage()), 2e-6);
    scene.Grid->GetPointData()->GetScalars()->SetComponent(1, 0, outlier);
    scene.Grid->GetPointData()->GetScalars()->Modified();
    const double error = scene.MaximumError("outlier");
    CHECK(error >= 0.0);
    CHECK_AT_MOST(error, 1e-3);
  }
}

void CheckDepthPeeling(TestChecks& checks)
{
  BadScene scene;
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->UseDepthPeelingForVolumesOn();
  scene.RenderTwice();
  CHECK(scene.SaysOnce("UseDepthPeelingForVolumesOff"));
}

void CheckNonFiniteScalars(TestChecks& checks)
{
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity() })
  {
    BadScene scene;
    // Corner 1 belongs to two of the six tetrahedra.
    scene.Grid->GetPointData()->GetScalars()->SetComponent(1, 0, bad);
    scene.RenderTwice();
    CHECK(scene.SaysOnce("1 of 9 values that are not finite"));
    CHECK(scene.DrawsSomething());
    CHECK(scene.Statistic("CellsDrawn") == 4.0);
    CHECK(scene.Statistic("CellsSkippedInvalid") == 2.0);
  }
  BadScene all;
  TestMeshes::SetField(all.Grid, [](const double*) { return std::nan(""); });
  all.RenderTwice();
  CHECK(all.SaysOnce("9 of 9 values"));
  CHECK(all.Statistic("CellsSkippedInvalid") == 6.0);
}

void CheckProperty(TestChecks& checks)
{
  BadScene opacity;
  opacity.Opacity->RemoveAllPoints();
  opacity.RenderTwice();
  CHECK(opacity.SaysOnce("scalar opacity function has no points"));
  CHECK(opacity.DrawsSomething());

  BadScene color;
  color.Color->RemoveAllPoints();
  color.RenderTwice();
  CHECK(color.SaysOnce("colour function has no points"));
  CHECK(color.DrawsSomething());

  BadScene distance;
  distance.Property->SetScalarOpacityUnitDistance(0.0);
  distance.RenderTwice();
  CHECK(distance.SaysOnce("ScalarOpacityUnitDistance is 0"));
  CHECK(distance.DrawsSomething());

  BadScene constant;
  TestMeshes::SetField(constant.Grid, [](const double*) { return 0.5; });
  constant.RenderTwice();
  CHECK(constant.Messages->Count() == 0);
  CHECK(constant.DrawsSomething());
}

void CheckOtherCells(TestChecks& checks)
{
  BadScene scene;
  const vtkIdType ids[10] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 0 };
  scene.Grid->InsertNextCell(VTK_LINE, 2, ids);
  scene.Grid->InsertNextCell(VTK_VERTEX, 1, ids);
  scene.Grid->InsertNextCell(200, 10, ids);
  scene.RenderTwice();
  CHECK(scene.SaysOnce("1 vtkLine"));
  CHECK(scene.Messages->CountOf("1 of type 200") == 1);
  CHECK(scene.DrawsSomething());
  CHECK(scene.Statistic("CellsSkippedInvalid") == 3.0);

  // Nothing but a triangle.
  BadScene flat;
  vtkNew<vtkUnstructuredGrid> triangle;
  triangle->SetPoints(flat.Grid->GetPoints());
  triangle->InsertNextCell(VTK_TRIANGLE, 3, ids);
  TestMeshes::SetField(triangle, TestMeshes::Waves);
  flat.Mapper->SetInputData(triangle);
  flat.RenderTwice();
  CHECK(flat.SaysOnce("1 vtkTriangle"));
}

void CheckBadPoints(TestChecks& checks)
{
  BadScene scene;
  scene.Grid->GetPoints()->SetPoint(1, std::nan(""), 0.0, 0.0);
  scene.Grid->GetPoints()->Modified();
  scene.LookFrom(0.5, 0.8, 2.2);
  scene.RenderTwice();
  CHECK(scene.Messages->Count() == 1);
  CHECK(scene.DrawsSomething());
  CHECK(scene.Statistic("CellsDrawn") == 4.0);

  // A speck ten million times smaller than the mesh: its points are one point as floats.
  BadScene speck;
  const double origin[3] = { 0.4, 0.3, 0.2 };
  vtkIdType ids[4];
  for (int i = 0; i < 4; ++i)
  {
    double corner[3] = { origin[0], origin[1], origin[2] };
    corner[i % 3] += 1e-12 * (i + 1);
    ids[i] = speck.Grid->GetPoints()->InsertNextPoint(corner);
  }
  speck.Grid->InsertNextCell(VTK_TETRA, 4, ids);
  TestMeshes::SetField(speck.Grid, TestMeshes::Waves);
  speck.RenderTwice();
  CHECK(speck.SaysOnce("1 tetrahedra are too small"));
  CHECK(speck.DrawsSomething());
}

void CheckMatrices(TestChecks& checks)
{
  BadScene matrix;
  matrix.Volume->SetScale(1.0, 0.0, 1.0);
  matrix.RenderTwice();
  CHECK(matrix.SaysOnce("cannot be inverted"));

  // Of a near plane this near a matrix of doubles keeps no far one.
  BadScene noFar;
  noFar.Renderer->GetActiveCamera()->SetClippingRange(1e-18, 10.0);
  noFar.RenderTwice();
  CHECK(noFar.SaysOnce("has no far plane"));
  noFar.Renderer->GetActiveCamera()->SetClippingRange(0.1, 10.0);
  noFar.RenderTwice();
  CHECK(noFar.DrawsSomething());
}

void CheckWindowWithoutPixels(TestChecks& checks)
{
  BadScene scene;
  scene.Renderer->SetViewport(0.0, 0.0, 0.0, 0.0);
  scene.RenderTwice();
  CHECK(scene.SaysOnce("0x0 pixels"));
  CHECK(scene.Mapper->GetCapturedImage() == nullptr);
  scene.Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  scene.RenderTwice();
  CHECK(scene.DrawsSomething());
}

/// Returns nonsense: an id twice, ids out of range, and forgets the rest.
class BrokenSort : public vtkVisibilitySort
{
public:
  static BrokenSort* New() { return new BrokenSort; }
  void InitTraversal() override { this->Done = false; }
  vtkIdTypeArray* GetNextCells() override
  {
    this->Ids->Reset();
    for (const vtkIdType id : { 3, 3, -1, 99 })
    {
      this->Ids->InsertNextValue(id);
    }
    vtkIdTypeArray* batch = this->Done ? nullptr : this->Ids.GetPointer();
    this->Done = true;
    return batch;
  }

private:
  vtkNew<vtkIdTypeArray> Ids;
  bool Done = false;
};

void CheckBrokenSort(TestChecks& checks)
{
  BadScene scene;
  auto sort = vtkSmartPointer<BrokenSort>::New();
  scene.GetTetrahedraMapper()->SetVisibilitySort(sort);
  scene.RenderTwice();
  CHECK(scene.SaysOnce("repeated, invented or left out 8 cells"));
  CHECK(scene.Statistic("CellsDrawn") == 6.0);
  CHECK(scene.DrawsSomething());
}
}

int TestBadInput(int, char*[])
{
  TestChecks checks;
  CheckMissingInput(checks);
  CheckMissingScalars(checks);
  CheckArrayLengths(checks);
  CheckOutliers(checks);
  CheckDepthPeeling(checks);
  CheckNonFiniteScalars(checks);
  CheckProperty(checks);
  CheckOtherCells(checks);
  CheckBadPoints(checks);
  CheckMatrices(checks);
  CheckWindowWithoutPixels(checks);
  CheckBrokenSort(checks);
  return checks.Result();
}
