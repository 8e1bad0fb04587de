/**
 * What must not change the image: the order of the cells, their vertex numbering, the point ids,
 * and cells that draw nothing; and a warped hexahedron is the tetrahedra that fill it.
 */

#include "TestOracleScene.h"

namespace
{
TestOracleBox MakeBox(int cellType)
{
  TestOracleBox box;
  box.CellType = cellType;
  box.Blocks = { 4, 3, 3 };
  box.Field = [](double x, double y, double z)
  { return 0.5 + 0.5 * std::sin(3.0 * x + 1.0) * std::cos(2.0 * y - z); };
  return box;
}

void SetUp(TestOracleScene& scene)
{
  scene.Color->AddRGBPoint(0.4, 0.9, 0.1, 0.3);
  scene.Color->AddRGBPoint(1.0, 0.1, 0.8, 0.6);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.0);
  scene.Opacity->AddPoint(0.3, 0.9);
  scene.Opacity->AddPoint(1.0, 0.2);
}

using Ids = std::vector<vtkIdType>;
using Renumber = std::function<Ids(const Ids& cell, vtkIdType cellId)>;

/** The same cells from the last to the first, each renumbered; `reverse` also reverses the points.
 */
vtkSmartPointer<vtkUnstructuredGrid> Rebuild(
  vtkUnstructuredGrid* source, bool reverse, const Renumber& renumber)
{
  const vtkIdType last = source->GetNumberOfPoints() - 1;
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> scalars;
  for (vtkIdType point = 0; point <= last; ++point)
  {
    const vtkIdType from = reverse ? last - point : point;
    points->InsertNextPoint(source->GetPoint(from));
    scalars->InsertNextValue(source->GetPointData()->GetScalars()->GetComponent(from, 0));
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(scalars);
  for (vtkIdType cellId = source->GetNumberOfCells() - 1; cellId >= 0; --cellId)
  {
    vtkNew<vtkIdList> list;
    source->GetCellPoints(cellId, list);
    Ids ids;
    for (vtkIdType corner = 0; corner < list->GetNumberOfIds(); ++corner)
    {
      ids.push_back(reverse ? last - list->GetId(corner) : list->GetId(corner));
    }
    ids = renumber(ids, cellId);
    grid->InsertNextCell(
      source->GetCellType(cellId), static_cast<vtkIdType>(ids.size()), ids.data());
  }
  return grid;
}

/** Draws both grids in every mode; the images differ by rounding alone. */
void CheckSame(TestOracleChecks& checks, vtkUnstructuredGrid* one, vtkUnstructuredGrid* other)
{
  for (int mode : { 0, 1, 2, 4 })
  {
    TestOracleScene scene, second;
    SetUp(scene);
    SetUp(second);
    scene.Oracle->SetBlendMode(mode);
    second.Oracle->SetBlendMode(mode);
    CHECK_TRUE(checks, scene.Draw(one));
    CHECK_TRUE(checks, second.Draw(other));
    scene.Oracle->Compare(second.Oracle->GetImage());
    CHECK_NEAR(checks, scene.Oracle->GetMaximumError(), 0.0, 1e-12);
    CHECK_TRUE(checks, scene.Oracle->GetNumberOfCoveredPixels() > 50);
  }
}

void CheckNumberings(TestOracleChecks& checks)
{
  const auto permute = [](Ids ids, vtkIdType cellId)
  {
    for (vtkIdType step = 0; step < cellId % 24; ++step)
    {
      std::next_permutation(ids.begin(), ids.end());
    }
    return ids;
  };
  auto tetrahedra = MakeBox(VTK_TETRA).Build();
  CheckSame(checks, tetrahedra, Rebuild(tetrahedra, false, permute));
  CheckSame(checks, tetrahedra, Rebuild(tetrahedra, true, permute));
  // A hexahedron's fans follow the ids, so these stay; it is turned, or turned inside out.
  const auto turn = [](const Ids& c, vtkIdType cellId)
  {
    return cellId % 2 ? Ids{ c[1], c[2], c[3], c[0], c[5], c[6], c[7], c[4] }
                      : Ids{ c[4], c[5], c[6], c[7], c[0], c[1], c[2], c[3] };
  };
  auto hexahedra = MakeBox(VTK_HEXAHEDRON).Build();
  CheckSame(checks, hexahedra, Rebuild(hexahedra, false, turn));
  CheckSame(checks, hexahedra, MakeBox(VTK_VOXEL).Build());
  CheckSame(checks, hexahedra, MakeBox(VTK_POLYHEDRON).Build());
}

/** A triangle, a line, a flat tetrahedron, a tetrahedron with a NaN and a collapsed hexahedron. */
void CheckIgnoredCells(TestOracleChecks& checks)
{
  auto grid = MakeBox(VTK_TETRA).Build();
  const vtkIdType inside[5][8] = { { 0, 30, 55 }, { 0, 55 }, { 0, 1, 5, 6 }, { 0, 30, 4, 0 },
    { 0, 1, 6, 5, 0, 1, 6, 5 } };
  const vtkIdType point = grid->GetPoints()->InsertNextPoint(0.1, 0.2, 0.3);
  vtkDoubleArray::SafeDownCast(grid->GetPointData()->GetScalars())
    ->InsertNextValue(std::numeric_limits<double>::quiet_NaN());
  auto more = vtkSmartPointer<vtkUnstructuredGrid>::New();
  more->DeepCopy(grid);
  const vtkIdType withNaN[4] = { 0, 30, 4, point };
  more->InsertNextCell(VTK_TRIANGLE, 3, inside[0]);
  more->InsertNextCell(VTK_LINE, 2, inside[1]);
  more->InsertNextCell(VTK_TETRA, 4, inside[2]);
  more->InsertNextCell(VTK_TETRA, 4, inside[3]);
  more->InsertNextCell(VTK_HEXAHEDRON, 8, inside[4]);
  more->InsertNextCell(VTK_TETRA, 4, withNaN);
  CheckSame(checks, grid, more);
}

/** One corner pulled out: two of its faces bulge, and twelve tetrahedra from the centre fill it. A
 * linear field is linear in both. */
void CheckWarpedCell(TestOracleChecks& checks)
{
  TestOracleBox box;
  box.Blocks = { 1, 1, 1 };
  auto cell = box.Build();
  cell->GetPoints()->SetPoint(0, -1.3, -1.2, -1.4);
  auto filled = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(cell->GetPoints());
  const vtkIdType center = points->InsertNextPoint(0.0, 0.0, 0.0);
  filled->SetPoints(points);
  vtkNew<vtkDoubleArray> scalars;
  for (vtkIdType point = 0; point <= center; ++point)
  {
    const double* p = points->GetPoint(point);
    scalars->InsertNextValue(0.5 + 0.2 * p[0] + 0.1 * p[1] + 0.15 * p[2]);
  }
  filled->GetPointData()->SetScalars(scalars);
  for (vtkIdType point = 0; point < center; ++point)
  {
    cell->GetPointData()->GetScalars()->SetComponent(point, 0, scalars->GetValue(point));
  }
  // Each face from its smallest id, in the ids of the lattice.
  const vtkIdType loops[6][4] = { { 0, 1, 3, 2 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 },
    { 0, 2, 6, 4 }, { 1, 3, 7, 5 } };
  for (const auto& loop : loops)
  {
    const vtkIdType one[4] = { loop[0], loop[1], loop[2], center };
    const vtkIdType two[4] = { loop[0], loop[2], loop[3], center };
    filled->InsertNextCell(VTK_TETRA, 4, one);
    filled->InsertNextCell(VTK_TETRA, 4, two);
  }
  CheckSame(checks, cell, filled);
}
}

int TestOracleInvariance(int, char*[])
{
  TestOracleChecks checks(__FILE__);
  CheckNumberings(checks);
  CheckIgnoredCells(checks);
  CheckWarpedCell(checks);
  return checks.GetResult();
}
