// Which cells count as convex: each of the three conditions at its threshold, in either winding;
// and what becomes of cells that are not.
#include "ConvexCellsTesting.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace
{
using namespace ConvexCellsTesting;

std::vector<Point> Cube()
{
  return { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
    { 1, 1, 1 }, { 0, 1, 1 } };
}

// The one cell of these points, in VTK's order, whole or cut up.
void CheckCell(int type, const std::vector<Point>& points, bool convex, const char* name)
{
  for (const double sign : { 1.0, -1.0 })
  {
    auto grid = MakeGrid(points);
    std::vector<vtkIdType> ids(points.size());
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      ids[i] = static_cast<vtkIdType>(i);
      Point p = points[i];
      p[0] *= sign;
      grid->GetPoints()->SetPoint(ids[i], p.data());
    }
    AddCell(grid, type, ids);
    const double volume = std::abs(VolumeWithin(grid));
    auto filter = Run(grid, false);
    vtkUnstructuredGrid* output = filter->GetOutput();
    if (!CHECK_EQUAL(filter->GetNumberOfNonConvexCells(), convex ? 0 : 1) ||
        !CHECK_EQUAL(CountType(output, type), convex ? 1 : 0))
    {
      std::cerr << "  " << name << ", sign " << sign << "\n";
    }
    CHECK(Near(VolumeWithin(output), volume, 1e-9));
    CHECK_EQUAL(filter->GetNumberOfFoldedCells(), 0);
    auto tetrahedra = Run(grid, true);
    CHECK(Near(TotalVolume(tetrahedra->GetOutput()), volume, 1e-9));
    CHECK_EQUAL(tetrahedra->GetNumberOfNonConvexCells(), 0);
    CHECK_EQUAL(tetrahedra->GetNumberOfInvertedCells(), filter->GetNumberOfInvertedCells());
  }
}

// One corner up by `height`: the normals of the top's triangles are acos(1 / (1 + height^2)) apart,
// 60 degrees for a height of 1.
void TestNormals()
{
  for (const double height : { 0.0, 1e-9, 0.3, 0.999, 1.001, 3.0 })
  {
    std::vector<Point> points = Cube();
    points[6][2] += height;
    CheckCell(VTK_HEXAHEDRON, points, height < 1.0, "normals");
  }
}

// A corner pushed in along the diagonal: below 2/3, corner 5 lies outside the triangle 2, 7, 6,
// half of the one face whose diagonal does not end in the corner.
void TestDent()
{
  for (const double t : { 0.9, 0.667, 0.666, 0.3 })
  {
    std::vector<Point> points = Cube();
    points[6] = { t, t, t };
    CheckCell(VTK_HEXAHEDRON, points, t > 2.0 / 3.0, "dent");
  }
}

// A curved layer: bottom and top bend alike by `bend`, and the top is `thickness` above. The top's
// corners at 5 and 7 go through the bottom's triangles where it is thinner than it bends.
void TestThinLayer()
{
  constexpr double bend = 0.2;
  for (const double change : { 0.5, 1e-7, -1e-11, -1e-7, -0.2 })
  {
    std::vector<Point> points = Cube();
    for (int top = 4; top < 8; ++top)
    {
      points[top][2] = bend * (1.0 + change);
    }
    points[2][2] += bend;
    points[6][2] += bend;
    auto grid = MakeGrid(points);
    AddCell(grid, VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 });
    auto filter = Run(grid, false);
    CHECK_EQUAL(filter->GetNumberOfNonConvexCells(), change > -1e-9 ? 0 : 1);
  }
}

