// A hexagonal prism with others around it: a pentagonal prism, a hexahedron, a wedge, a polyhedron
// on top. However points are numbered, the tetrahedra conform and fill the cells.
#include "ConvexCellsTesting.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

namespace
{
using namespace ConvexCellsTesting;
using Ids = std::vector<vtkIdType>;

const double Pi = 3.14159265358979323846;
const double Hexagon = 1.5 * std::sqrt(3.0); // area, for a side of 1
const double Pentagon = std::sqrt(25.0 + 10.0 * std::sqrt(5.0)) / 4.0;
const double Triangle = std::sqrt(3.0) / 4.0;

struct Mesh
{
  std::vector<Point> Points;
  std::vector<Ids> Prisms; // by number of corners: 3, 4, 5, 6 above each other
  std::vector<Faces> Polyhedra;
};

vtkIdType AddPoint(Mesh& mesh, const Point& point)
{
  mesh.Points.push_back(point);
  return static_cast<vtkIdType>(mesh.Points.size()) - 1;
}

// A regular prism of `corners` on the edge from one point of the bottom to another, on its right;
// `above`: the id above a bottom point.
void AddPrism(
  Mesh& mesh, int corners, vtkIdType from, vtkIdType to, std::map<vtkIdType, vtkIdType>& above)
{
  Ids bottom = { to, from };
  Point p = mesh.Points[from];
  Point step = Minus(mesh.Points[from], mesh.Points[to]);
  const double turn = 2.0 * Pi / corners;
  for (int i = 2; i < corners; ++i)
  {
    step = { std::cos(turn) * step[0] - std::sin(turn) * step[1],
      std::sin(turn) * step[0] + std::cos(turn) * step[1], 0.0 };
    p = { p[0] + step[0], p[1] + step[1], 0.0 };
    bottom.push_back(AddPoint(mesh, p));
    above[bottom.back()] = AddPoint(mesh, { p[0], p[1], 1.0 });
  }
  Ids prism = bottom;
  for (const vtkIdType id : bottom)
  {
    prism.push_back(above[id]);
  }
  mesh.Prisms.push_back(prism);
}

Mesh MakeMesh()
{
  Mesh mesh;
  std::map<vtkIdType, vtkIdType> above;
  for (const Point& p : { Point{ 0, 0, 0 }, Point{ 1, 0, 0 } })
  {
    const vtkIdType id = AddPoint(mesh, p);
    above[id] = AddPoint(mesh, { p[0], p[1], 1.0 });
  }
  AddPrism(mesh, 6, 2, 0, above);
  const Ids ring = mesh.Prisms[0];
  AddPrism(mesh, 5, ring[0], ring[1], above);
  AddPrism(mesh, 4, ring[2], ring[3], above);
  AddPrism(mesh, 3, ring[4], ring[5], above);
  const Ids top(ring.begin() + 6, ring.end());
  Point apex = { 0, 0, 0 };
  for (const vtkIdType id : top)
  {
    apex = { apex[0] + mesh.Points[id][0] / 6, apex[1] + mesh.Points[id][1] / 6, 2.0 };
  }
  const vtkIdType tip = AddPoint(mesh, apex);
  Faces pyramid = { top };
  for (int i = 0; i < 6; ++i)
  {
    pyramid.push_back({ top[i], top[(i + 1) % 6], tip });
  }
  mesh.Polyhedra.push_back(pyramid);
  return mesh;
}

vtkSmartPointer<vtkUnstructuredGrid> Build(const Mesh& mesh, const Ids& names)
{
  std::vector<Point> points(mesh.Points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[names[i]] = mesh.Points[i];
  }
  const auto rename = [&names](Ids ids)
  {
    std::for_each(ids.begin(), ids.end(), [&names](vtkIdType& id) { id = names[id]; });
    return ids;
  };
  auto grid = MakeGrid(points);
  for (const Ids& prism : mesh.Prisms)
  {
    const int types[] = { VTK_WEDGE, VTK_HEXAHEDRON, VTK_PENTAGONAL_PRISM, VTK_HEXAGONAL_PRISM };
    AddCell(grid, types[prism.size() / 2 - 3], rename(prism));
  }
  for (Faces faces : mesh.Polyhedra)
  {
    std::transform(faces.begin(), faces.end(), faces.begin(), rename);
    AddPolyhedron(grid, faces);
  }
  return grid;
}

// The area of the triangles that belong to one tetrahedron only.
double FreeArea(vtkUnstructuredGrid* grid)
{
  std::map<Ids, int> uses;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    for (int left = 0; left < 4; ++left)
    {
      Ids face = { ids->GetId((left + 1) % 4), ids->GetId((left + 2) % 4),
        ids->GetId((left + 3) % 4) };
      std::sort(face.begin(), face.end());
      ++uses[face];
    }
  }
  double area = 0.0;
  for (const auto& use : uses)
  {
    CHECK(use.second <= 2);
    const Point a = PointOf(grid, use.first[0]);
    const Point normal =
      Cross(Minus(PointOf(grid, use.first[1]), a), Minus(PointOf(grid, use.first[2]), a));
    area += use.second == 1 ? std::sqrt(Dot(normal, normal)) / 2.0 : 0.0;
  }
  return area;
}

void TestNumbering(const Mesh& mesh, const Ids& names)
{
  const double pyramid = Hexagon / 3.0;
  const double slope = 6.0 * std::sqrt(0.75 + 1.0) / 2.0;
  const double floors = Hexagon + Pentagon + 1.0 + Triangle;
  auto grid = Build(mesh, names);
  auto tetrahedra = Run(grid, true);
  CHECK_EQUAL(tetrahedra->GetNumberOfSkippedCells(), 0);
  CHECK_EQUAL(tetrahedra->GetNumberOfFoldedCells(), 0);
  CHECK(Near(TotalVolume(tetrahedra->GetOutput()), floors + pyramid, 1e-12));
  // Floors, the tops but the hexagon's, 3 + 4 + 3 + 2 walls of 1, the pyramid's side.
  CHECK(Near(FreeArea(tetrahedra->GetOutput()), 2.0 * floors - Hexagon + 12.0 + slope, 1e-12));

  auto whole = Run(grid, false);
  CHECK_EQUAL(whole->GetNumberOfNonConvexCells(), 0);
  CHECK_EQUAL(whole->GetOutput()->GetNumberOfCells(), grid->GetNumberOfCells());
  const double expected[] = { Hexagon, Pentagon, 1.0, Triangle, pyramid };
  for (vtkIdType cell = 0; cell < 5; ++cell)
  {
    CHECK_EQUAL(whole->GetOutput()->GetCellType(cell), grid->GetCellType(cell));
    CHECK(Near(VolumeWithin(whole->GetOutput()->GetCell(cell)), expected[cell], 1e-12));
  }
}
}

int TestConvexCellsPrisms(int, char*[])
{
  const Mesh mesh = MakeMesh();
  Ids names(mesh.Points.size());
  std::iota(names.begin(), names.end(), vtkIdType{ 0 });
  std::mt19937 random(11);
  for (int round = 0; round < 200; ++round)
  {
    TestNumbering(mesh, names);
    std::shuffle(names.begin(), names.end(), random);
  }
  return Result();
}
