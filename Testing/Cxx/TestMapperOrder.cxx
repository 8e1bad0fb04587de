// M6, M12: with no sort set the mapper draws any mesh in the right order, concave, hollow, in parts
// and cyclic ones too, and says so.

#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkCellCenterDepthSort.h"
#include "vtkConvexCells.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <cmath>

namespace
{
using Grid = TestMeshes::Grid;

Grid EmptyGrid()
{
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  grid->SetPoints(points);
  return grid;
}

// A hexahedron of the half axes a, b, c about `center`.
void AddBox(vtkUnstructuredGrid* grid, const std::array<double, 3>& center,
  const std::array<double, 3>& a, const std::array<double, 3>& b, const std::array<double, 3>& c)
{
  const int signs[8][3] = { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 },
    { -1, -1, 1 }, { 1, -1, 1 }, { 1, 1, 1 }, { -1, 1, 1 } };
  vtkIdType ids[8];
  for (int i = 0; i < 8; ++i)
  {
    double p[3];
    for (int k = 0; k < 3; ++k)
    {
      p[k] = center[k] + signs[i][0] * a[k] + signs[i][1] * b[k] + signs[i][2] * c[k];
    }
    ids[i] = grid->GetPoints()->InsertNextPoint(p);
  }
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
}

// The near slab is long: the other one's centre is nearer to the eye.
Grid TwoSlabs()
{
  Grid grid = EmptyGrid();
  AddBox(grid, { 0.0, 0.0, 0.15 }, { 1.0, 0.0, 0.0 }, { 0.0, 0.5, 0.0 }, { 0.0, 0.0, 0.05 });
  AddBox(grid, { 0.75, 0.0, -0.15 }, { 0.15, 0.0, 0.0 }, { 0.0, 0.4, 0.0 }, { 0.0, 0.0, 0.05 });
  TestMeshes::SetField(grid, TestMeshes::Waves);
  return grid;
}

// Each bar rises over the beginning of the next: the smallest cycle.
Grid ThreeBars()
{
  Grid grid = EmptyGrid();
  const double third = 2.0943951023931953;
  for (int i = 0; i < 3; ++i)
  {
    const double x0 = 0.6 * std::cos(i * third), y0 = 0.6 * std::sin(i * third);
    const double x1 = 0.6 * std::cos((i + 1) * third), y1 = 0.6 * std::sin((i + 1) * third);
    const double dx = x1 - x0, dy = y1 - y0;
    AddBox(grid, { 0.5 * (x0 + x1), 0.5 * (y0 + y1), 0.0 }, { 0.65 * dx, 0.65 * dy, 0.3 },
      { -0.1 * dy, 0.1 * dx, 0.0 }, { 0.0, 0.0, 0.06 });
  }
  TestMeshes::SetField(grid, TestMeshes::Waves);
  return grid;
}

// A lattice without its inner cells.
Grid HollowBox()
{
  const double size[3] = { 1.0, 1.0, 1.0 };
  const int cells[3] = { 4, 4, 4 };
  Grid lattice = TestMeshes::Slab(size, cells);
  Grid grid = Grid::New();
  grid->SetPoints(lattice->GetPoints());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < lattice->GetNumberOfCells(); ++cell)
  {
    const int at[3] = { static_cast<int>(cell % 4), static_cast<int>(cell / 4 % 4),
      static_cast<int>(cell / 16) };
    const bool inner = at[0] % 3 != 0 && at[1] % 3 != 0 && at[2] % 3 != 0;
    if (!inner)
    {
      lattice->GetCellPoints(cell, ids);
      grid->InsertNextCell(lattice->GetCellType(cell), ids);
    }
  }
  TestMeshes::SetField(grid, TestMeshes::Waves);
  return grid;
}

Grid Lattice()
{
  const double size[3] = { 1.0, 1.0, 1.0 };
  const int cells[3] = { 5, 4, 3 };
  Grid grid = TestMeshes::Slab(size, cells);
  TestMeshes::SetField(grid, TestMeshes::Waves);
  return grid;
}

// Tetrahedra, on which the oracle interpolates as the mapper does.
Grid Cut(const Grid& grid)
{
  vtkNew<vtkConvexCells> cells;
  cells->TetrahedraOnlyOn();
  cells->SetInputData(grid);
  cells->Update();
  return cells->GetOutput();
}

vtkIdType Statistic(TestScene& scene, const char* column)
{
  return scene.Mapper->GetLastStatistics()->GetValueByName(0, column).ToLongLong();
}

// How many cyclic groups there were, all views together.
vtkIdType CheckMesh(TestChecks& checks, const Grid& grid, const std::string& name)
{
  const double eyes[5][3] = { { 0.5, 0.8, 2.2 }, { -1.4, 0.3, -0.9 }, { 2.5, 0.0, 1.0 },
    { 0.0, 0.0, 2.5 }, { 0.3, -0.35, 0.3 } };
  TestScene scene(64, 64);
  scene.GetTetrahedraMapper()->SetVisibilitySort(nullptr);
  scene.GetTetrahedraMapper()->ReportOrderOn();
  scene.SetGrid(Cut(grid));
  scene.SetSpiky();
  vtkIdType cycles = 0;
  for (const auto& eye : eyes)
  {
    scene.LookFrom(eye[0], eye[1], eye[2]);
    for (const bool parallel : { false, true })
    {
      scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
      const double error = scene.MaximumError(name + (parallel ? ", parallel" : ""));
      checks.Check(error >= 0.0, "drawn", __LINE__, name);
      checks.Check(error <= 1e-3, "exact", __LINE__, name + " " + std::to_string(error));
      const vtkIdType groups = Statistic(scene, "Cycles");
      const vtkIdType misordered = Statistic(scene, "MisorderedFaces");
      // Faces inside a group cannot all be in order: those are drawn right per pixel.
      checks.Check(
        groups > 0 || misordered == 0, "in order", __LINE__, name + std::to_string(misordered));
      cycles += groups;
    }
  }
  return cycles;
}

// The picture that VTK's sort gives of the slabs is wrong: what the others are held against.
void CheckSlabsSwapped(TestChecks& checks)
{
  TestScene scene;
  scene.SetGrid(Cut(TwoSlabs()));
  scene.SetSpiky();
  scene.LookFrom(2.5, 0.0, 1.0);
  vtkNew<vtkCellCenterDepthSort> sort;
  scene.GetTetrahedraMapper()->SetVisibilitySort(sort);
  scene.Mapper->SetEngineToRaster();
  CHECK(scene.MaximumError("slabs by their centres") > 1e-2);
  // Tiles repair what a sort gets wrong.
  scene.Mapper->SetEngineToTiles();
  CHECK_AT_MOST(scene.MaximumError("slabs by their centres, repaired"), 1e-4);
  CHECK(Statistic(scene, "RepairedPixels") > 100);
}
}

int TestMapperOrder(int, char*[])
{
  TestChecks checks;
  CheckSlabsSwapped(checks);
  CHECK(CheckMesh(checks, TwoSlabs(), "two slabs") == 0);
  CHECK(CheckMesh(checks, Lattice(), "lattice") == 0);
  CHECK(CheckMesh(checks, HollowBox(), "hollow box") == 0);
  CHECK(CheckMesh(checks, ThreeBars(), "three bars") > 0);
  // The dents in this one's hull are filled with cells that may hide each other in a circle.
  CheckMesh(checks, TestMeshes::Delaunay(300), "Delaunay");
  return checks.Result();
}
