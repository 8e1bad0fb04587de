// T-junctions: every pair of cells that touch in faces that do not match is counted, at any place,
// size and turn, and no others; the tree of boxes misses none. Says what a large mesh costs.

#include "BoxHierarchy.h"
#include "CellComplex.h"
#include "CellComplexReader.h"
#include "MeshLattice.h"
#include "NonconformingFaces.h"
#include "ProvenSortCheck.h"
#include "SortMeshes.h"
#include "TestScene.h"
#include "vtkIdList.h"
#include "vtkMPVOVisibilitySort.h"

#include <algorithm>
#include <chrono>
#include <random>

namespace
{
using namespace SortMeshes;

int PairsOf(vtkUnstructuredGrid* grid)
{
  CellComplex complex;
  CellComplexReader::Read(grid, complex);
  return complex.NumberOfNonconformingPairs;
}

// Boxes beside a cube, `cells` along each edge of the face that they share.
Grid Refined(int cells)
{
  Grid coarse = Scaled(MeshLattice(1, 1, 1).Make(), cells, cells, cells);
  return Join(coarse, Moved(MeshLattice(1, cells, cells).Make(), cells, 0, 0));
}

// About an axis through the origin, by an angle whose sine is no number of few bits.
Grid Turned(vtkUnstructuredGrid* grid)
{
  auto turned = Grid::New();
  turned->DeepCopy(grid);
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double p[3];
    grid->GetPoint(id, p);
    turned->GetPoints()->SetPoint(id, 0.6 * p[0] - 0.8 * p[1], 0.8 * p[0] + 0.6 * p[1], p[2]);
  }
  return turned;
}

void TestCounts(TestChecks& checks)
{
  CHECK_NEAR(PairsOf(Refined(1)), 0, 0);
  for (const int cells : { 2, 3, 5 })
  {
    const Grid grid = Refined(cells);
    const int expected = cells * cells;
    CHECK_NEAR(PairsOf(grid), expected, 0);
    CHECK_NEAR(PairsOf(Turned(grid)), expected, 0);
    CHECK_NEAR(PairsOf(Moved(grid, 1e7, -3e7, 2e7)), expected, 0);
    CHECK_NEAR(PairsOf(Scaled(grid, 1e-7, 1e-7, 1e-7)), expected, 0);
    CHECK_NEAR(PairsOf(Scaled(grid, 1.0, 1e-6, 1.0)), expected, 0);
    CHECK_NEAR(PairsOf(Shuffled(grid, 4)), expected, 0);
  }
  // They touch along an edge.
  CHECK_NEAR(PairsOf(Join(Refined(1), Moved(Refined(1), 0.0, 1.0, 1.0))), 0, 0);
  // Two against three along one edge: four strips overlap.
  CHECK_NEAR(PairsOf(Join(Scaled(MeshLattice(1, 2, 1).Make(), 1, 3, 1),
               Moved(Scaled(MeshLattice(1, 3, 1).Make(), 1, 2, 1), 1, 0, 0))),
    4, 0);
}

// The same square cut along different diagonals: each triangle touches both across.
void TestDiagonals(TestChecks& checks)
{
  Grid grid = MeshLattice(2, 1, 1).Make();
  grid->GetPoints()->InsertNextPoint(0.0, 0.5, 0.5);
  grid->GetPoints()->InsertNextPoint(2.0, 0.5, 0.5);
  vtkNew<vtkIdList> square;
  for (vtkIdType id = 0; id < 12; ++id)
  {
    if (grid->GetPoint(id)[0] == 1.0)
    {
      square->InsertNextId(id);
    }
  }
  CHECK_NEAR(square->GetNumberOfIds(), 4, 0);
  auto cut = Grid::New();
  cut->SetPoints(grid->GetPoints());
  // In a lattice's order: 0 1 / 2 3.
  static const int corners[2][2][3] = { { { 0, 1, 3 }, { 0, 3, 2 } },
    { { 0, 1, 2 }, { 1, 3, 2 } } };
  for (int side = 0; side < 2; ++side)
  {
    for (const auto& triangle : corners[side])
    {
      const vtkIdType ids[4] = { square->GetId(triangle[0]), square->GetId(triangle[1]),
        square->GetId(triangle[2]), 12 + side };
      cut->InsertNextCell(VTK_TETRA, 4, ids);
    }
  }
  CHECK_NEAR(PairsOf(cut), 4, 0);
}

