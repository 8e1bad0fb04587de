// The automatic choice: power where it is exact, else MPVO, and either way the mesh is read once.

#include "SortMeshes.h"
#include "SortTesting.h"
#include "TestMeshes.h"
#include "TestScene.h"
#include "VisibilitySortChoice.h"
#include "vtkMPVOVisibilitySort.h"
#include "vtkObjectFactory.h"

namespace
{
/// Counts how often its last point is read. No cell has it: only who reads all points does.
class CountingGrid : public vtkUnstructuredGrid
{
public:
  static CountingGrid* New();
  vtkTypeMacro(CountingGrid, vtkUnstructuredGrid);

  using vtkUnstructuredGrid::GetPoint;
  void GetPoint(vtkIdType id, double x[3]) override
  {
    this->Reads += id + 1 == this->GetNumberOfPoints() ? 1 : 0;
    this->Superclass::GetPoint(id, x);
  }

  int Reads = 0;
};
vtkStandardNewMacro(CountingGrid);

void TakeCells(CountingGrid* grid, vtkUnstructuredGrid* cells)
{
  grid->DeepCopy(cells);
  grid->GetPoints()->InsertNextPoint(cells->GetCenter());
  grid->Reads = 0;
}

// Sorts for two eyes and asks for the proof.
void CheckSort(TestChecks& checks, VisibilitySortChoice& choice, CountingGrid* grid,
  const std::string& expected, bool proven)
{
  vtkNew<vtkCamera> camera;
  for (const double x : { 3.0, -5.0 })
  {
    camera->SetPosition(x, 4.0, 7.0);
    choice.Choose(VisibilitySortChoice::Automatic, grid, camera, true)->InitTraversal();
    checks.Check(choice.GetName() == expected, expected.c_str(), __LINE__, choice.GetName());
    CHECK(choice.GetProvenSort()->IsOrderProven() == proven);
  }
}

void TestReadOnce(TestChecks& checks)
{
  VisibilitySortChoice choice;
  vtkNew<CountingGrid> grid;
  // Ties: not strictly Delaunay. Convex.
  TakeCells(grid, SortMeshes::Make("latticeKuhn"));
  CheckSort(checks, choice, grid, "MPVO", true);
  CHECK_NEAR(grid->Reads, 1, 0);
  // Boxes of a lattice are Delaunay; with some missing, not convex.
  TakeCells(grid, SortMeshes::Make("lattice"));
  CheckSort(checks, choice, grid, "Power", true);
  CHECK_NEAR(grid->Reads, 1, 0);
  TakeCells(grid, SortMeshes::Make("checkerboard"));
  CheckSort(checks, choice, grid, "MPVO", true);
  CHECK_NEAR(grid->Reads, 1, 0);
  // The same sort again, for other cells of the same grid, and for points that move.
  TakeCells(grid, SortMeshes::Make("tJunctions"));
  CheckSort(checks, choice, grid, "MPVO", false);
  CHECK_NEAR(grid->Reads, 1, 0);
  grid->GetPoints()->SetPoint(0, -0.1, -0.2, -0.3);
  grid->GetPoints()->Modified();
  CheckSort(checks, choice, grid, "MPVO", false);
  CHECK_NEAR(grid->Reads, 2, 0);
}

// What cannot be taken is built.
void TestTake(TestChecks& checks)
{
  auto grid = SortMeshes::Make("gearsTetrahedra"), other = SortMeshes::Make("lShapeKuhn");
  SortTesting::Eye eye = SortTesting::EyeUp(grid, false);
  vtkNew<vtkMPVOVisibilitySort> first, second;
  const auto expected = SortTesting::OrderOf(first, grid, eye);
  CHECK(first->IsOrderProven());
  second->TakeComplex(first);
  second->TakeComplex(nullptr);
  second->TakeComplex(second);
  second->SetInput(other);
  second->TakeComplex(first);
  CHECK(SortTesting::OrderOf(second, grid, eye) == expected);
  second->TakeComplex(first);
  CHECK(SortTesting::OrderOf(second, grid, eye) == expected && second->IsOrderProven());
  // Robbed, and asked again.
  CHECK(SortTesting::OrderOf(first, grid, eye) == expected);
  CHECK(first->IsOrderProven() && first->GetNumberOfMisorderedFaces() == 0);
}
}

int TestVisibilitySortChoice(int, char*[])
{
  TestChecks checks;
  TestReadOnce(checks);
  TestTake(checks);
  return checks.Result();
}
