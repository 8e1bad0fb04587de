// Fewer tetrahedra: errors measured apart never exceed their bounds, the mesh stays one of the same
// topology, data follow.

#include "ConvexCellsTesting.h"
#include "SimplificationCheck.h"
#include "SortMeshes.h"
#include "TestMeshes.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkTetrahedraSimplifier.h"

#include <cmath>
#include <limits>

using namespace ConvexCellsTesting;

namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

Grid TetrahedraOf(vtkUnstructuredGrid* grid)
{
  return Run(grid, true)->GetOutput();
}

// A front across the bounds, as wide as a third of them.
void SetFront(vtkUnstructuredGrid* grid)
{
  const double* bounds = grid->GetBounds();
  TestMeshes::SetField(grid,
    [bounds](const double* p)
    {
      double x[3];
      for (int i = 0; i < 3; ++i)
      {
        x[i] = (p[i] - bounds[2 * i]) / (bounds[2 * i + 1] - bounds[2 * i]);
      }
      return std::tanh(4.0 * (x[0] + 0.5 * x[1] * x[1] - 0.3 * x[2] - 0.5));
    });
}

void TestGenerated()
{
  using SimplificationCheck::Check;
  auto lattice = TetrahedraOf(SortMeshes::JitteredLattice(12, 0.2));
  SetFront(lattice);
  // Of 0 nothing but what is linear goes; of more, more.
  const double least = Check("lattice", lattice, 0.0, 0.0);
  const double some = Check("lattice", lattice, 0.02, 0.0);
  const double more = Check("lattice", lattice, 0.1, 0.0);
  CHECK(least == 1.0 && some < 0.7 && more < 0.5 * some);
  TestMeshes::SetField(
    lattice, [](const double* x) { return 1.0 + x[0] - 2.0 * x[1] + 3.0 * x[2]; });
  CHECK(Check("linear field", lattice, 1e-9, 0.0) < 0.01);
  // Curved: where the boundary may move, more goes.
  auto curved = TetrahedraOf(TestMeshes::Curvilinear(12));
  TestMeshes::SetField(curved, [](const double* x) { return x[0] + x[1]; });
  CHECK(Check("curved", curved, 0.05, 0.01) < 0.7 * Check("curved", curved, 0.05, 0.0));
  // A handle, a cavity, several parts.
  for (const char* name : { "torus", "hollowSphereTetrahedra", "gears", "slabs" })
  {
    const auto grid = TetrahedraOf(SortMeshes::Make(name));
    Check(name, grid, 0.1, 0.02);
    Check(name, grid, 0.1, 0.0);
  }
}

void TestData()
{
  auto lattice = TetrahedraOf(SortMeshes::Lattice(8));
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ids");
  for (vtkIdType i = 0; i < lattice->GetNumberOfPoints(); ++i)
  {
    ids->InsertNextValue(i);
  }
  lattice->GetPointData()->AddArray(ids);
  TestMeshes::SetField(lattice, TestMeshes::Waves);
  vtkNew<vtkTetrahedraSimplifier> filter;
  filter->SetInputData(lattice);
  filter->SetMaximumFieldError(0.05);
  filter->ShiftScalarsOff();
  filter->Update();
  vtkUnstructuredGrid* output = filter->GetOutput();
  CHECK(output->GetNumberOfPoints() < lattice->GetNumberOfPoints());
  vtkDataArray* kept = output->GetPointData()->GetArray("ids");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const auto id = static_cast<vtkIdType>(kept->GetTuple1(i));
    CHECK(PointOf(output, i) == PointOf(lattice, id));
    CHECK(output->GetPointData()->GetScalars()->GetTuple1(i) ==
          lattice->GetPointData()->GetScalars()->GetTuple1(id));
  }
  CHECK_EQUAL(
    output->GetCellData()->GetArray("SourceCell")->GetNumberOfTuples(), output->GetNumberOfCells());
}

void CountErrors(vtkObject*, unsigned long, void* count, void*)
{
  ++*static_cast<int*>(count);
}

void AbortNow(vtkObject* caller, unsigned long, void*, void*)
{
  static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn();
}

void TestBadInput()
{
  int errors = 0;
  vtkNew<vtkCallbackCommand> count, abort;
  count->SetCallback(CountErrors);
  count->SetClientData(&errors);
  vtkNew<vtkTetrahedraSimplifier> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, count);
  vtkNew<vtkUnstructuredGrid> empty;
  filter->SetInputData(empty);
  filter->Update();
  CHECK_EQUAL(errors, 0);
  auto lattice = TetrahedraOf(SortMeshes::Make("latticeKuhn"));
  vtkDataArray* scalars = lattice->GetPointData()->GetScalars();
  scalars->SetTuple1(5, std::numeric_limits<double>::quiet_NaN());
  filter->SetInputData(lattice);
  filter->Update();
  CHECK_EQUAL(errors, 1);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), lattice->GetNumberOfCells());
  vtkNew<vtkUnstructuredGrid> bare;
  bare->CopyStructure(lattice);
  filter->SetInputData(bare);
  filter->Update();
  CHECK_EQUAL(errors, 2);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), lattice->GetNumberOfCells());
  abort->SetCallback(AbortNow);
  filter->AddObserver(vtkCommand::ProgressEvent, abort);
  const auto good = TetrahedraOf(SortMeshes::Make("latticeKuhn"));
  filter->SetInputData(good);
  filter->Update();
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
  CHECK_EQUAL(errors, 2);
}
}

int TestTetrahedraSimplifier(int, char*[])
{
  TestGenerated();
  TestData();
  TestBadInput();
  return Result();
}
