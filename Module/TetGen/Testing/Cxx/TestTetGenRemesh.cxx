// Remesh: the boundary stays, the volume stays, the inside is as good as asked for, data follow.

#include "ConvexCellsTesting.h"
#include "SortMeshes.h"
#include "TetrahedraCheck.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkTetGenTetrahedralizer.h"

#include <algorithm>
#include <set>

using namespace ConvexCellsTesting;

namespace
{
// Each middle lies within the bounds of the cell that it is said to come from.
void CheckSources(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* output)
{
  vtkDataArray* sources = output->GetCellData()->GetArray("SourceCell");
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    const auto source = static_cast<vtkIdType>(sources->GetTuple1(i));
    if (CHECK(source >= 0 && source < grid->GetNumberOfCells()))
    {
      grid->GetCellBounds(source, bounds);
      const Point middle = Middle(output->GetCell(i)->GetPoints());
      for (int axis = 0; axis < 3; ++axis)
      {
        CHECK(middle[axis] > bounds[2 * axis] - 1e-9);
        CHECK(middle[axis] < bounds[2 * axis + 1] + 1e-9);
      }
    }
  }
}

// By output point: whether no boundary triangle has it.
std::vector<bool> InnerPoints(vtkUnstructuredGrid* output)
{
  std::set<Point> boundary;
  for (const std::vector<double>& triangle : TetrahedraCheck::BoundaryTriangles(output))
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      boundary.insert({ triangle[3 * corner], triangle[3 * corner + 1], triangle[3 * corner + 2] });
    }
  }
  std::vector<bool> inner;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    inner.push_back(boundary.count(PointOf(output, i)) == 0);
  }
  return inner;
}

void TestMesh(const char* name, double volumeShare, bool hasInside)
{
  const auto grid = SortMeshes::Make(name);
  TetrahedraCheck::AddLinear(grid);
  vtkNew<vtkTetGenTetrahedralizer> cells, filter;
  cells->SetInputData(grid);
  cells->Update();
  const double volume = TotalVolume(cells->GetOutput());
  filter->SetInputData(grid);
  filter->SetModeToRemesh();
  filter->SetMaximumVolume(volumeShare * volume);
  filter->Update();
  vtkUnstructuredGrid* output = filter->GetOutput();
  CHECK(!filter->GetFellBack());
  CHECK(Near(TotalVolume(output), volume, 1e-10));
  CHECK_EQUAL(TetrahedraCheck::CountFaces(output).Wrong, 0);
  CHECK(TetrahedraCheck::BoundaryTriangles(output) ==
        TetrahedraCheck::BoundaryTriangles(cells->GetOutput()));
  CHECK(TetrahedraCheck::LinearError(output) < 1e-9);
  CheckSources(grid, output);
  // Tetrahedra at the boundary are as large as its triangles make them, and TetGen stops short of
  // the bound elsewhere, too: 1.52 times it was seen.
  const auto isInside = InnerPoints(output);
  vtkNew<vtkIdList> ids;
  double largest = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    output->GetCellPoints(i, ids);
    if (std::all_of(ids->begin(), ids->end(), [&](vtkIdType id) { return isInside[id]; }))
    {
      largest = std::max(largest, TetrahedronVolume(output, i));
    }
  }
  CHECK(largest <= 2.0 * volumeShare * volume);
  CHECK(filter->GetNumberOfNewPoints() > 0 || !hasInside);
  CHECK_EQUAL(filter->GetNumberOfNewPoints(), std::count(isInside.begin(), isInside.end(), true));
}
}

int TestTetGenRemesh(int, char*[])
{
  TestMesh("lShape", 0.0005, true);
  TestMesh("hollowSphere", 0.0001, true);
  TestMesh("torus", 0.00005, true);
  // A layer of one cell.
  TestMesh("gears", 0.0005, false);
  return Result();
}
