// What goes out, what is carried, what is left out and counted.
#include "ConvexCellsTesting.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <limits>
#include <sstream>

namespace
{
using namespace ConvexCellsTesting;

const std::vector<Point> Cube = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };

// Point data: "height", ten times the id. Cell data: "name" and "number", scalars.
void AddData(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> height;
  height->SetName("height");
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    height->InsertNextValue(10.0 * id);
  }
  grid->GetPointData()->SetScalars(height);
  vtkNew<vtkStringArray> name;
  vtkNew<vtkIntArray> number;
  name->SetName("name");
  number->SetName("number");
  number->SetNumberOfComponents(2);
  for (int cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    name->InsertNextValue("cell " + std::to_string(cell));
    number->InsertNextTuple2(cell, 100 + cell);
  }
  grid->GetCellData()->AddArray(name);
  grid->GetCellData()->SetScalars(number);
}

vtkIdType SourceOf(vtkUnstructuredGrid* output, vtkIdType cell)
{
  return vtkIdTypeArray::SafeDownCast(output->GetCellData()->GetArray("SourceCell"))
    ->GetValue(cell);
}

void CheckCellData(vtkUnstructuredGrid* output)
{
  auto* number = vtkIntArray::SafeDownCast(output->GetCellData()->GetScalars());
  auto* name = vtkStringArray::SafeDownCast(output->GetCellData()->GetAbstractArray("name"));
  if (!CHECK(number && name) || !CHECK(output->GetCellData()->GetArray("SourceCell")))
  {
    return;
  }
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    const vtkIdType source = SourceOf(output, cell);
    CHECK(cell == 0 || SourceOf(output, cell - 1) <= source);
    CHECK_EQUAL(number->GetTypedComponent(cell, 1), 100 + source);
    CHECK_EQUAL(name->GetValue(cell), "cell " + std::to_string(source));
  }
}

void TestWholeCellsAreShared()
{
  auto grid = MakeGrid(Cube);
  AddCell(grid, VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 });
  AddCell(grid, VTK_VOXEL, { 0, 1, 3, 2, 4, 5, 7, 6 });
  AddCell(grid, VTK_WEDGE, { 0, 2, 1, 4, 6, 5 });
  AddCell(grid, VTK_PYRAMID, { 0, 1, 2, 3, 6 });
  AddCell(grid, VTK_TETRA, { 0, 1, 2, 4 });
  AddData(grid);
  auto filter = Run(grid, false);
  auto* output = filter->GetOutput();
  CHECK(output->GetPoints() == grid->GetPoints());
  CHECK(output->GetPointData()->GetScalars() == grid->GetPointData()->GetScalars());
  CHECK_EQUAL(output->GetNumberOfCells(), 5);
  CHECK_EQUAL(output->GetCellType(1), VTK_HEXAHEDRON);
  CHECK_EQUAL(output->GetCellType(2), VTK_WEDGE);
  vtkNew<vtkIdList> ids;
  output->GetCellPoints(1, ids);
  for (int i = 0; i < 8; ++i)
  {
    CHECK_EQUAL(ids->GetId(i), i);
  }
  CheckCellData(output);
  CHECK_EQUAL(filter->GetNumberOfInvertedCells(), 0);
  CHECK(filter->GetLeftOutSummary().empty());

  filter->TetrahedraOnlyOn();
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 6 + 6 + 3 + 2 + 1);
  CHECK(Near(TotalVolume(filter->GetOutput()), 1 + 1 + .5 + 1. / 3 + 1. / 6));
  CHECK(filter->GetOutput()->GetPoints() == grid->GetPoints());
  CheckCellData(filter->GetOutput());
}

