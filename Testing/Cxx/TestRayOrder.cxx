// The ray check itself: an order that is right passes it, orders that are wrong do not.

#include "FaceOrderSort.h"
#include "RayOrder.h"
#include "SortMeshes.h"
#include "SortTesting.h"
#include "TestMeshes.h"
#include "TestScene.h"
#include "vtkCellCenterDepthSort.h"

#include <algorithm>
#include <chrono>

namespace
{
using namespace SortTesting;

// Convex meshes of tetrahedra, for which a topological sort by shared faces is right.
void TestRight(TestChecks& checks)
{
  for (const char* name : { "latticeKuhn", "latticeKuhnJittered", "latticeKuhnShuffled",
         "latticeFar", "latticeTiny", "slivers", "latticeFloat" })
  {
    auto grid = SortMeshes::Make(name);
    const RayOrder rays(grid);
    vtkNew<FaceOrderSort> sort;
    for (Eye& eye : FewEyes(grid))
    {
      auto order = OrderOf(sort, grid, eye);
      CHECK(sort->GetNumberOfUnorderedCells() == 0);
      const auto right = rays.Check(eye.Position, order);
      checks.Check(right.WrongRays == 0 && right.OverlappingPairs == 0, name, __LINE__,
        eye.Name + ": " + std::to_string(right.WrongRays) + " wrong rays, " +
          std::to_string(right.OverlappingPairs) + " overlaps");
      CHECK(right.Rays == 2000 && right.Pairs > 2000);
      std::reverse(order.begin(), order.end());
      const auto wrong = rays.Check(eye.Position, order);
      CHECK(wrong.Pairs == right.Pairs && wrong.WrongPairs == wrong.Pairs);
      CHECK(wrong.Near >= 0 && wrong.Far >= 0);
    }
  }
}

// Two cells exchanged: one wrong pair must be seen; a group that holds both is let off.
void TestExchanged(TestChecks& checks)
{
  auto grid = SortMeshes::Make("latticeKuhn");
  const RayOrder rays(grid);
  vtkNew<FaceOrderSort> sort;
  Eye eye = FewEyes(grid).front();
  auto order = OrderOf(sort, grid, eye);
  std::swap(order[100], order[140]);
  const int wrong = rays.Check(eye.Position, order).WrongRays;
  CHECK(wrong > 0);
  std::vector<int> groups(order.size(), 0);
  const auto letOff = rays.Check(eye.Position, order, groups);
  CHECK(letOff.WrongRays == 0 && letOff.RaysLetOff == wrong);
  order.pop_back();
  CHECK(rays.Check(eye.Position, order).WrongRays > 0);
}

// Along an axis every ray of a lattice meets as many cells, whatever lies beside them.
void TestAlongAxes(TestChecks& checks)
{
  constexpr int Cells = 6;
  auto grid = SortMeshes::Lattice(Cells);
  const RayOrder rays(grid);
  for (int i = 0; i < 6; ++i)
  {
    double eye[4] = { 0.0, 0.0, 0.0, 0.0 };
    eye[i % 3] = i < 3 ? 1.0 : -1.0;
    const auto result = rays.Check(eye, {});
    CHECK(result.Rays == 2000 && result.Pairs == 2000 * (Cells - 1));
    CHECK(result.WrongRays == 2000 && result.OverlappingPairs == 0);
  }
}

// VTK's sort by cell centres fails on nearly every mesh; no mesh but the bad ones overlaps itself.
void TestCenters(TestChecks& checks)
{
  int meshes = 0, wrongMeshes = 0;
  for (const auto& entry : SortMeshes::All())
  {
    auto grid = SortMeshes::Make(entry.Name);
    const RayOrder rays(grid);
    vtkNew<vtkCellCenterDepthSort> sort;
    RayOrder::Result total;
    for (Eye& eye : FewEyes(grid))
    {
      const auto order = OrderOf(sort, grid, eye);
      const auto result = rays.Check(eye.Position, order);
      CHECK(IsPermutation(order, grid->GetNumberOfCells()));
      total.WrongRays += result.WrongRays;
      total.Pairs += result.Pairs;
      total.WrongPairs += result.WrongPairs;
      total.OverlappingPairs += result.OverlappingPairs;
    }
    std::cout << entry.Name << ": " << grid->GetNumberOfCells() << " cells, centre sort "
              << total.WrongPairs << " of " << total.Pairs << " pairs wrong, "
              << total.OverlappingPairs << " overlap\n";
    checks.Check(total.OverlappingPairs == 0, entry.Name.c_str(), __LINE__, "overlap");
    ++meshes;
    wrongMeshes += total.WrongRays > 0 ? 1 : 0;
  }
  std::cout << "the centre sort is wrong on " << wrongMeshes << " of " << meshes << "\n";
  CHECK(wrongMeshes > meshes / 2);
}

// Twice in the same place is an overlap, never an order.
void TestOverlaps(TestChecks& checks)
{
  for (const char* name : { "overlapping", "duplicates", "threeOnOneFace" })
  {
    auto grid = SortMeshes::Make(name);
    vtkNew<vtkCellCenterDepthSort> sort;
    Eye eye = FewEyes(grid).front();
    const auto order = OrderOf(sort, grid, eye);
    CHECK(RayOrder(grid).Check(eye.Position, order).OverlappingPairs > 0);
  }
}

void TestSpeed(TestChecks& checks)
{
  auto grid = SortMeshes::Kuhn(SortMeshes::JitteredLattice(32, 0.1));
  vtkNew<FaceOrderSort> sort;
  Eye eye = FewEyes(grid).front();
  const auto order = OrderOf(sort, grid, eye);
  const auto begin = std::chrono::steady_clock::now();
  const RayOrder rays(grid);
  const auto built = std::chrono::steady_clock::now();
  CHECK(rays.Check(eye.Position, order).WrongRays == 0);
  const auto end = std::chrono::steady_clock::now();
  std::cout << grid->GetNumberOfCells()
            << " cells: " << std::chrono::duration<double>(built - begin).count() << " s to build, "
            << std::chrono::duration<double>(end - built).count() << " s for 2000 rays\n";
}
}

int TestRayOrder(int, char*[])
{
  TestChecks checks;
  TestRight(checks);
  TestExchanged(checks);
  TestAlongAxes(checks);
  TestCenters(checks);
  TestOverlaps(checks);
  TestSpeed(checks);
  return checks.Result();
}
