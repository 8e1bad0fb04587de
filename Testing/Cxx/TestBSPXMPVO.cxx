// The second opinion: a sort that fills nothing is right on every ray where no cells hide each
// other in a circle, and calls no order left over that is none. Argument: one mesh's name; real
// meshes only so.

#include "RayOrder.h"
#include "RealMeshes.h"
#include "SortMeshes.h"
#include "SortTesting.h"
#include "TestScene.h"
#include "vtkBSPXMPVOVisibilitySort.h"

#include <chrono>

namespace
{
void TestMesh(TestChecks& checks, const SortMeshes::Entry& entry)
{
  auto grid = SortMeshes::Make(entry.Name);
  const RayOrder rays(grid);
  vtkNew<vtkBSPXMPVOVisibilitySort> sort;
  int eyes = 0, left = 0, wrong = 0, added = 0;
  for (SortTesting::Eye& eye : SortTesting::Eyes(grid))
  {
    const auto order = SortTesting::OrderOf(sort, grid, eye);
    CHECK(SortTesting::IsPermutation(order, grid->GetNumberOfCells()));
    const auto result = rays.Check(eye.Position, order);
    const bool circle = sort->GetNumberOfLeftCells() > 0;
    checks.Check(circle || result.WrongRays == 0, entry.Name.c_str(), __LINE__,
      eye.Name + ": " + std::to_string(result.WrongRays) + " rays, cell " +
        std::to_string(result.Near) + " before " + std::to_string(result.Far));
    checks.Check(!circle || entry.MayBeCyclic, entry.Name.c_str(), __LINE__,
      eye.Name + ": " + std::to_string(sort->GetNumberOfLeftCells()) + " cells left");
    ++eyes;
    left += circle ? 1 : 0;
    wrong += result.WrongRays > 0 ? 1 : 0;
    added += sort->GetNumberOfAddedRelations();
  }
  std::cout << entry.Name << ": " << grid->GetNumberOfCells() << " cells, "
            << sort->GetNumberOfFragments() << " fragments, " << added / eyes
            << " relations added for an eye, " << left << " of " << eyes << " eyes cyclic, "
            << wrong << " wrong\n";
}

// Says only: real meshes may fold, and a circle is what this sort has no answer to.
void TryReal(TestChecks& checks, const std::string& name)
{
  auto read = RealMeshes::Read(name);
  auto grid = read ? SortMeshes::Tetrahedra(read) : nullptr;
  if (!grid)
  {
    return;
  }
  const RayOrder rays(grid);
  vtkNew<vtkBSPXMPVOVisibilitySort> sort;
  vtkNew<MessageObserver> observer;
  observer->Watch(sort);
  for (SortTesting::Eye& eye : SortTesting::FewEyes(grid))
  {
    const auto begin = std::chrono::steady_clock::now();
    const auto order = SortTesting::OrderOf(sort, grid, eye);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    CHECK(SortTesting::IsPermutation(order, grid->GetNumberOfCells()));
    const auto result = rays.Check(eye.Position, order);
    std::cout << name << ", " << eye.Name << ": " << grid->GetNumberOfCells() << " tetrahedra, "
              << sort->GetNumberOfFragments() << " fragments, " << sort->GetNumberOfAddedRelations()
              << " relations added, " << sort->GetNumberOfLeftCells() << " cells left, "
              << result.WrongRays << " rays wrong, " << seconds.count() << " s\n";
    checks.Check(sort->GetNumberOfLeftCells() > 0 || result.WrongRays == 0, name.c_str(), __LINE__);
  }
}
}

int TestBSPXMPVO(int argc, char* argv[])
{
  TestChecks checks;
  const std::string only = argc > 1 && argv[1][0] != '-' ? argv[1] : "";
  for (const auto& entry : SortMeshes::All())
  {
    if (only.empty() || only == entry.Name)
    {
      TestMesh(checks, entry);
    }
  }
  for (const char* name : { "bluntFin", "diskOut", "fire", "can", "comb" })
  {
    if (only == name)
    {
      TryReal(checks, name);
    }
  }
  return checks.Result();
}