void TestInverted()
{
  auto grid = MakeGrid(Cube);
  AddCell(grid, VTK_HEXAHEDRON, { 4, 5, 6, 7, 0, 1, 2, 3 });
  AddCell(grid, VTK_VOXEL, { 4, 5, 7, 6, 0, 1, 3, 2 });
  AddCell(grid, VTK_WEDGE, { 0, 1, 2, 4, 5, 6 });
  AddCell(grid, VTK_PYRAMID, { 0, 3, 2, 1, 6 });
  AddCell(grid, VTK_TETRA, { 0, 2, 1, 4 });
  auto filter = Run(grid, false);
  CHECK_EQUAL(filter->GetNumberOfInvertedCells(), 5);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 5);
  for (vtkIdType cell = 0; cell < filter->GetOutput()->GetNumberOfCells(); ++cell)
  {
    CHECK(FacesOutward(filter->GetOutput()->GetCell(cell)));
    CHECK(!FacesOutward(grid->GetCell(cell)) || grid->GetCellType(cell) == VTK_VOXEL);
  }
  auto tetrahedra = Run(grid, true);
  CHECK_EQUAL(tetrahedra->GetNumberOfInvertedCells(), 5);
  CHECK_EQUAL(tetrahedra->GetNumberOfFoldedCells(), 0);
  CHECK(Near(TotalVolume(tetrahedra->GetOutput()), 1 + 1 + .5 + 1. / 3 + 1. / 6));
}

// Cells 0 to 10, of which 0 and 10 are good.
vtkSmartPointer<vtkUnstructuredGrid> MakeAssortment()
{
  std::vector<Point> points = Cube;
  points.push_back({ std::nan(""), 0, 0 });
  points.push_back({ 0, std::numeric_limits<double>::infinity(), 0 });
  points.push_back({ 3, 3, 3 });
  auto grid = MakeGrid(points);
  AddCell(grid, VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 });
  AddCell(grid, VTK_TRIANGLE, { 0, 1, 2 });
  AddCell(grid, VTK_LINE, { 0, 1 });
  AddCell(grid, VTK_VERTEX, { 0 });
  AddCell(grid, VTK_EMPTY_CELL, {});
  AddCell(grid, 200, { 0, 1, 2, 3 });
  AddCell(grid, VTK_TETRA, { 0, 1, 3, 8 });
  AddCell(grid, VTK_TETRA, { 0, 1, 3, 9 });
  AddCell(grid, VTK_TETRA, { 0, 1, 3, 10 });
  AddCell(grid, VTK_TETRA, { 0, 1, 2, 3 });
  AddCell(grid, VTK_TETRA, { 0, 1, 3, 4 });
  AddData(grid);
  vtkNew<vtkUnsignedCharArray> hidden;
  hidden->SetName(vtkDataSetAttributes::GhostArrayName());
  hidden->SetNumberOfValues(grid->GetNumberOfPoints());
  hidden->FillValue(0);
  hidden->SetValue(10, vtkDataSetAttributes::HIDDENPOINT);
  grid->GetPointData()->AddArray(hidden);
  return grid;
}

void TestLeftOut(bool tetrahedraOnly)
{
  auto grid = MakeAssortment();
  auto filter = Run(grid, tetrahedraOnly);
  auto* output = filter->GetOutput();
  CHECK_EQUAL(filter->GetNumberOfLowerDimensionalCells(), 4);
  CHECK_EQUAL(filter->GetNumberOfUnsupportedCells(), 1);
  CHECK_EQUAL(filter->GetNumberOfNonFiniteCells(), 2);
  CHECK_EQUAL(filter->GetNumberOfGhostCells(), 1);
  CHECK_EQUAL(filter->GetNumberOfZeroVolumeCells(), 1);
  CHECK_EQUAL(filter->GetNumberOfDegenerateCells(), 1);
  CHECK_EQUAL(filter->GetNumberOfDroppedTetrahedra(), 1);
  CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 9);
  CHECK_EQUAL(filter->GetNumberOfMergedPoints(), 0);
  CHECK_EQUAL(output->GetNumberOfCells(), tetrahedraOnly ? 7 : 2);
  CHECK_EQUAL(output->GetNumberOfPoints(), 8);
  CHECK_EQUAL(output->GetBounds()[1], 1.0);
  CHECK_EQUAL(SourceOf(output, output->GetNumberOfCells() - 1), 10);
  CheckCellData(output);
  CHECK_EQUAL(filter->GetLeftOutSummary(),
    std::string("cells left out: 1 vtkEmptyCell (0-D), 1 vtkVertex (0-D), 1 vtkLine (1-D), "
                "1 vtkTriangle (2-D), 1 of type 200 (not supported), 1 of zero volume, "
                "1 ghost or hidden, 2 with a point that is not finite"));
}

