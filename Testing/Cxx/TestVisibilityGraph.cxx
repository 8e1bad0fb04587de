// The order of the graph against the exact sign of every contact: lattices seen along faces and
// diagonals, jittered, shuffled and Delaunay ones, eyes inside, on faces and at corners; circles;
// when an order is kept.

#include "CellComplex.h"
#include "CellComplexReader.h"
#include "ExactOrientation.h"
#include "SortMeshes.h"
#include "SortTesting.h"
#include "TestScene.h"
#include "VisibilityGraph.h"

#include "vtkCellArray.h"
#include "vtkDelaunay3D.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <random>

namespace
{
class GraphOf
{
public:
  explicit GraphOf(vtkUnstructuredGrid* grid)
  {
    CellComplexReader::Read(grid, this->Complex);
    this->Graph.Build(this->Complex, nullptr);
  }

  bool Sort(const double eye[4]) { return this->Graph.Sort(eye, false); }

  /// -1 where the order is no permutation.
  int CountMisordered(const double eye[4])
  {
    const auto& order = this->Graph.GetOrder();
    if (!SortTesting::IsPermutation(order, this->Complex.NumberOfCells))
    {
      return -1;
    }
    std::vector<int> ranks(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      ranks[order[i]] = static_cast<int>(i);
    }
    return static_cast<int>(std::count_if(this->Complex.Contacts.begin(),
      this->Complex.Contacts.end(),
      [&](const CellComplex::Contact& contact)
      { return SideOf(contact, eye) * (ranks[contact.Cells[0]] - ranks[contact.Cells[1]]) < 0; }));
  }

  int SideOf(const CellComplex::Contact& contact, const double eye[4]) const
  {
    const double* x = this->Complex.Points.data();
    return ExactOrientation::SideOfEye(
      x + 3 * contact.Points[0], x + 3 * contact.Points[1], x + 3 * contact.Points[2], eye);
  }

  int GetNumberOfGroups() const
  {
    return static_cast<int>(this->Graph.GetGroupOffsets().size()) - 1;
  }

  CellComplex Complex;
  VisibilityGraph Graph;
};

SortMeshes::Grid Delaunay(int count, bool flat)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(0.0, 1.0);
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  for (int i = 0; i < count; ++i)
  {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    points->InsertNextPoint(x, y, flat ? 1e-6 * z : z);
  }
  vtkNew<vtkUnstructuredGrid> cloud;
  cloud->SetPoints(points);
  vtkNew<vtkDelaunay3D> filter;
  filter->SetInputData(cloud);
  filter->Update();
  return filter->GetOutput();
}

// Meshes where every eye has an order that satisfies every face.
void TestOrdered(TestChecks& checks, const char* name, vtkUnstructuredGrid* grid)
{
  GraphOf graph(grid);
  for (const SortTesting::Eye& eye : SortTesting::Eyes(grid))
  {
    graph.Sort(eye.Position);
    const int misordered = graph.CountMisordered(eye.Position);
    if (misordered != 0 || graph.GetNumberOfGroups() != 0)
    {
      std::cout << name << ", " << eye.Name << ": " << misordered << " misordered, "
                << graph.GetNumberOfGroups() << " groups\n";
    }
    CHECK(misordered == 0);
    CHECK(graph.GetNumberOfGroups() == 0);
    CHECK(!graph.Sort(eye.Position));
  }
}

// A step that crosses no plane keeps the order, one that crosses some does not.
void TestKept(TestChecks& checks)
{
  auto grid = SortMeshes::Lattice(4);
  GraphOf graph(grid);
  double center[3];
  grid->GetCenter(center);
  double eye[4] = { center[0] + 5.0, center[1] + 0.01, center[2] + 0.02, 1.0 };
  CHECK(graph.Sort(eye));
  eye[0] += 1.0;
  eye[1] += 0.01;
  CHECK(!graph.Sort(eye));
  CHECK(graph.CountMisordered(eye) == 0);
  // Into the plane of a layer of faces and out of it on the other side.
  eye[1] = center[1];
  CHECK(graph.Sort(eye));
  eye[1] = center[1] - 0.01;
  CHECK(graph.Sort(eye));
  CHECK(graph.CountMisordered(eye) == 0);
}

