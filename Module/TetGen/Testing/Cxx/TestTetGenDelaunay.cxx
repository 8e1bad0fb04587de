// Delaunay: the power sort is exact on it, and proves so for every eye.

#include "ConvexCellsTesting.h"
#include "SortMeshes.h"
#include "SortTesting.h"
#include "TetrahedraCheck.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPowerVisibilitySort.h"
#include "vtkTetGenTetrahedralizer.h"

using namespace ConvexCellsTesting;

namespace
{
void TestMesh(const SortMeshes::Grid& grid)
{
  TetrahedraCheck::AddLinear(grid);
  vtkNew<vtkTetGenTetrahedralizer> filter;
  filter->SetInputData(grid);
  filter->SetModeToDelaunay();
  filter->Update();
  vtkUnstructuredGrid* output = filter->GetOutput();
  CHECK_EQUAL(output->GetNumberOfPoints(), grid->GetNumberOfPoints());
  CHECK(Near(TotalVolume(output), TetrahedraCheck::HullVolume(grid), 1e-10));
  CHECK_EQUAL(TetrahedraCheck::CountFaces(output).Wrong, 0);
  CHECK(TetrahedraCheck::LinearError(output) == 0.0);
  vtkNew<vtkPowerVisibilitySort> sort;
  for (SortTesting::Eye eye : SortTesting::FewEyes(output))
  {
    const auto order = SortTesting::OrderOf(sort, output, eye);
    CHECK(SortTesting::IsPermutation(order, output->GetNumberOfCells()));
    CHECK(sort->IsExact());
    CHECK(sort->IsOrderProven());
  }
}

// What lies between two slabs is of no cell.
void TestSources()
{
  const auto slabs = SortMeshes::Make("slabs");
  vtkNew<vtkTetGenTetrahedralizer> filter;
  filter->SetInputData(slabs);
  filter->SetModeToDelaunay();
  filter->Update();
  const auto volumes =
    TetrahedraCheck::VolumesBySource(filter->GetOutput(), slabs->GetNumberOfCells());
  CHECK(volumes.back() > 0.0);
  CHECK(volumes.front() > 0.0);
}
}

int TestTetGenDelaunay(int, char*[])
{
  TestMesh(SortMeshes::JitteredLattice(5, 0.2));
  TestMesh(SortMeshes::Tetrahedra(SortMeshes::JitteredLattice(4, 0.3)));
  TestSources();
  return Result();
}
