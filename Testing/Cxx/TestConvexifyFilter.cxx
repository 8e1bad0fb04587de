// The filter's arrays, its counts, what it does with data, abort, repetition and cells of other
// kinds.

#include "SortMeshes.h"
#include "TestScene.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkConvexifyFilter.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace
{
vtkIdType CountMarks(vtkUnstructuredGrid* grid)
{
  auto* marks = vtkUnsignedCharArray::SafeDownCast(grid->GetCellData()->GetArray("Imaginary"));
  vtkIdType count = 0;
  for (vtkIdType i = 0; marks && i < marks->GetNumberOfTuples(); ++i)
  {
    count += marks->GetValue(i);
  }
  return count;
}

// Two slabs with a gap: one box of a cell between them.
void TestArrays(TestChecks& checks)
{
  auto slabs = SortMeshes::Make("slabs");
  const vtkIdType cells = slabs->GetNumberOfCells();
  vtkNew<vtkConvexifyFilter> filter;
  filter->SetInputData(slabs);
  filter->Update();
  vtkUnstructuredGrid* output = filter->GetOutput();
  CHECK(!filter->GetInputConvex());
  CHECK(filter->GetNumberOfImaginaryCells() == 1);
  CHECK(output->GetNumberOfCells() == cells + 1);
  CHECK(CountMarks(output) == 1);
  CHECK(output->GetCellType(cells) == VTK_POLYHEDRON);
  CHECK_NEAR(filter->GetFacesPerImaginaryCell(), 6.0, 0.0);
  vtkDataArray* contacts = output->GetFieldData()->GetArray("ImaginaryContacts");
  CHECK(contacts && contacts->GetNumberOfComponents() == 5 && contacts->GetNumberOfTuples() > 0);
  for (vtkIdType i = 0; contacts && i < contacts->GetNumberOfTuples(); ++i)
  {
    // Between a cell of the mesh and the imaginary one.
    CHECK((contacts->GetComponent(i, 3) == cells) != (contacts->GetComponent(i, 4) == cells));
  }
  vtkDataArray* scalars = output->GetPointData()->GetScalars();
  CHECK(scalars && scalars->GetNumberOfTuples() == output->GetNumberOfPoints());
  for (vtkIdType i = 0; scalars && i < slabs->GetNumberOfPoints(); ++i)
  {
    CHECK(scalars->GetComponent(i, 0) == slabs->GetPointData()->GetScalars()->GetComponent(i, 0));
  }
}

void TestPassedOn(TestChecks& checks)
{
  vtkNew<vtkConvexifyFilter> first, second;
  first->SetInputData(SortMeshes::Make("lShape"));
  second->SetInputConnection(first->GetOutputPort());
  second->Update();
  CHECK(second->GetNumberOfImaginaryCells() == 0);
  CHECK(second->GetOutput()->GetNumberOfCells() == first->GetOutput()->GetNumberOfCells());
  CHECK(CountMarks(second->GetOutput()) == first->GetNumberOfImaginaryCells());
  vtkNew<vtkConvexifyFilter> convex;
  convex->SetInputData(SortMeshes::Make("latticeKuhn"));
  convex->Update();
  CHECK(convex->GetInputConvex());
  CHECK(convex->GetNumberOfImaginaryCells() == 0 && CountMarks(convex->GetOutput()) == 0);
}

// A box has corners that no ray between two cells meets.
void TestDiscard(TestChecks& checks)
{
  vtkNew<vtkConvexifyFilter> filter;
  filter->SetInputData(SortMeshes::Make("torus"));
  filter->SetEnclosureToBoundingBox();
  filter->Update();
  const vtkIdType kept = filter->GetNumberOfImaginaryCells();
  const vtkIdType discarded = filter->GetNumberOfDiscardedCells();
  const double volume = filter->GetImaginaryVolume() + filter->GetDiscardedVolume();
  CHECK(discarded > 0);
  filter->DiscardOutsideHullOff();
  filter->Update();
  CHECK(filter->GetNumberOfDiscardedCells() == 0 && filter->GetDiscardedVolume() == 0.0);
  CHECK(filter->GetNumberOfImaginaryCells() == kept + discarded);
  CHECK_NEAR(filter->GetImaginaryVolume(), volume, 1e-12 * volume);
}

// More cuts to choose from give no more cells, here; the same input gives the same cells.
void TestCandidates(TestChecks& checks)
{
  vtkNew<vtkConvexifyFilter> filter;
  filter->SetInputData(SortMeshes::Make("gears"));
  filter->SetNumberOfCandidateCuts(1);
  filter->Update();
  const vtkIdType one = filter->GetNumberOfImaginaryCells();
  filter->SetNumberOfCandidateCuts(20);
  filter->Update();
  const vtkIdType twenty = filter->GetNumberOfImaginaryCells();
  CHECK(twenty < one);
  filter->Modified();
  filter->Update();
  CHECK(filter->GetNumberOfImaginaryCells() == twenty);
}

void AbortNow(vtkObject* caller, unsigned long, void* calls, void*)
{
  ++*static_cast<int*>(calls);
  static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn();
}

void TestAbort(TestChecks& checks)
{
  vtkNew<vtkConvexifyFilter> filter;
  filter->SetInputData(SortMeshes::Make("gears"));
  int calls = 0;
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(AbortNow);
  abort->SetClientData(&calls);
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, abort);
  filter->Update();
  CHECK(calls > 0);
  CHECK(filter->GetNumberOfImaginaryCells() == 0);
  filter->RemoveObserver(tag);
  filter->AbortExecuteOff();
  filter->Modified();
  filter->Update();
  CHECK(filter->GetNumberOfImaginaryCells() > 0);
}

void TestLeast(TestChecks& checks)
{
  vtkNew<vtkUnstructuredGrid> empty;
  vtkNew<vtkConvexifyFilter> filter;
  filter->SetInputData(empty);
  filter->Update();
  CHECK(filter->GetOutput()->GetNumberOfCells() == 0);
  auto mixed = SortMeshes::Make("slabs");
  const vtkIdType cells = mixed->GetNumberOfCells();
  const vtkIdType ids[3] = { 0, 1, 7 };
  mixed->InsertNextCell(VTK_TRIANGLE, 3, ids);
  filter->SetInputData(mixed);
  filter->Update();
  // The triangle keeps its place, the imaginary cell comes after it.
  CHECK(filter->GetOutput()->GetCellType(cells) == VTK_TRIANGLE);
  CHECK(filter->GetOutput()->GetCellType(cells + 1) == VTK_POLYHEDRON);
}
}

int TestConvexifyFilter(int, char*[])
{
  TestChecks checks;
  TestArrays(checks);
  TestPassedOn(checks);
  TestDiscard(checks);
  TestCandidates(checks);
  TestAbort(checks);
  TestLeast(checks);
  return checks.Result();
}