void TestPlanarity()
{
  for (const int corners : { 5, 6 })
  {
    for (const double raised : { 0.0, 5e-6, 1e-4, 0.1 })
    {
      std::vector<Point> points(2 * corners);
      for (int i = 0; i < corners; ++i)
      {
        const double angle = 2.0 * 3.14159265358979323846 * i / corners;
        points[i] = { std::cos(angle), std::sin(angle), 0.0 };
        points[i + corners] = { std::cos(angle), std::sin(angle), 1.0 };
      }
      points[corners + 2][2] += raised;
      const int type = corners == 5 ? VTK_PENTAGONAL_PRISM : VTK_HEXAGONAL_PRISM;
      CheckCell(type, points, raised < 1e-5, "planarity");
    }
  }
}

// Only the cells that are not convex are cut, and both sides of a face agree on its triangles.
void TestNeighbours()
{
  std::vector<Point> points = Cube();
  points[6] = { .3, .3, .3 };
  for (const Point& p : Cube())
  {
    points.push_back({ p[0], p[1], p[2] - 1.0 });
  }
  auto grid = MakeGrid(points);
  AddCell(grid, VTK_HEXAHEDRON, { 8, 9, 10, 11, 0, 1, 2, 3 });
  AddCell(grid, VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 });
  auto filter = Run(grid, false);
  CHECK_EQUAL(filter->GetNumberOfNonConvexCells(), 1);
  CHECK_EQUAL(filter->GetOutput()->GetCellType(0), VTK_HEXAHEDRON);
  CHECK_EQUAL(filter->GetOutput()->GetCellType(1), VTK_TETRA);
  CHECK(Near(VolumeWithin(filter->GetOutput()), std::abs(VolumeWithin(grid)), 1e-12));
}

// However a dented hexahedron is numbered: its tetrahedra fill what its faces enclose, or the cell
// is counted as folded. From the smallest id alone, more are.
// In single precision and turned, no side is plane any more, and the flat tetrahedra have either
// sign.
void TestDentNumberings(int precision, double error)
{
  std::mt19937 random(3);
  std::vector<vtkIdType> names(8);
  std::iota(names.begin(), names.end(), vtkIdType{ 0 });
  vtkIdType folded = 0;
  for (int round = 0; round < 300; ++round)
  {
    std::vector<Point> points(8);
    for (int i = 0; i < 8; ++i)
    {
      const Point p = i == 6 ? Point{ .45, .45, .45 } : Cube()[i];
      points[names[i]] = { .48 * p[0] - .6 * p[1] + .64 * p[2], .36 * p[0] + .8 * p[1] + .48 * p[2],
        .6 * p[2] - .8 * p[0] };
    }
    auto grid = MakeGrid(points, precision);
    AddCell(grid, VTK_HEXAHEDRON, names);
    auto filter = Run(grid, round % 2);
    folded += filter->GetNumberOfFoldedCells();
    const double volume = TotalVolume(filter->GetOutput());
    CHECK(Near(volume, VolumeWithin(grid), error));
    std::shuffle(names.begin(), names.end(), random);
  }
  CHECK_EQUAL(folded, 0);
}

// A voxel is a box by definition; one that is not is a hexahedron.
void TestVoxel()
{
  for (const bool isBox : { true, false })
  {
    auto grid = MakeGrid(Cube());
    if (!isBox)
    {
      grid->GetPoints()->SetPoint(6, .3, .3, .3);
    }
    AddCell(grid, VTK_VOXEL, { 0, 1, 3, 2, 4, 5, 7, 6 });
    auto filter = Run(grid, false);
    CHECK_EQUAL(filter->GetNumberOfNonConvexCells(), isBox ? 0 : 1);
    CHECK_EQUAL(filter->GetOutput()->GetCellType(0), isBox ? VTK_HEXAHEDRON : VTK_TETRA);
    CHECK(!isBox || Near(VolumeWithin(filter->GetOutput()), 1.0));
  }
}
}

int TestConvexCellsConvexity(int, char*[])
{
  TestNormals();
  TestDent();
  TestThinLayer();
  TestPlanarity();
  TestNeighbours();
  TestDentNumberings(VTK_DOUBLE, 1e-9);
  TestDentNumberings(VTK_FLOAT, 1e-6);
  TestVoxel();
  return Result();
}
