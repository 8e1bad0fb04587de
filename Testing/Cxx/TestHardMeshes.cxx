// Every hard mesh, from many eyes: convexified MPVO is a permutation, has no misordered face, and
// is right along every ray; what it says is proven is.

#include "ProvenSortCheck.h"
#include "SortMeshes.h"
#include "TestScene.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkMPVOVisibilitySort.h"

#include <algorithm>
#include <set>

namespace
{
void TestMesh(TestChecks& checks, const SortMeshes::Entry& entry)
{
  auto grid = SortMeshes::Make(entry.Name);
  vtkNew<vtkMPVOVisibilitySort> sort;
  vtkNew<MessageObserver> observer;
  observer->Watch(sort);
  ProvenSortCheck check(entry.Name, grid);
  ProvenSortCheck::Demands demands;
  demands.Proven = !entry.MayBeCyclic;
  const int failures = check.CountFailures(sort, SortTesting::Eyes(grid), demands);
  std::cout << entry.Name << ": " << grid->GetNumberOfCells() << " cells, "
            << check.GetNumberOfEyes() << " eyes, " << check.GetNumberOfProvenEyes() << " proven, "
            << check.GetNumberOfCyclicEyes() << " cyclic (at most " << check.GetMostCyclicCells()
            << " cells, " << check.GetMostRaysLetOff() << " rays let off), " << failures
            << " wrong\n";
  checks.Check(failures == 0, entry.Name.c_str(), __LINE__, std::to_string(failures));
  checks.Check(observer->Count() == 0, entry.Name.c_str(), __LINE__,
    observer->Count() ? observer->Texts[0] : "");
}

// The bars of these meshes hide each other in one circle, seen from up the third axis.
void TestTangle(TestChecks& checks, const SortMeshes::Entry& entry)
{
  auto grid = SortMeshes::Make(entry.Name);
  for (const bool parallel : { false, true })
  {
    vtkNew<vtkMPVOVisibilitySort> sort;
    SortTesting::Eye eye = SortTesting::EyeUp(grid, parallel);
    const auto order = SortTesting::OrderOf(sort, grid, eye);
    checks.Check(sort->GetNumberOfCycles() > 0, entry.Name.c_str(), __LINE__);
    CHECK(!sort->IsOrderProven());
    // Contiguous in the order.
    vtkNew<vtkIdList> ids;
    for (vtkIdType group = 0; group < sort->GetNumberOfCycles(); ++group)
    {
      sort->GetCyclicGroups()->GetCellAtId(group, ids);
      const std::set<vtkIdType> members(ids->begin(), ids->end());
      auto first = std::find_if(
        order.begin(), order.end(), [&](vtkIdType id) { return members.count(id) != 0; });
      CHECK(order.end() - first >= static_cast<std::ptrdiff_t>(members.size()));
      CHECK(
        std::all_of(first, first + std::min<std::ptrdiff_t>(members.size(), order.end() - first),
          [&](vtkIdType id) { return members.count(id) != 0; }));
    }
    // No order is right: the check without groups must find fault with any.
    const auto rays = RayOrder(grid).Check(eye.Position, order);
    checks.Check(rays.WrongRays > 0, entry.Name.c_str(), __LINE__,
      std::to_string(rays.Pairs) + " pairs, all right");
  }
}
}

int TestHardMeshes(int argc, char* argv[])
{
  TestChecks checks;
  const std::string only = argc > 1 && argv[1][0] != '-' ? argv[1] : "";
  for (const auto& entry : SortMeshes::All())
  {
    if (only.empty() || only == entry.Name)
    {
      TestMesh(checks, entry);
      if (entry.Tangle)
      {
        TestTangle(checks, entry);
      }
    }
  }
  return checks.Result();
}
