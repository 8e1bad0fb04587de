// A random mixed mesh of the unit cube, in random numberings and windings, as a shared mesh and as
// a soup of cells with points of their own: the tetrahedra are positive, fill the cube and conform.
#include "ConvexCellsTesting.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

namespace
{
using namespace ConvexCellsTesting;
using Ids = std::vector<vtkIdType>;
using Triangle = std::array<vtkIdType, 3>;

constexpr int Size = 6; // cubes along an edge

struct Mesh
{
  std::vector<Point> Points;
  std::vector<int> Types;
  std::vector<Ids> Cells;
};

vtkIdType LatticeId(int i, int j, int k)
{
  return i + (Size + 1) * (j + (Size + 1) * vtkIdType(k));
}

std::vector<Point> LatticePoints(std::mt19937& random)
{
  std::uniform_real_distribution<double> jitter(-.1, .1);
  std::vector<Point> points;
  for (int k = 0; k <= Size; ++k)
  {
    for (int j = 0; j <= Size; ++j)
    {
      for (int i = 0; i <= Size; ++i)
      {
        Point x = { double(i), double(j), double(k) };
        for (double& value : x)
        {
          // The cube's sides stay flat.
          value += value > 0.0 && value < Size ? jitter(random) : 0.0;
        }
        points.push_back(x);
      }
    }
  }
  return points;
}

void AddPyramids(Mesh& mesh, const Ids& c)
{
  Point middle = { 0, 0, 0 };
  for (vtkIdType id : c)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      middle[axis] += mesh.Points[id][axis] / 8.0;
    }
  }
  const auto apex = static_cast<vtkIdType>(mesh.Points.size());
  mesh.Points.push_back(middle);
  const int inward[6][4] = { { 0, 3, 7, 4 }, { 1, 5, 6, 2 }, { 0, 4, 5, 1 }, { 3, 2, 6, 7 },
    { 0, 1, 2, 3 }, { 4, 7, 6, 5 } };
  for (const auto& f : inward)
  {
    mesh.Types.push_back(VTK_PYRAMID);
    mesh.Cells.push_back({ c[f[0]], c[f[1]], c[f[2]], c[f[3]], apex });
  }
}

void AddCube(Mesh& mesh, const Ids& c, bool wedges, unsigned int choice)
{
  if (wedges)
  {
    mesh.Types.insert(mesh.Types.end(), 2, VTK_WEDGE);
    mesh.Cells.push_back({ c[0], c[2], c[1], c[4], c[6], c[5] });
    mesh.Cells.push_back({ c[7], c[6], c[4], c[3], c[2], c[0] }); // the other way up
  }
  else if (choice == 0)
  {
    AddPyramids(mesh, c);
  }
  else if (choice == 1)
  {
    mesh.Types.push_back(VTK_VOXEL);
    mesh.Cells.push_back({ c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6] });
  }
  else if (choice == 2)
  {
    mesh.Types.push_back(VTK_HEXAHEDRON); // inside out
    mesh.Cells.push_back({ c[4], c[5], c[6], c[7], c[0], c[1], c[2], c[3] });
  }
  else if (choice == 3)
  {
    mesh.Types.push_back(VTK_POLYHEDRON);
    mesh.Cells.push_back(c);
  }
  else
  {
    mesh.Types.push_back(VTK_HEXAHEDRON); // on its side
    mesh.Cells.push_back({ c[1], c[2], c[6], c[5], c[0], c[3], c[7], c[4] });
  }
}

Mesh MakeMesh(std::mt19937& random)
{
  Mesh mesh;
  mesh.Points = LatticePoints(random);
  for (int j = 0; j < Size; ++j)
  {
    for (int i = 0; i < Size; ++i)
    {
      const bool wedges = random() % 3 == 0; // by columns: their triangles must meet
      for (int k = 0; k < Size; ++k)
      {
        const Ids corners = { LatticeId(i, j, k), LatticeId(i + 1, j, k),
          LatticeId(i + 1, j + 1, k), LatticeId(i, j + 1, k), LatticeId(i, j, k + 1),
          LatticeId(i + 1, j, k + 1), LatticeId(i + 1, j + 1, k + 1), LatticeId(i, j + 1, k + 1) };
        AddCube(mesh, corners, wedges, random() % 5);
      }
    }
  }
  return mesh;
}

