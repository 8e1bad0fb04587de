// What TetGen refuses is one message, and the rest is there.

#include "ConvexCellsTesting.h"
#include "SortMeshes.h"
#include "TetrahedraCheck.h"

#include "vtkTetGenTetrahedralizer.h"

#include <limits>

using namespace ConvexCellsTesting;

namespace
{
// Two boxes that overlap.
SortMeshes::Grid Overlapping()
{
  const auto box = SortMeshes::Lattice(2);
  return SortMeshes::Join(box, SortMeshes::Moved(box, 0.11, 0.07, 0.05));
}

void TestSelfIntersection()
{
  const auto grid = Overlapping();
  vtkNew<vtkTetGenTetrahedralizer> cells, filter;
  cells->SetInputData(grid);
  cells->Update();
  filter->SetInputData(grid);
  filter->SetModeToRemesh();
  TetrahedraCheck::Messages messages(filter);
  filter->Update();
  CHECK_EQUAL(messages.Warnings, 1);
  CHECK_EQUAL(messages.Errors, 0);
  CHECK(filter->GetFellBack());
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), cells->GetOutput()->GetNumberOfCells());
  filter->SetModeToFillHull();
  filter->Update();
  CHECK_EQUAL(messages.Warnings, 2);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), grid->GetNumberOfCells());
}

// A prism over a bow tie, beside a box.
void TestBadCell()
{
  auto grid = MakeGrid({ { 0, 0, 0 }, { 2, 2, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 2, 2, 1 }, { 2, 0, 1 }, { 0, 1, 1 }, { 5, 0, 0 }, { 6, 0, 0 }, { 6, 1, 0 }, { 5, 1, 0 },
    { 5, 0, 1 }, { 6, 0, 1 }, { 6, 1, 1 }, { 5, 1, 1 } });
  AddPolyhedron(grid, BoxFaces({ 0, 1, 2, 3, 4, 5, 6, 7 }));
  AddPolyhedron(grid, BoxFaces({ 8, 9, 10, 11, 12, 13, 14, 15 }));
  vtkNew<vtkTetGenTetrahedralizer> filter;
  filter->SetInputData(grid);
  TetrahedraCheck::Messages messages(filter);
  filter->Update();
  CHECK_EQUAL(messages.Errors, 1);
  CHECK_EQUAL(filter->GetNumberOfFailedCells(), 1);
  CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 1);
  CHECK(Near(TotalVolume(filter->GetOutput()), 1.0));
}

void TestLeast()
{
  vtkNew<vtkTetGenTetrahedralizer> filter;
  TetrahedraCheck::Messages messages(filter);
  vtkNew<vtkUnstructuredGrid> empty;
  auto flat = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { std::numeric_limits<double>::quiet_NaN(), 0, 0 } });
  AddCell(flat, VTK_TETRA, { 0, 1, 2, 3 });
  AddCell(flat, VTK_TRIANGLE, { 0, 1, 2 });
  for (int mode = vtkTetGenTetrahedralizer::CELL_BY_CELL;
       mode <= vtkTetGenTetrahedralizer::FILL_HULL; ++mode)
  {
    filter->SetMode(mode);
    filter->SetInputData(empty);
    filter->Update();
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
    filter->SetInputData(flat);
    filter->Update();
    CHECK(
      filter->GetOutput()->GetNumberOfCells() == 0 || mode == vtkTetGenTetrahedralizer::FILL_HULL);
  }
  CHECK_EQUAL(messages.Errors + messages.Warnings, 0);
}

// Points in one plane have no tetrahedra: TetGen says so by its exit code.
void TestPlane()
{
  auto plane = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 3, 2, 0 } });
  vtkNew<vtkTetGenTetrahedralizer> filter;
  TetrahedraCheck::Messages messages(filter);
  filter->SetInputData(plane);
  filter->SetModeToDelaunay();
  filter->Update();
  CHECK_EQUAL(messages.Errors, 1);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
}
}

int TestTetGenFailures(int, char*[])
{
  TestSelfIntersection();
  TestBadCell();
  TestLeast();
  TestPlane();
  return Result();
}
