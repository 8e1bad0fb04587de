// Images, rectilinear and structured grids and composite data go into a mapper as they are, and are
// drawn as the unstructured grid of all their cells; blocks without the array are named.
#include "TestScene.h"

#include "vtkAppendFilter.h"
#include "vtkCompositeDataSet.h"
#include "vtkConvexCells.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <cmath>

namespace
{
template <typename Array = vtkDoubleArray>
void AddField(vtkDataSet* data, const char* name = "scalar")
{
  vtkNew<Array> values;
  values->SetName(name);
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    const double* x = data->GetPoint(id);
    values->InsertNextValue(0.5 + 0.3 * x[0] - 0.2 * x[1] + 0.15 * x[2]);
  }
  data->GetPointData()->SetScalars(values);
}

// Four cells along x, from `from` to `from` + 1.
vtkSmartPointer<vtkImageData> Image(double from)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(5, 4, 3);
  image->SetOrigin(from, -0.5, -0.5);
  image->SetSpacing(0.25, 1.0 / 3.0, 0.5);
  AddField(image);
  return image;
}

vtkSmartPointer<vtkRectilinearGrid> Rectilinear()
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(3, 3, 3);
  vtkNew<vtkDoubleArray> places;
  for (const double place : { -0.5, 0.2, 0.5 })
  {
    places->InsertNextValue(place);
  }
  grid->SetXCoordinates(places);
  grid->SetYCoordinates(places);
  grid->SetZCoordinates(places);
  AddField(grid);
  return grid;
}

vtkSmartPointer<vtkStructuredGrid> Structured(int blankCell)
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 27; ++i)
  {
    const double x = 0.5 * (i % 3) - 0.5, y = 0.5 * (i / 3 % 3) - 0.5;
    points->InsertNextPoint(x + 0.125 * y, y - 0.25 * x, 0.5 * (i / 9) - 0.5);
  }
  grid->SetDimensions(3, 3, 3);
  grid->SetPoints(points);
  AddField(grid);
  if (blankCell >= 0)
  {
    grid->BlankCell(blankCell);
  }
  return grid;
}

// The oracle has the same cells from VTK's own filter.
void CheckInput(TestChecks& checks, const std::string& name, vtkDataObject* input,
  const std::vector<vtkDataSet*>& parts, vtkIdType cells)
{
  TestScene scene;
  vtkNew<vtkAppendFilter> append;
  for (vtkDataSet* part : parts)
  {
    append->AddInputData(part);
  }
  append->Update();
  vtkNew<vtkConvexCells> convex;
  convex->SetInputConnection(append->GetOutputPort());
  convex->TetrahedraOnlyOn();
  convex->Update();
  scene.Mapper->SetInputDataObject(0, input);
  scene.Oracle->SetInputData(convex->GetOutput());
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  double bounds[6];
  scene.Mapper->GetBounds(bounds);
  for (int i = 0; i < 6; ++i)
  {
    CHECK_NEAR(bounds[i], append->GetOutput()->GetBounds()[i], 1e-12);
  }
  scene.Renderer->ResetCamera();
  const double error = scene.MaximumError(name);
  CHECK(error >= 0.0);
  CHECK_AT_MOST(error, 1e-4);
  CHECK(messages->Count() == 0);
  CHECK(scene.Mapper->GetLastStatistics()->GetValueByName(0, "CellsIn").ToInt() == cells);
  // Not a second time where nothing has changed.
  scene.Render();
  CHECK(scene.CenterPixel()[3] > 0.1);
}

// Drawn as the grid without the cell.
void CheckBlanked(TestChecks& checks)
{
  TestScene scene;
  auto blanked = Structured(3);
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(blanked);
  vtkNew<vtkConvexCells> convex;
  convex->SetInputConnection(append->GetOutputPort());
  convex->Update();
  CHECK(convex->GetOutput()->GetNumberOfCells() == 7);
  scene.Mapper->SetInputData(convex->GetOutput());
  scene.Render();
  auto without = scene.CopyCaptured();
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  scene.Mapper->SetInputData(blanked);
  scene.Render();
  CHECK(TestScene::Difference(without, scene.Mapper->GetCapturedImage()) == 0.0);
  CHECK(messages->CountOf("1 ghost or hidden") == 1 && messages->Count() == 1);
  CHECK(scene.Mapper->GetLastStatistics()->GetValueByName(0, "CellsSkippedInvalid").ToInt() == 1);
}

void CheckComposites(TestChecks& checks)
{
  auto left = Image(-1.0);
  auto right = Image(0.0);
  vtkNew<vtkMultiBlockDataSet> inner, blocks;
  inner->SetBlock(0, right);
  blocks->SetBlock(0, left);
  blocks->SetBlock(1, inner);
  blocks->SetBlock(2, nullptr);
  CheckInput(checks, "multi-block", blocks, { left, right }, 48);
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, left);
  partitions->SetPartition(1, right);
  CheckInput(checks, "partitioned", partitions, { left, right }, 48);
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartitionedDataSet(0, partitions);
  CheckInput(checks, "collection", collection, { left, right }, 48);
}

// One block of four has the array, another type of it, none, and no cells.
void CheckOthers(TestChecks& checks)
{
  TestScene scene;
  auto good = Image(-0.5);
  auto floats = Image(3.0);
  AddField<vtkFloatArray>(floats);
  auto other = Image(5.0);
  other->GetPointData()->Initialize();
  AddField(other, "pressure");
  vtkNew<vtkUnstructuredGrid> empty;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, good);
  blocks->SetBlock(1, floats);
  blocks->SetBlock(2, other);
  blocks->SetBlock(3, empty);
  blocks->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "inlet");
  scene.Mapper->SetScalarModeToUsePointFieldData();
  scene.Mapper->SelectScalarArray("scalar");
  scene.Mapper->SetInputData(blocks);
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  scene.Render();
  scene.Render();
  CHECK(messages->Count() == 1);
  CHECK(messages->CountOf("3 of 4 blocks are left out") == 1);
  CHECK(messages->CountOf("inlet (the point data of the input have no array scalar") == 1);
  CHECK(messages->CountOf("another type of array") == 1);
  CHECK(messages->CountOf("no cells") == 1);
  CHECK(scene.Mapper->GetLastStatistics()->GetValueByName(0, "CellsIn").ToInt() == 24);
  CHECK(scene.CenterPixel()[3] > 0.1);

  // A new field in a block is seen.
  auto before = scene.CopyCaptured();
  good->GetPointData()->GetScalars()->FillComponent(0, 0.9);
  good->GetPointData()->GetScalars()->Modified();
  good->Modified();
  scene.Render();
  CHECK(TestScene::Difference(before, scene.Mapper->GetCapturedImage()) > 1e-3);

  // Nothing to draw.
  TestScene nothing;
  vtkNew<vtkMultiBlockDataSet> noBlocks;
  vtkNew<MessageObserver> errors;
  errors->Watch(nothing.Mapper);
  nothing.Mapper->SetInputData(noBlocks);
  nothing.Render();
  CHECK(errors->CountOf("0 points and 0 cells") == 1);
}
}

int TestMapperInputs(int, char*[])
{
  TestChecks checks;
  auto image = Image(-0.5);
  CheckInput(checks, "image", image, { image }, 24);
  auto rectilinear = Rectilinear();
  CheckInput(checks, "rectilinear", rectilinear, { rectilinear }, 8);
  auto structured = Structured(-1);
  CheckInput(checks, "structured", structured, { structured }, 8);
  CheckBlanked(checks);
  CheckComposites(checks);
  CheckOthers(checks);
  return checks.Result();
}