// Nothing wrong in the corpus, and what is wrong with the bad ones is something else.
void TestNoFalseAlarms(TestChecks& checks)
{
  for (const Entry& entry : All())
  {
    const int pairs = PairsOf(Make(entry.Name));
    checks.Check(pairs == 0, entry.Name.c_str(), __LINE__, std::to_string(pairs));
  }
  for (const char* name : { "missingCell", "wrongWinding", "duplicates", "overlapping" })
  {
    const int pairs = PairsOf(Make(name));
    checks.Check(pairs == 0, name, __LINE__, std::to_string(pairs));
  }
}

// What fills the mesh lies, flat, between such faces too: the order is right, though not proven.
void TestOrder(TestChecks& checks)
{
  auto grid = Refined(3);
  vtkNew<vtkMPVOVisibilitySort> sort;
  vtkNew<MessageObserver> observer;
  observer->Watch(sort);
  ProvenSortCheck check("refined", grid);
  CHECK(check.CountFailures(sort, SortTesting::Eyes(grid), ProvenSortCheck::Demands()) == 0);
  CHECK_NEAR(check.GetNumberOfProvenEyes(), 0, 0);
  CHECK_NEAR(observer->Count(), 1, 0);
  CHECK(observer->CountOf("9 pairs of cells touch in faces that do not match") == 1);
}

void TestBoxes(TestChecks& checks)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(0.0, 1.0);
  std::vector<vtkBoundingBox> boxes;
  for (int i = 0; i < 500; ++i)
  {
    vtkBoundingBox box;
    for (int corner = 0; corner < 2 && i % 50 != 0; ++corner)
    {
      const double scale = i % 3 == 0 ? 1.0 : 0.05, shift = coordinate(random) * (i % 3);
      box.AddPoint(shift + scale * coordinate(random), shift + scale * coordinate(random), shift);
    }
    boxes.push_back(box);
  }
  const BoxHierarchy hierarchy(boxes);
  std::vector<int> met;
  for (const vtkBoundingBox& box : boxes)
  {
    hierarchy.FindMet(box, met);
    std::sort(met.begin(), met.end());
    std::vector<int> expected;
    for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
    {
      if (boxes[i].IsValid() && box.IsValid() && boxes[i].Intersects(box))
      {
        expected.push_back(i);
      }
    }
    CHECK(met == expected);
  }
  BoxHierarchy({}).FindMet(boxes[1], met);
  CHECK(met.empty());
}

void TestCost(TestChecks& checks)
{
  for (const int cells : { 20, 40, 80 })
  {
    auto grid = Refined(cells);
    CellComplex complex;
    const auto start = std::chrono::steady_clock::now();
    CellComplexReader::Read(grid, complex);
    const auto read = std::chrono::steady_clock::now();
    const int pairs = NonconformingFaces::CountCellPairs(complex);
    const auto counted = std::chrono::steady_clock::now();
    CHECK_NEAR(pairs, cells * cells, 0);
    std::cout << complex.Boundary.size()
              << " boundary triangles: " << std::chrono::duration<double>(counted - read).count()
              << " s of " << std::chrono::duration<double>(read - start).count() << " s\n";
  }
}
}

int TestNonconformingFaces(int, char*[])
{
  TestChecks checks;
  TestCounts(checks);
  TestDiagonals(checks);
  TestNoFalseAlarms(checks);
  TestOrder(checks);
  TestBoxes(checks);
  TestCost(checks);
  return checks.Result();
}
