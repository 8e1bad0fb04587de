// Every numbering of a hexahedron, wedge and pyramid, and some of prisms: the tetrahedra are
// positive, fill the cell, and cut each quadrilateral along the diagonal from its smallest id.
#include "ConvexCellsTesting.h"
#include "TetrahedralSplit.h"

#include "vtkGenericCell.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <random>

namespace
{
using ConvexCellsTesting::Point;
using TetrahedralSplit::Pieces;
using TetrahedralSplit::Shape;
using Triangle = std::array<int, 3>;
using Faces = std::vector<std::vector<int>>;

struct Model
{
  Shape CellShape;
  int VTKType;
  double Volume;
  std::vector<Point> Points;
  Faces CellFaces;
};

// The faces come from VTK's own cell, not from the code under test.
Model MakeModel(Shape shape, int type, double volume)
{
  Model model = { shape, type, volume, {}, {} };
  auto cell = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    const double* p = cell->GetParametricCoords() + 3 * i;
    model.Points.push_back({ p[0], p[1], p[2] });
    cell->GetPointIds()->SetId(i, i);
    cell->GetPoints()->SetPoint(i, p);
  }
  // The faces rule: VTK's wedge has them inward in its own parametric coordinates.
  if (!ConvexCellsTesting::FacesOutward(cell))
  {
    for (Point& point : model.Points)
    {
      std::swap(point[0], point[1]);
    }
  }
  for (int index = 0; index < cell->GetNumberOfFaces(); ++index)
  {
    vtkIdList* ids = cell->GetFace(index)->GetPointIds();
    model.CellFaces.emplace_back(ids->begin(), ids->end());
  }
  return model;
}

Triangle Sorted(int a, int b, int c)
{
  Triangle triangle = { a, b, c };
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}

