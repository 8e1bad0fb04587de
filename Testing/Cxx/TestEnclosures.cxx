// What fills a hard mesh to its hull or its box: imaginary polyhedra are convex, volumes add up,
// and the sort is right with the filled mesh for input.

#include "EnclosureCheck.h"
#include "ProvenSortCheck.h"
#include "SortMeshes.h"
#include "TestScene.h"
#include "vtkConvexifyFilter.h"
#include "vtkMPVOVisibilitySort.h"

namespace
{
void TestMesh(TestChecks& checks, const SortMeshes::Entry& entry, int enclosure)
{
  auto grid = SortMeshes::Make(entry.Name);
  const std::string name = entry.Name + (enclosure == 0 ? " in its hull" : " in its box");
  vtkNew<vtkConvexifyFilter> filter;
  vtkNew<MessageObserver> observer;
  observer->Watch(filter);
  filter->SetInputData(grid);
  filter->SetEnclosure(enclosure);
  // All of it, so that volumes can be added up.
  filter->DiscardOutsideHullOff();
  filter->Update();
  EnclosureCheck::TestFilled(checks, name, filter);
  // Discarded cells lie beside the hull: no ray between cells of the mesh misses them.
  filter->DiscardOutsideHullOn();
  filter->Update();
  vtkNew<vtkMPVOVisibilitySort> sort;
  observer->Watch(sort);
  ProvenSortCheck check(name, filter->GetOutput());
  const int failures = check.CountFailures(
    sort, SortTesting::FewEyes(filter->GetOutput()), ProvenSortCheck::Demands());
  checks.Check(failures == 0, name.c_str(), __LINE__, std::to_string(failures));
  checks.Check(
    observer->Count() == 0, name.c_str(), __LINE__, observer->Count() ? observer->Texts[0] : "");
}
}

int TestEnclosures(int argc, char* argv[])
{
  TestChecks checks;
  const std::string only = argc > 1 && argv[1][0] != '-' ? argv[1] : "";
  for (const auto& entry : SortMeshes::All())
  {
    for (const int enclosure : { 0, 1 })
    {
      if (only.empty() || only == entry.Name)
      {
        TestMesh(checks, entry, enclosure);
      }
    }
  }
  return checks.Result();
}