void TestGhostCells()
{
  auto grid = MakeGrid(Cube);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (unsigned char bits : { 0, int(vtkDataSetAttributes::DUPLICATECELL),
         int(vtkDataSetAttributes::HIDDENCELL), int(vtkDataSetAttributes::HIGHCONNECTIVITYCELL) })
  {
    AddCell(grid, VTK_TETRA, { 0, 1, 3, 4 });
    ghosts->InsertNextValue(bits);
  }
  grid->GetCellData()->AddArray(ghosts);
  auto filter = Run(grid, false);
  CHECK_EQUAL(filter->GetNumberOfGhostCells(), 2);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 2);
  CHECK_EQUAL(SourceOf(filter->GetOutput(), 1), 3);
}

void TestInvalid()
{
  auto grid = MakeGrid(Cube);
  AddCell(grid, VTK_TETRA, { 0, 1, 3, 8 });
  AddCell(grid, VTK_TETRA, { 0, 1, 3, -1 });
  AddCell(grid, VTK_TETRA, { 0, 1, 3 });
  AddCell(grid, VTK_TETRA, { 0, 1, 3, 4 });
  auto filter = Run(grid, true);
  CHECK_EQUAL(filter->GetNumberOfInvalidCells(), 3);
  CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 3);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 1);

  auto pointless = MakeGrid({});
  AddCell(pointless, VTK_TETRA, { 0, 1, 2, 3 });
  CHECK_EQUAL(Run(pointless, true)->GetNumberOfInvalidCells(), 1);
}

void TestEmpty(bool tetrahedraOnly)
{
  vtkNew<vtkUnstructuredGrid> nothing;
  auto filter = Run(nothing, tetrahedraOnly);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
  CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 0);
  CHECK(filter->GetOutput()->GetCellData()->GetArray("SourceCell") != nullptr);
  auto points = MakeGrid(Cube);
  filter->SetInputData(points);
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 8);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
}

// Counts are of the last update; the output of a filter is a fit input.
void TestAgain()
{
  auto filter = Run(MakeAssortment(), true);
  auto second = vtkSmartPointer<vtkConvexCells>::New();
  second->SetInputConnection(filter->GetOutputPort());
  second->TetrahedraOnlyOn();
  second->Update();
  CHECK_EQUAL(second->GetOutput()->GetNumberOfCells(), 7);
  CHECK_EQUAL(SourceOf(second->GetOutput(), 6), 6);
  CHECK_EQUAL(second->GetNumberOfSkippedCells(), 0);
  filter->SetInputData(MakeGrid(Cube));
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 0);
  CHECK(filter->GetLeftOutSummary().empty());
  std::ostringstream text;
  filter->Print(text);
  CHECK(text.str().find("TetrahedraOnly: On") != std::string::npos);
}

void AbortNow(vtkObject* caller, unsigned long, void*, void*)
{
  static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn();
}

void TestAbort()
{
  auto grid = MakeGrid(Cube);
  AddCell(grid, VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 });
  auto filter = Run(grid, true);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(AbortNow);
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, abort);
  filter->TetrahedraOnlyOff();
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
  filter->RemoveObserver(tag);
  // Up to VTK 9.2 the pipeline takes the flag back by itself.
  filter->AbortExecuteOff();
  filter->Modified();
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 1);
}

void TestSmallIds()
{
  auto grid = MakeGrid(Cube);
  AddCell(grid, VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 });
  AddCell(grid, VTK_TETRA, { 0, 1, 3, 4 });
  CHECK(grid->GetCells()->ConvertTo32BitStorage());
  CHECK_EQUAL(Run(grid, true)->GetOutput()->GetNumberOfCells(), 7);
}
}

int TestConvexCells(int, char*[])
{
  TestWholeCellsAreShared();
  TestInverted();
  for (bool tetrahedraOnly : { false, true })
  {
    TestLeftOut(tetrahedraOnly);
    TestEmpty(tetrahedraOnly);
  }
  TestGhostCells();
  TestInvalid();
  TestAgain();
  TestAbort();
  TestSmallIds();
  return Result();
}