std::vector<Triangle> ExpectedBoundary(const Model& model, const std::vector<vtkIdType>& ids)
{
  std::vector<Triangle> triangles;
  for (std::vector<int> face : model.CellFaces)
  {
    const auto byId = [&](int a, int b) { return ids[a] < ids[b]; };
    std::rotate(face.begin(), std::min_element(face.begin(), face.end(), byId), face.end());
    for (std::size_t i = 2; i < face.size(); ++i)
    {
      triangles.push_back(Sorted(face[0], face[i - 1], face[i]));
    }
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::vector<Triangle> BoundaryOf(const Pieces& pieces)
{
  std::map<Triangle, int> uses;
  for (int piece = 0; piece < pieces.Count; ++piece)
  {
    const unsigned char* v = pieces.Vertex[piece];
    for (int skipped = 0; skipped < 4; ++skipped)
    {
      ++uses[Sorted(v[(skipped + 1) % 4], v[(skipped + 2) % 4], v[(skipped + 3) % 4])];
    }
  }
  std::vector<Triangle> boundary;
  for (const auto& use : uses)
  {
    CHECK(use.second <= 2);
    if (use.second == 1)
    {
      boundary.push_back(use.first);
    }
  }
  return boundary;
}

double SixVolumes(const Model& model, const unsigned char* v)
{
  const auto& p = model.Points;
  return TetrahedralSplit::SixVolumes(
    p[v[0]].data(), p[v[1]].data(), p[v[2]].data(), p[v[3]].data());
}

// Returns the number of tetrahedra.
int TestNumbering(const Model& model, const std::vector<vtkIdType>& ids)
{
  const Pieces pieces = TetrahedralSplit::Split(model.CellShape, ids.data());
  double sum = 0.0;
  for (int piece = 0; piece < pieces.Count; ++piece)
  {
    const double volume = SixVolumes(model, pieces.Vertex[piece]) / 6.0;
    CHECK(volume > 0.0);
    sum += volume;
  }
  CHECK(ConvexCellsTesting::Near(sum, model.Volume));
  CHECK(BoundaryOf(pieces) == ExpectedBoundary(model, ids));
  return pieces.Count;
}

std::vector<vtkIdType> NaturalIds(const Model& model)
{
  std::vector<vtkIdType> ids(model.Points.size());
  std::iota(ids.begin(), ids.end(), vtkIdType{ 100 });
  return ids;
}

// How many numberings gave how many tetrahedra.
std::map<int, int> TestEveryNumbering(const Model& model)
{
  std::map<int, int> numbers;
  std::vector<vtkIdType> ids = NaturalIds(model);
  do
  {
    ++numbers[TestNumbering(model, ids)];
  } while (std::next_permutation(ids.begin(), ids.end()));
  return numbers;
}

// A prism has too many numberings to try them all.
std::map<int, int> TestRandomNumberings(const Model& model, int count)
{
  std::map<int, int> numbers;
  std::mt19937 random(7);
  std::vector<vtkIdType> ids = NaturalIds(model);
  for (int i = 0; i < count; ++i)
  {
    std::shuffle(ids.begin(), ids.end(), random);
    ++numbers[TestNumbering(model, ids)];
  }
  return numbers;
}

// VTK's parametric prism stands on z = 0 and is 1 high.
Model MakePrism(Shape shape, int type)
{
  Model model = MakeModel(shape, type, 0.0);
  const std::size_t corners = model.Points.size() / 2;
  for (std::size_t i = 0; i < corners; ++i)
  {
    const Point& p = model.Points[i];
    const Point& q = model.Points[(i + 1) % corners];
    CHECK(p[2] == model.Points[0][2] && std::abs(model.Points[i + corners][2] - p[2]) == 1.0);
    model.Volume += (p[0] * q[1] - p[1] * q[0]) / 2.0;
  }
  model.Volume = std::abs(model.Volume);
  return model;
}

// From any corner of a convex cell; where the usual one is behind a face, from another.
void TestApex(const Model& model)
{
  const auto& solid = TetrahedralSplit::SolidOf(model.CellShape);
  const std::vector<vtkIdType> ids = NaturalIds(model);
  std::vector<Point> points = model.Points;
  auto* coordinates = reinterpret_cast<double(*)[3]>(points.data());
  CHECK_EQUAL(TetrahedralSplit::FindApex(solid, ids.data(), coordinates), 0);
  CHECK_EQUAL(TetrahedralSplit::FindApex(solid, ids.data(), coordinates, -1.0), -1);
  for (int apex = 0; apex < solid.NumberOfVertices; ++apex)
  {
    const Pieces pieces = TetrahedralSplit::Split(model.CellShape, ids.data(), apex);
    CHECK(pieces.Count <= TetrahedralSplit::MaximumPieces);
    double sum = 0.0;
    for (int piece = 0; piece < pieces.Count; ++piece)
    {
      sum += SixVolumes(model, pieces.Vertex[piece]) / 6.0;
    }
    CHECK(ConvexCellsTesting::Near(sum, model.Volume));
    CHECK(BoundaryOf(pieces) == ExpectedBoundary(model, ids));
  }
}

void TestTurned(const Model& model)
{
  Model mirrored = model;
  for (std::size_t i = 0; i < model.Points.size(); ++i)
  {
    const Point& p = model.Points[TetrahedralSplit::TurnedVertex(model.CellShape, int(i))];
    mirrored.Points[i] = { -p[0], p[1], p[2] };
  }
  std::vector<vtkIdType> ids(model.Points.size());
  std::iota(ids.begin(), ids.end(), vtkIdType{ 0 });
  const Pieces pieces = TetrahedralSplit::Split(model.CellShape, ids.data());
  for (int piece = 0; piece < pieces.Count; ++piece)
  {
    CHECK(SixVolumes(mirrored, pieces.Vertex[piece]) > 0.0);
  }
}

void TestSixVolumes()
{
  const double o[3] = { 0, 0, 0 }, x[3] = { 1, 0, 0 }, y[3] = { 0, 1, 0 }, z[3] = { 0, 0, 1 };
  const double low[3] = { .3, .3, 1e-12 }, flat[3] = { .3, .3, 0 };
  CHECK_EQUAL(TetrahedralSplit::SixVolumes(o, x, y, z), 1.0);
  CHECK_EQUAL(TetrahedralSplit::SixVolumes(o, y, x, z), -1.0);
  CHECK_EQUAL(TetrahedralSplit::SixVolumes(o, x, y, low), 1e-12);
  CHECK_EQUAL(TetrahedralSplit::SixVolumes(o, x, y, flat), 0.0);
  // Flat but for rounding: the sign would be noise.
  const double a[3] = { .1, .2, .3 }, b[3] = { .4, .1, .7 }, c[3] = { .25, .15, .5 };
  CHECK_EQUAL(TetrahedralSplit::SixVolumes(a, b, c, z), 0.0);
}
}

int TestTetrahedralSplit(int, char*[])
{
  const Model hexahedron = MakeModel(Shape::Hexahedron, VTK_HEXAHEDRON, 1.0);
  const Model wedge = MakeModel(Shape::Wedge, VTK_WEDGE, 0.5);
  const Model pyramid = MakeModel(Shape::Pyramid, VTK_PYRAMID, 1.0 / 3.0);
  const Model tetrahedron = MakeModel(Shape::Tetrahedron, VTK_TETRA, 1.0 / 6.0);
  const std::map<int, int> hexahedra = TestEveryNumbering(hexahedron);
  CHECK_EQUAL(hexahedra.size(), 2);
  CHECK(hexahedra.count(5) == 1 && hexahedra.count(6) == 1);
  CHECK((TestEveryNumbering(wedge) == std::map<int, int>{ { 3, 720 } }));
  CHECK((TestEveryNumbering(pyramid) == std::map<int, int>{ { 2, 120 } }));
  CHECK((TestEveryNumbering(tetrahedron) == std::map<int, int>{ { 1, 24 } }));
  const Model pentagonal = MakePrism(Shape::PentagonalPrism, VTK_PENTAGONAL_PRISM);
  const Model hexagonal = MakePrism(Shape::HexagonalPrism, VTK_HEXAGONAL_PRISM);
  CHECK((TestRandomNumberings(pentagonal, 2000) == std::map<int, int>{ { 9, 2000 } }));
  CHECK((TestRandomNumberings(hexagonal, 2000) == std::map<int, int>{ { 12, 2000 } }));
  for (const Model& model : { hexahedron, wedge, pyramid, tetrahedron, pentagonal, hexagonal })
  {
    TestTurned(model);
    TestApex(model);
  }
  const vtkIdType lattice[8] = { 0, 1, 11, 10, 100, 101, 111, 110 };
  CHECK_EQUAL(TetrahedralSplit::Split(Shape::Hexahedron, lattice).Count, 6);
  TestSixVolumes();
  return ConvexCellsTesting::Result();
}
