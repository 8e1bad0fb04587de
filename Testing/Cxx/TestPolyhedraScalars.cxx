// Cell scalars, transfer functions, unit distance, scalars that are not finite, components: as the
// oracle has them.

#include "PolyhedraMeshes.h"
#include "PolyhedraScene.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"

#include <cmath>
#include <limits>

namespace
{
// Of a kind that jumps from cell to cell.
void AddCellScalars(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("cells");
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    values->InsertNextValue((7 * cell % 13) / 12.0);
  }
  grid->GetCellData()->AddArray(values);
}

void CheckCellScalars(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make(), 96, 96);
  auto grid = PolyhedraMeshes::TruncatedOctahedra(2);
  AddCellScalars(grid);
  scene.SetMesh(grid);
  scene.Mapper->SetScalarModeToUseCellFieldData();
  scene.Mapper->SelectScalarArray("cells");
  scene.Oracle->SetCellScalars(true);
  scene.Oracle->SetArrayName("cells");
  for (int view = 0; view < PolyhedraScene::NumberOfViews; ++view)
  {
    scene.SetView(view);
    const PolyhedraScene::Errors errors = scene.CompareWithOracle(mapper.Name + ", cell scalars");
    CHECK(errors.Compared >= 0.0);
    CHECK_AT_MOST(errors.Compared, scene.GetBound());
    // Every cell has an outline here.
    CHECK_AT_MOST(errors.SilhouettePixels, 0.1 * errors.CoveredPixels);
  }
}

void CheckFunctions(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make(), 96, 96);
  scene.SetMesh(PolyhedraMeshes::Hexahedra(3));
  scene.SetSmooth();
  scene.Property->SetScalarOpacityUnitDistance(0.5);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.1);
  scene.Opacity->AddPoint(1.0, 0.6);
  scene.CheckWithOracle(checks, mapper.Name + ", unit distance .5", __LINE__);
  scene.Property->SetScalarOpacityUnitDistance(1.0);
  scene.Color->SetColorSpaceToHSV();
  // Curved between its points, a colour is linear between samples of it.
  CHECK_AT_MOST(scene.CompareWithOracle(mapper.Name + ", HSV").Compared, 1e-4);
  scene.Color->SetColorSpaceToRGB();
  scene.Opacity->AddPoint(0.4, 0.0);
  scene.Opacity->AddPoint(0.45, 0.9);
  scene.Opacity->AddPoint(0.5, 0.1);
  // An extremum's opacity rises by 18 of the scalar's range: the error of its scalar as often.
  const PolyhedraScene::Errors errors = scene.CompareWithOracle(mapper.Name + ", spike");
  CHECK(errors.Compared >= 0.0);
  CHECK_AT_MOST(errors.Compared, scene.IsAdditive() ? 1e-4 : 18e-5);
  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(0.0, 0.2);
  gray->AddPoint(1.0, 0.9);
  scene.Property->SetColor(gray);
  scene.Property->SetScalarOpacity(gray);
  scene.CheckWithOracle(checks, mapper.Name + ", gray", __LINE__);
}

// The unit distance plays no role for an extremum.
void CheckUnitDistance(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make());
  scene.SetMesh(PolyhedraMeshes::Hexahedra(2));
  scene.SetSmooth();
  scene.Render();
  auto before = scene.CopyCaptured();
  scene.Property->SetScalarOpacityUnitDistance(7.0);
  scene.Render();
  const double difference = TestScene::Difference(before, scene.Mapper->GetCapturedImage());
  CHECK(scene.IsAdditive() ? difference > 0.1 : difference == 0.0);
}

vtkIdType CountCellsAt(vtkUnstructuredGrid* grid, vtkIdType first, vtkIdType second)
{
  vtkIdType count = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    count += ids->IsId(first) >= 0 || ids->IsId(second) >= 0 ? 1 : 0;
  }
  return count;
}

void CheckNotFinite(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity() })
  {
    PolyhedraScene scene(mapper.Make(), 96, 96);
    auto grid = PolyhedraMeshes::Hexahedra(3);
    vtkDataArray* scalars = grid->GetPointData()->GetScalars();
    scalars->SetComponent(0, 0, bad);
    scalars->SetComponent(21, 0, bad);
    const vtkIdType invalid = CountCellsAt(grid, 0, 21);
    vtkNew<MessageObserver> messages;
    messages->Watch(scene.Mapper);
    scene.SetMesh(grid);
    scene.SetView(0);
    if (!mapper.ThreePasses)
    {
      // The oracle leaves out cells with such scalars, too.
      scene.CheckWithOracle(checks, mapper.Name + ", not finite", __LINE__);
    }
    scene.Render();
    CHECK(messages->Count() == 1 && messages->CountOf("2 of 64 values that are not finite") == 1);
    CHECK(invalid >= 2 && invalid <= 9);
    CHECK(scene.GetStatistic("CellsSkippedInvalid") == invalid);
    CHECK(scene.GetStatistic("CellsDrawn") == 27 - invalid);
    CHECK(scene.CountLitPixels() > 1000);
  }
}
}

int TestPolyhedraScalars(int, char*[])
{
  TestChecks checks;
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::All())
  {
    if (!mapper.ThreePasses)
    {
      CheckCellScalars(checks, mapper);
      CheckFunctions(checks, mapper);
    }
    CheckUnitDistance(checks, mapper);
    CheckNotFinite(checks, mapper);
  }
  return checks.Result();
}
