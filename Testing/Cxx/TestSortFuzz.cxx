// Random small meshes with holes, by convexified MPVO: a few of those of TestSortFuzzLong.

#include "SortFuzz.h"
#include "SortMeshes.h"
#include "TestScene.h"
#include "vtkUnstructuredGrid.h"

int TestSortFuzz(int, char*[])
{
  TestChecks checks;
  CHECK(SortFuzz::CountFailures(1, 300) == 0);

  // The search for the smallest part: here two cells that must both be there.
  auto grid = SortMeshes::Make("latticeKuhn");
  auto holds = [&](vtkUnstructuredGrid* part, vtkIdType cell)
  {
    double corner[3];
    grid->GetPoint(cell, corner);
    for (vtkIdType id = 0; id < part->GetNumberOfPoints(); ++id)
    {
      const double* p = part->GetPoint(id);
      if (p[0] == corner[0] && p[1] == corner[1] && p[2] == corner[2])
      {
        return true;
      }
    }
    return false;
  };
  auto least = SortFuzz::Minimise(
    grid, [&](vtkUnstructuredGrid* part) { return holds(part, 0) && holds(part, 124); });
  CHECK(least->GetNumberOfCells() == 2);
  CHECK(SortFuzz::Print(least).find("points[8][3]") != std::string::npos);
  return checks.Result();
}
