// M10, M11: voxels, hexahedra, wedges, pyramids, prisms and polyhedra are drawn as they come; a
// triangle among tetrahedra is counted, and the rest drawn.

#include "CellZoo.h"
#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkCellType.h"
#include "vtkConvexCells.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <cmath>

namespace
{
// A prism of unit height about the origin, as the cell of its own type or as a polyhedron with
// every second face inside out.
TestMeshes::Grid Prism(int corners, int type)
{
  auto grid = TestMeshes::Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdList> cell;
  for (int i = 0; i < 2 * corners; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / corners;
    points->InsertNextPoint(0.5 * std::cos(angle), 0.5 * std::sin(angle), i < corners ? -0.5 : 0.5);
    cell->InsertNextId(i);
  }
  if (type == VTK_POLYHEDRON)
  {
    cell->Reset();
    cell->InsertNextId(corners + 2);
    for (int side = 0; side < 2; ++side)
    {
      cell->InsertNextId(corners);
      for (int i = 0; i < corners; ++i)
      {
        cell->InsertNextId(i + side * corners);
      }
    }
    for (int i = 0; i < corners; ++i)
    {
      const int next = (i + 1) % corners;
      for (const int id :
        { 4, i, i % 2 ? next : i + corners, next + corners, i % 2 ? i + corners : next })
      {
        cell->InsertNextId(id);
      }
    }
  }
  grid->SetPoints(points);
  grid->InsertNextCell(type, cell);
  TestMeshes::SetField(grid, TestMeshes::Waves);
  return grid;
}

void CheckType(TestChecks& checks, int type, vtkUnstructuredGrid* grid)
{
  TestScene scene;
  vtkNew<vtkConvexCells> cut;
  cut->SetInputData(grid);
  cut->TetrahedraOnlyOn();
  cut->SetTolerance(5e-2);
  cut->Update();
  scene.Mapper->SetInputData(grid);
  scene.Oracle->SetInputData(cut->GetOutput());
  scene.Mapper->SetTolerance(cut->GetTolerance());
  const double error = scene.MaximumError("cell type " + std::to_string(type));
  CHECK(error >= 0.0);
  CHECK_AT_MOST(error, 1e-4);

  // With a linear field, cutting a cell up changes nothing: the cells themselves are the
  // oracle's.
  TestMeshes::SetField(grid, [](const double* p) { return 0.5 + 0.4 * p[0] - 0.3 * p[2]; });
  scene.Mapper->SetInputData(grid);
  cut->Update();
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

// A prism beside a tetrahedron that lacks a face.
void CheckOpenPolyhedron(TestChecks& checks)
{
  TestScene scene;
  auto grid = Prism(6, VTK_HEXAGONAL_PRISM);
  scene.SetGrid(grid);
  scene.Render();
  auto without = scene.CopyCaptured();
  vtkNew<vtkIdList> open;
  for (const int id : { 3, 3, 0, 1, 2, 3, 0, 1, 6, 3, 1, 2, 6 })
  {
    open->InsertNextId(id);
  }
  grid->InsertNextCell(VTK_POLYHEDRON, open);
  grid->Modified();
  vtkNew<MessageObserver> messages;
  messages->Watch(scene.Mapper);
  scene.Render();
  scene.Render();
  CHECK(TestScene::Difference(without, scene.Mapper->GetCapturedImage()) == 0.0);
  CHECK(scene.CenterPixel()[3] > 0.1);
  CHECK(messages->CountOf("1 vtkPolyhedron (open surface)") == 1 && messages->Count() == 1);
}
}

int TestCellTypes(int, char*[])
{
  TestChecks checks;
  for (const int type : { VTK_VOXEL, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID })
  {
    CheckType(checks, type, TestMeshes::Cube(type));
  }
  CheckType(checks, VTK_PENTAGONAL_PRISM, Prism(5, VTK_PENTAGONAL_PRISM));
  CheckType(checks, VTK_HEXAGONAL_PRISM, Prism(6, VTK_HEXAGONAL_PRISM));
  CheckType(checks, VTK_POLYHEDRON, Prism(7, VTK_POLYHEDRON));
  // In VTK's reference coordinates, moved to about the origin; the field makes curved cells be cut.
  for (const int type : { VTK_CONVEX_POINT_SET, VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON,
         VTK_QUADRATIC_WEDGE, VTK_QUADRATIC_PYRAMID, VTK_LAGRANGE_HEXAHEDRON, VTK_BEZIER_WEDGE })
  {
    auto grid = CellZoo::Reference(type);
    for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
    {
      double x[3];
      grid->GetPoint(id, x);
      grid->GetPoints()->SetPoint(id, x[0] - 0.5, x[1] - 0.5, x[2] - 0.5);
    }
    TestMeshes::SetField(grid, TestMeshes::Waves);
    CheckType(checks, type, grid);
  }
  CheckTriangle(checks);
  CheckOpenPolyhedron(checks);
  return checks.Result();
}
