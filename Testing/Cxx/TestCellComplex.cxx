// Cells of all types side by side, whatever their winding and numbering: contacts, sides, boundary.

#include "CellComplex.h"
#include "CellComplexReader.h"
#include "ConvexCellsTesting.h"
#include "ExactOrientation.h"

#include <algorithm>
#include <limits>
#include <set>

namespace
{
using namespace ConvexCellsTesting;

// On the side of smaller x, with the square 0 <= y, z <= 1 at x = 0 as a face.
struct Shape
{
  int Type;
  std::vector<Point> Points;
  std::vector<std::vector<vtkIdType>> Faces;
};

std::vector<Point> Prism(const std::vector<Point>& base)
{
  std::vector<Point> points = base;
  for (const Point& p : base)
  {
    points.push_back({ p[0], p[1], 1.0 });
  }
  return points;
}

std::vector<Shape> Shapes()
{
  const std::vector<Point> square = { { -1, 0, 0 }, { 0, 0, 0 }, { 0, 1, 0 }, { -1, 1, 0 } };
  const std::vector<Point> pixel = { { -1, 0, 0 }, { 0, 0, 0 }, { -1, 1, 0 }, { 0, 1, 0 } };
  const std::vector<Point> triangle = { { -1, 0, 0 }, { 0, 0, 0 }, { 0, 1, 0 } };
  std::vector<Point> pentagon = square;
  pentagon.push_back({ -1.5, 0.5, 0 });
  std::vector<Point> hexagon = square;
  hexagon.push_back({ -1.5, 0.75, 0 });
  hexagon.push_back({ -1.5, 0.25, 0 });
  const std::vector<Point> pyramid = { { 0, 0, 0 }, { 0, 1, 0 }, { 0, 1, 1 }, { 0, 0, 1 },
    { -1, 0.5, 0.5 } };
  return { { VTK_HEXAHEDRON, Prism(square), {} }, { VTK_VOXEL, Prism(pixel), {} },
    { VTK_WEDGE, Prism(triangle), {} }, { VTK_PYRAMID, pyramid, {} },
    { VTK_PENTAGONAL_PRISM, Prism(pentagon), {} }, { VTK_HEXAGONAL_PRISM, Prism(hexagon), {} },
    { VTK_POLYHEDRON, pyramid,
      { { 2, 1, 0, 3 }, { 4, 1, 0 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } } } };
}

// With points of its own, numbered on from those of the grid.
void AddShape(vtkUnstructuredGrid* grid, const Shape& shape, bool mirrored)
{
  const vtkIdType first = grid->GetNumberOfPoints();
  vtkNew<vtkIdList> ids;
  for (const Point& p : shape.Points)
  {
    ids->InsertNextId(grid->GetPoints()->InsertNextPoint(mirrored ? -p[0] : p[0], p[1], p[2]));
  }
  if (shape.Type == VTK_POLYHEDRON)
  {
    ids->Reset();
    ids->InsertNextId(static_cast<vtkIdType>(shape.Faces.size()));
    for (const auto& face : shape.Faces)
    {
      ids->InsertNextId(static_cast<vtkIdType>(face.size()));
      std::for_each(
        face.begin(), face.end(), [&](vtkIdType corner) { ids->InsertNextId(first + corner); });
    }
  }
  grid->InsertNextCell(shape.Type, ids);
}

CellComplex Read(vtkUnstructuredGrid* grid)
{
  CellComplex complex;
  CellComplexReader::Read(grid, complex);
  return complex;
}

int SideOf(const CellComplex& complex, const int points[3], const double p[3])
{
  const double* x = complex.Points.data();
  return ExactOrientation::SideOfPoint(x + 3 * points[0], x + 3 * points[1], x + 3 * points[2], p);
}

// The boundary's triangles run against each other along all edges.
void CheckClosed(const CellComplex& complex)
{
  std::multiset<std::pair<int, int>> edges;
  for (const auto& triangle : complex.Boundary)
  {
    for (int i = 0; i < 3; ++i)
    {
      edges.insert({ triangle.Points[i], triangle.Points[(i + 1) % 3] });
    }
  }
  for (const auto& edge : edges)
  {
    CHECK_EQUAL(edges.count({ edge.second, edge.first }), edges.count(edge));
  }
}

// Cells[0] on the side of the normal; boundary closed, and pointing away from its cells.
void CheckSides(const CellComplex& complex)
{
  for (const auto& contact : complex.Contacts)
  {
    CHECK(contact.Points[0] < contact.Points[1] && contact.Points[1] < contact.Points[2]);
    CHECK_EQUAL(SideOf(complex, contact.Points, &complex.Centers[3 * contact.Cells[0]]), 1);
    CHECK_EQUAL(SideOf(complex, contact.Points, &complex.Centers[3 * contact.Cells[1]]), -1);
  }
  for (const auto& triangle : complex.Boundary)
  {
    CHECK_EQUAL(SideOf(complex, triangle.Points, &complex.Centers[3 * triangle.Cell]), -1);
  }
  CheckClosed(complex);
}

void CheckCounts(const CellComplex& complex, int contacts, int nonManifold, int overlapping)
{
  CHECK_EQUAL(static_cast<int>(complex.Contacts.size()), contacts);
  CHECK_EQUAL(complex.NumberOfNonManifoldFaces, nonManifold);
  CHECK_EQUAL(complex.NumberOfOverlappingFaces, overlapping);
}

// The square is planar: one contact. Mirrored cells are inside out, the points are double.
void TestPairs()
{
  for (const Shape& left : Shapes())
  {
    for (const Shape& right : Shapes())
    {
      auto grid = MakeGrid({});
      AddShape(grid, left, false);
      AddShape(grid, right, true);
      const CellComplex complex = Read(grid);
      CheckCounts(complex, 1, 0, 0);
      CheckSides(complex);
    }
  }
}

// Two tetrahedra against every shape, cut from the square's smallest id.
void TestTetrahedraAgainstSquare()
{
  const Point square[4] = { { 0, 0, 0 }, { 0, 1, 0 }, { 0, 1, 1 }, { 0, 0, 1 } };
  for (const Shape& shape : Shapes())
  {
    auto grid = MakeGrid({});
    AddShape(grid, shape, false);
    const auto isOnSquare = [](const Point& p) { return p[0] == 0.0; };
    const Point smallest = *std::find_if(shape.Points.begin(), shape.Points.end(), isOnSquare);
    const auto begin = std::find(square, square + 4, smallest) - square;
    std::vector<vtkIdType> ids;
    for (int i = 0; i < 4; ++i)
    {
      ids.push_back(grid->GetPoints()->InsertNextPoint(square[(begin + i) % 4].data()));
    }
    const vtkIdType apex = grid->GetPoints()->InsertNextPoint(1.0, 0.5, 0.5);
    AddCell(grid, VTK_TETRA, { ids[0], ids[1], ids[2], apex });
    AddCell(grid, VTK_TETRA, { apex, ids[0], ids[3], ids[2] });
    const CellComplex complex = Read(grid);
    CheckCounts(complex, 3, 0, 0);
    CheckSides(complex);
  }
}

// A warped face is two contacts, whichever way its cells name it.
void TestWarpedFace()
{
  const Shape cube = Shapes()[0];
  auto grid = MakeGrid({});
  Shape left = cube;
  left.Points[2][0] = 0.25;
  Shape right = left;
  right.Points[0][0] = right.Points[3][0] = right.Points[4][0] = right.Points[7][0] = 1.0;
  AddShape(grid, left, false);
  AddShape(grid, right, false);
  CheckCounts(Read(grid), 2, 0, 0);
}

// Thin cells of a crushed plate: the face that they share is so warped that corners on the far side
// of it stand on its near side. Whichever way the cells list their corners, one is on either side.
void TestCrushedCells()
{
  const std::vector<Point> points = { { -0.154, -0.923, -14.925 }, { -0.771, -0.620, -14.942 },
    { 0.087, -0.634, -14.751 }, { -0.540, -0.286, -14.805 }, { -0.211, -1.041, -14.980 },
    { -0.829, -0.734, -14.988 }, { 0.095, -0.701, -14.708 }, { -0.537, -0.345, -14.777 },
    { -0.242, -1.107, -14.983 }, { -0.861, -0.798, -14.992 }, { 0.120, -0.748, -14.687 },
    { -0.516, -0.378, -14.768 } };
  for (const bool turned : { false, true })
  {
    auto grid = MakeGrid(points);
    for (vtkIdType first = 0; first < 8; first += 4)
    {
      std::vector<vtkIdType> ids = { 0, 1, 5, 4, 2, 3, 7, 6 };
      std::for_each(ids.begin(), ids.end(), [first](vtkIdType& id) { id += first; });
      if (turned)
      {
        std::swap_ranges(ids.begin(), ids.begin() + 4, ids.begin() + 4);
      }
      AddCell(grid, VTK_HEXAHEDRON, ids);
    }
    const CellComplex complex = Read(grid);
    CheckCounts(complex, 2, 0, 0);
    CHECK_EQUAL(static_cast<int>(complex.Boundary.size()), 20);
    CheckClosed(complex);
  }
}

// A corner in the middle of an edge: part of the fan from the smallest id has no area and must not
// speak for the rest. The face is cut otherwise, and every contact has a side.
void TestCornerOnEdge()
{
  Shape shape = Shapes().back();
  shape.Points.push_back({ 0, 0.5, 0 });
  shape.Faces = { { 5, 0, 3, 2, 1 }, { 4, 0, 5, 1 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } };
  auto grid = MakeGrid({});
  AddShape(grid, shape, false);
  AddShape(grid, shape, true);
  const CellComplex complex = Read(grid);
  const double eye[3] = { -3.0, 0.2, 0.3 };
  int sides = 0;
  for (const auto& contact : complex.Contacts)
  {
    sides += SideOf(complex, contact.Points, eye) != 0;
  }
  CHECK_EQUAL(sides, 2); // one for each smallest id of its triangles
  CHECK_EQUAL(static_cast<int>(complex.Contacts.size()), sides);
}

// Four tetrahedra, two on either side of a flat one, that see different diagonals of it.
void TestFlatCell()
{
  for (const std::vector<vtkIdType>& flat :
    { std::vector<vtkIdType>{ 0, 1, 2, 3 }, std::vector<vtkIdType>{ 1, 0, 2, 3 } })
  {
    auto grid = MakeGrid(
      { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0.5, 0.5, 1 }, { 0.5, 0.5, -1 } });
    AddCell(grid, VTK_TETRA, flat);
    AddCell(grid, VTK_TETRA, { 0, 1, 2, 4 });
    AddCell(grid, VTK_TETRA, { 0, 2, 3, 4 });
    AddCell(grid, VTK_TETRA, { 0, 1, 3, 5 });
    AddCell(grid, VTK_TETRA, { 1, 2, 3, 5 });
    const CellComplex complex = Read(grid);
    CheckCounts(complex, 6, 0, 0);
    const double above[3] = { 0.5, 0.5, 1.0 };
    for (const auto& contact : complex.Contacts)
    {
      const int upper = SideOf(complex, contact.Points, above) > 0 ? 0 : 1;
      const bool touchesFlat = contact.Cells[0] == 0 || contact.Cells[1] == 0;
      const int other = contact.Cells[0] + contact.Cells[1];
      CHECK(!touchesFlat || contact.Cells[upper] == (other <= 2 ? other : 0));
    }
  }
}

