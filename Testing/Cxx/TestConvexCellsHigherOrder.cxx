// Cells that are not linear, or have no faces, are left out and named with the filter that converts
// them; what this filter gives is then taken, and has the volume of the cell.
#include "ConvexCellsTesting.h"

#include "vtkDataSetTriangleFilter.h"
#include "vtkGenericCell.h"

#include <string>

namespace
{
using namespace ConvexCellsTesting;

void CheckConversion(
  vtkUnstructuredGrid* grid, const std::string& name, const char* reason, double volume)
{
  for (const bool tetrahedraOnly : { false, true })
  {
    auto filter = Run(grid, tetrahedraOnly);
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
    CHECK_EQUAL(filter->GetNumberOfUnsupportedCells(), 1);
    CHECK_EQUAL(
      filter->GetLeftOutSummary(), "cells left out: 1 " + name + " (" + reason +
                                     ": vtkDataSetTriangleFilter makes tetrahedra of it)");
  }
  vtkNew<vtkDataSetTriangleFilter> convert;
  convert->SetInputData(grid);
  convert->Update();
  auto filter = Run(convert->GetOutput(), true);
  CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 0);
  if (!CHECK(Near(TotalVolume(filter->GetOutput()), volume, 1e-9)))
  {
    std::cerr << "  " << name << ": volume " << TotalVolume(filter->GetOutput()) << "\n";
  }
}

// The parametric cell itself.
void TestType(int type, double volume)
{
  auto cell = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
  std::vector<Point> points;
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    const double* p = cell->GetParametricCoords() + 3 * i;
    points.push_back({ p[0], p[1], p[2] });
    ids.push_back(i);
  }
  auto grid = MakeGrid(points);
  AddCell(grid, type, ids);
  CheckConversion(grid, cell->GetClassName(), "not linear", volume);
}

void TestLagrange()
{
  auto grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { .5, 0, 0 },
    { .5, .5, 0 }, { 0, .5, 0 }, { 0, 0, .5 }, { .5, 0, .5 }, { 0, .5, .5 } });
  AddCell(grid, VTK_LAGRANGE_TETRAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 });
  CheckConversion(grid, "vtkLagrangeTetra", "not linear", 1.0 / 6.0);
}

void TestConvexPointSet()
{
  auto grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } });
  AddCell(grid, VTK_CONVEX_POINT_SET, { 0, 1, 2, 3, 4 });
  CheckConversion(grid, "vtkConvexPointSet", "no faces", 0.5);
}
}

int TestConvexCellsHigherOrder(int, char*[])
{
  TestType(VTK_QUADRATIC_TETRA, 1.0 / 6.0);
  TestType(VTK_QUADRATIC_HEXAHEDRON, 1.0);
  TestType(VTK_QUADRATIC_WEDGE, 0.5);
  TestType(VTK_TRIQUADRATIC_HEXAHEDRON, 1.0);
  TestType(VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 1.0);
  TestType(VTK_BIQUADRATIC_QUADRATIC_WEDGE, 0.5);
  TestType(VTK_QUADRATIC_LINEAR_WEDGE, 0.5);
  TestLagrange();
  TestConvexPointSet();
  return Result();
}
