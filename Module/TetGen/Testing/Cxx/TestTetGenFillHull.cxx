// FillHull: what is added fills the hull, and the order of MPVO is proven with it; the same through
// vtkConvexifyFilter.

#include "ConvexCellsTesting.h"
#include "SortMeshes.h"
#include "SortTesting.h"
#include "TetrahedraCheck.h"

#include "vtkCellData.h"
#include "vtkConvexifyFilter.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMPVOVisibilitySort.h"
#include "vtkTetGenTetrahedralizer.h"

using namespace ConvexCellsTesting;

namespace
{
double VolumeOfMarked(vtkUnstructuredGrid* grid, bool imaginary)
{
  vtkDataArray* marks = grid->GetCellData()->GetArray("Imaginary");
  double volume = 0.0;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    if ((marks->GetTuple1(i) != 0.0) == imaginary)
    {
      volume += std::abs(VolumeWithin(grid->GetCell(i)));
    }
  }
  return volume;
}

void TestMesh(const char* name)
{
  const auto grid = SortMeshes::Make(name);
  vtkNew<vtkTetGenTetrahedralizer> filter;
  filter->SetInputData(grid);
  filter->SetModeToFillHull();
  filter->Update();
  vtkUnstructuredGrid* output = filter->GetOutput();
  const vtkIdType cells = grid->GetNumberOfCells();
  CHECK_EQUAL(output->GetNumberOfCells(), cells + filter->GetNumberOfImaginaryCells());
  CHECK(filter->GetNumberOfImaginaryCells() > 0);
  vtkDataArray* sources = output->GetCellData()->GetArray("SourceCell");
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    CHECK_EQUAL(sources->GetTuple1(i), i < cells ? static_cast<double>(i) : -1.0);
    CHECK(
      i < cells || (output->GetCellType(i) == VTK_TETRA && TetrahedronVolume(output, i) > -1e-15));
  }
  const double hull = TetrahedraCheck::HullVolume(grid);
  CHECK(Near(VolumeOfMarked(output, true) + VolumeOfMarked(output, false), hull, 1e-10));
  vtkNew<vtkMPVOVisibilitySort> sort;
  for (SortTesting::Eye eye : SortTesting::Eyes(output))
  {
    const auto order = SortTesting::OrderOf(sort, output, eye);
    CHECK_EQUAL(order.size(), cells);
    CHECK_EQUAL(sort->GetNumberOfMisorderedFaces(), 0);
    if (!CHECK(sort->IsOrderProven()))
    {
      std::cerr << "  " << name << " from " << eye.Name << ", " << sort->GetNumberOfCycles()
                << " circles\n";
    }
  }
  std::cout << name << ": " << filter->GetNumberOfImaginaryCells() << " imaginary tetrahedra\n";
}

void TestFilter()
{
  const auto grid = SortMeshes::Make("gears");
  vtkNew<vtkTetGenTetrahedralizer> fill;
  fill->SetModeToFillHull();
  vtkNew<vtkConvexifyFilter> cuts, filter;
  cuts->SetInputData(grid);
  cuts->Update();
  filter->SetInputData(grid);
  filter->SetFillAlgorithm(fill);
  filter->SetFillMethodToAlgorithm();
  filter->Update();
  CHECK(Near(filter->GetImaginaryVolume(), cuts->GetImaginaryVolume(), 1e-10));
  CHECK(Near(filter->GetEnclosureVolume(), cuts->GetEnclosureVolume(), 1e-10));
  CHECK_EQUAL(filter->GetFacesPerImaginaryCell(), 4.0);
  CHECK_EQUAL(filter->GetNumberOfImaginaryCells(), fill->GetNumberOfImaginaryCells());
  CHECK(filter->GetOutput()->GetFieldData()->HasArray("ImaginaryContacts"));
  const vtkMTimeType made = filter->GetOutput()->GetMTime();
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetMTime(), made);

  // The wrong mode, then none: an error, and cuts.
  TetrahedraCheck::Messages messages(filter);
  fill->SetModeToDelaunay();
  filter->Update();
  CHECK_EQUAL(messages.Errors, 1);
  CHECK_EQUAL(filter->GetNumberOfImaginaryCells(), cuts->GetNumberOfImaginaryCells());
  filter->SetFillAlgorithm(nullptr);
  filter->Update();
  CHECK_EQUAL(messages.Errors, 2);
  CHECK_EQUAL(filter->GetNumberOfImaginaryCells(), cuts->GetNumberOfImaginaryCells());
}

void TestConvex()
{
  vtkNew<vtkTetGenTetrahedralizer> filter;
  filter->SetInputData(SortMeshes::Lattice(3));
  filter->SetModeToFillHull();
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfImaginaryCells(), 0);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 27);
}
}

int TestTetGenFillHull(int, char*[])
{
  for (const char* name : { "lShape", "slabs", "gears", "torus", "hollowSphereTetrahedra" })
  {
    TestMesh(name);
  }
  TestFilter();
  TestConvex();
  return Result();
}
