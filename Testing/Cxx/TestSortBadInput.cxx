// Cells that are no complex: every one comes out once, one warning names the counts, and nothing
// wrong is called proven.

#include "ProvenSortCheck.h"
#include "SortMeshes.h"
#include "TestScene.h"
#include "vtkMPVOVisibilitySort.h"

#include <limits>

namespace
{
/// What gives a mesh away: nothing, what cannot be filled about it, its faces.
enum class Sign
{
  None,
  Fill,
  Faces
};

void TestMesh(TestChecks& checks, const std::string& name, Sign sign)
{
  auto grid = SortMeshes::Make(name);
  ProvenSortCheck check(name, grid);
  for (const bool convexify : { true, false })
  {
    const bool named = sign == Sign::Faces || (sign == Sign::Fill && convexify);
    vtkNew<vtkMPVOVisibilitySort> sort;
    sort->SetConvexify(convexify);
    vtkNew<MessageObserver> observer;
    observer->Watch(sort);
    ProvenSortCheck::Demands demands;
    demands.RightOnRays = false;
    demands.NoMisorderedFaces = false;
    const int failures = check.CountFailures(sort, SortTesting::Eyes(grid), demands);
    checks.Check(failures == 0, name.c_str(), __LINE__, std::to_string(failures));
    checks.Check(observer->Count() <= 1 && (observer->Count() == 1 || !named), name.c_str(),
      __LINE__, std::to_string(observer->Count()) + " messages");
    for (const std::string& text : observer->Texts)
    {
      std::cout << name << ": " << text.substr(text.rfind("): ") + 3);
    }
    checks.Check(!named || !sort->IsOrderProven(), name.c_str(), __LINE__);
  }
}

// A hole is filled and winding is not trusted: these two are no fault.
void TestNoFault(TestChecks& checks, const std::string& name)
{
  TestMesh(checks, name, Sign::None);
  auto grid = SortMeshes::Make(name);
  vtkNew<vtkMPVOVisibilitySort> sort;
  ProvenSortCheck check(name, grid);
  ProvenSortCheck::Demands demands;
  demands.Proven = true;
  CHECK(check.CountFailures(sort, SortTesting::Eyes(grid), demands) == 0);
}

// No cells, one cell, cells that are flat, points that are no numbers, cells of other kinds.
void TestLeast(TestChecks& checks)
{
  auto empty = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkMPVOVisibilitySort> sort;
  vtkNew<MessageObserver> observer;
  observer->Watch(sort);
  SortTesting::Eye eye = { "outside", { 1.0, 2.0, 3.0, 1.0 } };
  CHECK(SortTesting::OrderOf(sort, empty, eye).empty());

  auto flat = SortMeshes::Scaled(SortMeshes::Make("latticeKuhn"), 1.0, 1.0, 0.0);
  CHECK(
    SortTesting::IsPermutation(SortTesting::OrderOf(sort, flat, eye), flat->GetNumberOfCells()));

  auto broken = SortMeshes::Make("lShapeKuhn");
  broken->GetPoints()->SetPoint(3, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  CHECK(SortTesting::IsPermutation(
    SortTesting::OrderOf(sort, broken, eye), broken->GetNumberOfCells()));

  auto mixed = SortMeshes::Make("slabs");
  const vtkIdType ids[3] = { 0, 1, 7 };
  mixed->InsertNextCell(VTK_TRIANGLE, 3, ids);
  mixed->InsertNextCell(VTK_VERTEX, 1, ids);
  const auto order = SortTesting::OrderOf(sort, mixed, eye);
  std::cout << order.size() << " of " << mixed->GetNumberOfCells() << " mixed cells returned\n";
  CHECK(order.size() >= 32);
}
}

int TestSortBadInput(int, char*[])
{
  TestChecks checks;
  TestMesh(checks, "threeOnOneFace", Sign::Faces);
  TestMesh(checks, "duplicates", Sign::Faces);
  TestMesh(checks, "tJunctions", Sign::Faces);
  // No face tells of it: what is said is up to the fill, but nothing wrong is proven.
  TestMesh(checks, "overlapping", Sign::Fill);
  TestNoFault(checks, "missingCell");
  TestNoFault(checks, "wrongWinding");
  TestLeast(checks);
  return checks.Result();
}
