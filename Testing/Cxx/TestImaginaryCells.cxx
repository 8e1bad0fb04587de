// Cells marked as imaginary sort, but nothing of them is drawn, and nothing is said about it.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkCellData.h"
#include "vtkConvexCells.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

namespace
{
// The cube's six tetrahedra, the cells from `first` on imaginary, and an imaginary polyhedron.
TestMeshes::Grid MarkedCube(vtkIdType first)
{
  auto grid = TestMeshes::SixTetrahedra();
  const vtkIdType peak = grid->GetPoints()->InsertNextPoint(0.0, 0.0, 0.9);
  TestMeshes::SetField(grid, TestMeshes::Waves);
  vtkNew<vtkIdList> faces;
  for (const vtkIdType value :
    std::vector<vtkIdType>{ 4, 3, 4, 5, 6, 3, 5, 4, peak, 3, 6, 5, peak, 3, 4, 6, peak })
  {
    faces->InsertNextId(value);
  }
  grid->InsertNextCell(VTK_POLYHEDRON, faces);
  vtkNew<vtkUnsignedCharArray> imaginary;
  imaginary->SetName("Imaginary");
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    imaginary->InsertNextValue(cell >= first ? 1 : 0);
  }
  grid->GetCellData()->AddArray(imaginary);
  return grid;
}

void CheckFilter(TestChecks& checks, bool tetrahedraOnly)
{
  vtkNew<vtkConvexCells> cells;
  cells->SetTetrahedraOnly(tetrahedraOnly);
  cells->SetInputData(MarkedCube(4));
  cells->Update();
  CHECK(cells->GetOutput()->GetNumberOfCells() == 4);
  CHECK(cells->GetNumberOfImaginaryCells() == 3);
  CHECK(cells->GetNumberOfSkippedCells() == 0);
  CHECK(cells->GetLeftOutSummary().empty());
  // What is left is real: a sort need not look for cells that fill its gaps.
  CHECK(!cells->GetOutput()->GetCellData()->HasArray("Imaginary"));
  cells->SetInputData(MarkedCube(6));
  cells->Update();
  CHECK(cells->GetOutput()->GetNumberOfCells() == 6);
  CHECK(cells->GetNumberOfImaginaryCells() == 1);
}

void CheckMapper(TestChecks& checks)
{
  TestScene scene;
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  scene.SetGrid(TestMeshes::SixTetrahedra());
  scene.Render();
  auto whole = scene.CopyCaptured();
  auto marked = MarkedCube(6);
  scene.Mapper->SetInputData(marked);
  scene.Render();
  CHECK(TestScene::Difference(whole, scene.Mapper->GetCapturedImage()) <= 1e-6);
  vtkTable* table = scene.Mapper->GetLastStatistics();
  CHECK(table->GetValueByName(0, "CellsIn").ToInt() == 7);
  CHECK(table->GetValueByName(0, "CellsDrawn").ToInt() == 6);
  CHECK(table->GetValueByName(0, "CellsSkippedInvalid").ToInt() == 0);
  // Marks that change, change the picture.
  auto* marks = vtkUnsignedCharArray::SafeDownCast(marked->GetCellData()->GetArray("Imaginary"));
  marks->SetValue(0, 1);
  marks->SetValue(1, 1);
  marks->Modified();
  marked->Modified();
  scene.Render();
  CHECK(TestScene::Difference(whole, scene.Mapper->GetCapturedImage()) > 1e-2);
  table = scene.Mapper->GetLastStatistics();
  CHECK(table->GetValueByName(0, "CellsDrawn").ToInt() == 4);
  CHECK(messages->Count() == 0);
}
}

int TestImaginaryCells(int, char*[])
{
  TestChecks checks;
  CheckFilter(checks, false);
  CheckFilter(checks, true);
  CheckMapper(checks);
  return checks.Result();
}