void TestNoComplex()
{
  auto grid =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.5, 0.1, 1 }, { 0, 0, -1 } });
  AddCell(grid, VTK_TETRA, { 0, 1, 2, 3 });
  AddCell(grid, VTK_TETRA, { 0, 1, 2, 4 });
  CheckCounts(Read(grid), 0, 0, 1);
  AddCell(grid, VTK_TETRA, { 0, 1, 2, 5 });
  const CellComplex three = Read(grid);
  CHECK_EQUAL(static_cast<int>(three.Contacts.size()), 2);
  CHECK_EQUAL(three.NumberOfNonManifoldFaces, 1);

  auto twice = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } });
  AddCell(twice, VTK_TETRA, { 0, 1, 2, 3 });
  AddCell(twice, VTK_TETRA, { 2, 1, 0, 3 });
  CheckCounts(Read(twice), 0, 0, 4);
}

// The box about the centres, which sorts measure rounding by.
void TestCenterBox()
{
  auto grid = MakeGrid({});
  AddShape(grid, Shapes().front(), false);
  AddShape(grid, Shapes().front(), true);
  const CellComplex complex = Read(grid);
  double bounds[6];
  complex.CenterBox.GetBounds(bounds);
  const double expected[6] = { -0.5, 0.5, 0.5, 0.5, 0.5, 0.5 };
  CHECK(std::equal(bounds, bounds + 6, expected));
  CHECK_EQUAL(complex.GetSize(), 1.0);
  CHECK_EQUAL(Read(MakeGrid({})).GetSize(), 0.0);
}

// Neither has faces; both keep their numbers.
void TestCellsWithoutFaces()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  auto grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { nan, 0, 1 } });
  AddCell(grid, VTK_TRIANGLE, { 0, 1, 2 });
  AddCell(grid, VTK_TETRA, { 0, 1, 2, 4 });
  AddCell(grid, VTK_TETRA, { 0, 1, 2, 3 });
  const CellComplex complex = Read(grid);
  CHECK_EQUAL(complex.NumberOfCells, 3);
  CheckCounts(complex, 0, 0, 0);
  CHECK_EQUAL(static_cast<int>(complex.Boundary.size()), 4);
  for (const auto& triangle : complex.Boundary)
  {
    CHECK_EQUAL(triangle.Cell, 2);
  }
}
}

int TestCellComplex(int, char*[])
{
  TestPairs();
  TestTetrahedraAgainstSquare();
  TestWarpedFace();
  TestCrushedCells();
  TestCornerOnEdge();
  TestFlatCell();
  TestNoComplex();
  TestCellsWithoutFaces();
  TestCenterBox();
  return Result();
}