void ShufflePoints(Mesh& mesh, std::mt19937& random)
{
  Ids names(mesh.Points.size());
  std::iota(names.begin(), names.end(), vtkIdType{ 0 });
  std::shuffle(names.begin(), names.end(), random);
  const std::vector<Point> old = mesh.Points;
  for (std::size_t i = 0; i < old.size(); ++i)
  {
    mesh.Points[names[i]] = old[i];
  }
  for (Ids& cell : mesh.Cells)
  {
    for (vtkIdType& id : cell)
    {
      id = names[id];
    }
  }
}

// Every cell with points of its own.
Mesh Soup(const Mesh& mesh)
{
  Mesh soup;
  soup.Types = mesh.Types;
  for (const Ids& cell : mesh.Cells)
  {
    soup.Cells.emplace_back();
    for (vtkIdType id : cell)
    {
      soup.Cells.back().push_back(static_cast<vtkIdType>(soup.Points.size()));
      soup.Points.push_back(mesh.Points[id]);
    }
  }
  return soup;
}

void CheckConforming(vtkUnstructuredGrid* grid)
{
  std::map<Triangle, int> uses;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    for (int skipped = 0; skipped < 4; ++skipped)
    {
      Triangle face = { ids->GetId((skipped + 1) % 4), ids->GetId((skipped + 2) % 4),
        ids->GetId((skipped + 3) % 4) };
      std::sort(face.begin(), face.end());
      ++uses[face];
    }
  }
  double area = 0.0;
  for (const auto& use : uses)
  {
    CHECK(use.second <= 2);
    if (use.second == 1)
    {
      const Point a = PointOf(grid, use.first[0]);
      const Point normal =
        Cross(Minus(PointOf(grid, use.first[1]), a), Minus(PointOf(grid, use.first[2]), a));
      area += std::sqrt(Dot(normal, normal)) / 2.0;
    }
  }
  CHECK(Near(area, 6.0 * Size * Size, 1e-6));
}

void TestMesh(const Mesh& mesh, std::size_t distinctPoints, int precision)
{
  auto grid = MakeGrid(mesh.Points, precision);
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    if (mesh.Types[cell] == VTK_POLYHEDRON)
    {
      Faces faces = BoxFaces(mesh.Cells[cell]);
      std::reverse(faces[cell % 6].begin(), faces[cell % 6].end());
      AddPolyhedron(grid, faces);
    }
    else
    {
      AddCell(grid, mesh.Types[cell], mesh.Cells[cell]);
    }
  }
  auto filter = Run(grid, true);
  vtkUnstructuredGrid* output = filter->GetOutput();
  CHECK_EQUAL(output->GetNumberOfPoints(), distinctPoints);
  CHECK_EQUAL(filter->GetNumberOfMergedPoints(), mesh.Points.size() - distinctPoints);
  CHECK_EQUAL(output->GetPoints()->GetDataType(), precision);
  CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 0);
  CHECK_EQUAL(filter->GetNumberOfDroppedTetrahedra(), 0);
  CHECK(filter->GetNumberOfInvertedCells() > 0);
  CHECK(Near(TotalVolume(output), Size * Size * Size, 1e-6));
  CheckConforming(output);

  auto whole = Run(grid, false);
  CHECK_EQUAL(whole->GetOutput()->GetNumberOfCells(), grid->GetNumberOfCells());
  CHECK_EQUAL(whole->GetNumberOfNonConvexCells(), 0);
  CHECK_EQUAL(CountType(whole->GetOutput(), VTK_POLYHEDRON), CountType(grid, VTK_POLYHEDRON));
  CHECK(CountType(grid, VTK_POLYHEDRON) > 0);
  CHECK(Near(VolumeWithin(whole->GetOutput()), Size * Size * Size, 1e-6));
  CHECK_EQUAL(whole->GetNumberOfInvertedCells(), filter->GetNumberOfInvertedCells());
  for (vtkIdType cell = 0; cell < whole->GetOutput()->GetNumberOfCells(); ++cell)
  {
    CHECK(FacesOutward(whole->GetOutput()->GetCell(cell)));
  }
}
}

int TestConvexCellsConforming(int, char*[])
{
  std::mt19937 random(20240501);
  for (int round = 0; round < 4; ++round)
  {
    Mesh mesh = MakeMesh(random);
    ShufflePoints(mesh, random);
    const int precision = round % 2 ? VTK_FLOAT : VTK_DOUBLE;
    TestMesh(mesh, mesh.Points.size(), precision);
    Mesh soup = Soup(mesh);
    ShufflePoints(soup, random);
    TestMesh(soup, mesh.Points.size(), precision);
  }
  return Result();
}
