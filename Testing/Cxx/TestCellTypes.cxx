// M10, M11: voxels, hexahedra, wedges and pyramids are drawn as they come; a triangle among
// tetrahedra is counted, and the rest drawn.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkCellType.h"
#include "vtkConvexCells.h"
#include "vtkTable.h"
#include "vtkVariant.h"

namespace
{
void CheckType(TestChecks& checks, int type)
{
  TestScene scene;
  auto grid = TestMeshes::Cube(type);
  vtkNew<vtkConvexCells> cut;
  cut->SetInputData(grid);
  cut->TetrahedraOnlyOn();
  cut->Update();
  scene.Mapper->SetInputData(grid);
  scene.Oracle->SetInputData(cut->GetOutput());
  const double error = scene.MaximumError("cell type " + std::to_string(type));
  CHECK(error >= 0.0);
  CHECK_AT_MOST(error, 1e-4);

  // With a linear field, cutting a cell up changes nothing: the cells themselves are the
  // oracle's.
  TestMeshes::SetField(grid, [](const double* p) { return 0.5 + 0.4 * p[0] - 0.3 * p[2]; });
  scene.SetGrid(grid);
  const double linearError = scene.MaximumError("linear, type " + std::to_string(type));
  CHECK(linearError >= 0.0);
  CHECK_AT_MOST(linearError, 1e-4);
}

void CheckTriangle(TestChecks& checks)
{
  TestScene scene;
  auto grid = TestMeshes::SixTetrahedra();
  scene.SetGrid(grid);
  scene.Render();
  auto without = scene.CopyCaptured();
  const vtkIdType triangle[3] = { 0, 1, 2 };
  grid->InsertNextCell(VTK_TRIANGLE, 3, triangle);
  grid->Modified();
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  scene.Render();
  scene.Render();
  CHECK(TestScene::Difference(without, scene.Mapper->GetCapturedImage()) == 0.0);
  CHECK(scene.CenterPixel()[3] > 0.1);
  CHECK(messages->CountOf("1 vtkTriangle") == 1 && messages->Count() == 1);
  vtkTable* statistics = scene.Mapper->GetLastStatistics();
  CHECK(statistics->GetValueByName(0, "CellsIn").ToInt() == 7);
  CHECK(statistics->GetValueByName(0, "CellsDrawn").ToInt() == 6);
  CHECK(statistics->GetValueByName(0, "CellsSkippedInvalid").ToInt() == 1);
}
}

int TestCellTypes(int, char*[])
{
  TestChecks checks;
  for (const int type : { VTK_VOXEL, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID })
  {
    CheckType(checks, type);
  }
  CheckTriangle(checks);
  return checks.Result();
}