// Every wrong contact lies within a group, every group is contiguous, its farthest centre first.
void TestGroups(TestChecks& checks)
{
  auto grid = SortMeshes::Make("warpedThree");
  GraphOf graph(grid);
  int groups = 0;
  for (const SortTesting::Eye& eye : SortTesting::Eyes(grid))
  {
    graph.Sort(eye.Position);
    const auto& order = graph.Graph.GetOrder();
    const auto& cells = graph.Graph.GetGroupCells();
    const auto& offsets = graph.Graph.GetGroupOffsets();
    std::vector<int> groupOf(order.size(), -1);
    for (int group = 0; group < graph.GetNumberOfGroups(); ++group, ++groups)
    {
      CHECK(offsets[group + 1] - offsets[group] > 1);
      CHECK(std::search(order.begin(), order.end(), cells.begin() + offsets[group],
              cells.begin() + offsets[group + 1]) != order.end());
      for (vtkIdType i = offsets[group]; i < offsets[group + 1]; ++i)
      {
        groupOf[cells[i]] = group;
      }
    }
    for (const auto& contact : graph.Complex.Contacts)
    {
      const auto at = [&](int cell) { return std::find(order.begin(), order.end(), cell); };
      const bool firstIsLater = at(contact.Cells[0]) > at(contact.Cells[1]);
      const int side = graph.SideOf(contact, eye.Position);
      const bool misordered = side != 0 && firstIsLater != (side > 0);
      const int group = groupOf[contact.Cells[0]];
      CHECK(!misordered || (group >= 0 && group == groupOf[contact.Cells[1]]));
    }
  }
  CHECK(groups > 0);
}

// Nothing relates cells that do not touch: their centres do, anew for every eye.
void TestApart(TestChecks& checks)
{
  auto first = SortMeshes::Lattice(1);
  auto grid = SortMeshes::Join(first, SortMeshes::Moved(first, 4.0, 0.0, 0.0));
  GraphOf graph(grid);
  double eye[4] = { -9.0, 0.0, 0.0, 1.0 };
  graph.Graph.Sort(eye, true);
  CHECK((graph.Graph.GetOrder() == std::vector<vtkIdType>{ 1, 0 }));
  eye[0] = 9.0;
  graph.Graph.Sort(eye, true);
  CHECK((graph.Graph.GetOrder() == std::vector<vtkIdType>{ 0, 1 }));
  const double direction[4] = { -1.0, 0.0, 0.0, 0.0 };
  graph.Graph.Sort(direction, true);
  CHECK((graph.Graph.GetOrder() == std::vector<vtkIdType>{ 1, 0 }));
}
}

int TestVisibilityGraph(int, char*[])
{
  TestChecks checks;
  auto lattice = SortMeshes::Lattice(6);
  auto tetrahedra = SortMeshes::Kuhn(lattice);
  TestOrdered(checks, "cubes", lattice);
  TestOrdered(checks, "lattice", tetrahedra);
  TestOrdered(checks, "shuffled", SortMeshes::Shuffled(tetrahedra, 5));
  TestOrdered(checks, "far", SortMeshes::Moved(tetrahedra, 1e7, -1e7, 1e7));
  TestOrdered(checks, "small", SortMeshes::Scaled(tetrahedra, 1e-7, 1e-7, 1e-7));
  TestOrdered(checks, "slivers", SortMeshes::Scaled(tetrahedra, 1.0, 1.0, 1e-6));
  TestOrdered(checks, "jittered", SortMeshes::Kuhn(SortMeshes::JitteredLattice(6, 0.2)));
  TestOrdered(checks, "Delaunay", Delaunay(500, false));
  TestOrdered(checks, "flat Delaunay", Delaunay(300, true));
  TestKept(checks);
  TestGroups(checks);
  TestApart(checks);
  return checks.Result();
}
