// The pipeline's filter: a permutation, follows camera and mesh, and chooses the sort by proof.

#include "SortMeshes.h"
#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkExecutive.h"
#include "vtkIdTypeArray.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVisibilityOrderFilter.h"

#include <algorithm>

namespace
{
using Ranks = std::vector<vtkIdType>;

Ranks RanksOf(vtkVisibilityOrderFilter* filter)
{
  filter->Update();
  auto* array = vtkIdTypeArray::SafeDownCast(
    filter->GetOutput()->GetCellData()->GetAbstractArray("VisibilityOrder"));
  return array ? Ranks(array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues())
               : Ranks();
}

bool IsPermutation(Ranks ranks, vtkIdType cells)
{
  std::sort(ranks.begin(), ranks.end());
  for (std::size_t i = 0; i < ranks.size(); ++i)
  {
    if (ranks[i] != static_cast<vtkIdType>(i))
    {
      return false;
    }
  }
  return static_cast<vtkIdType>(ranks.size()) == cells;
}

void CheckMethods(TestChecks& checks)
{
  auto grid = SortMeshes::Kuhn(SortMeshes::JitteredLattice(4, 0.2));
  vtkNew<vtkVisibilityOrderFilter> filter;
  filter->SetInputData(grid);
  const char* names[] = { "MPVO", "MPVO", "MPVOC", "Power", "CellCenter" };
  for (int method = 0; method < 5; ++method)
  {
    filter->SetSortMethod(method);
    CHECK(IsPermutation(RanksOf(filter), grid->GetNumberOfCells()));
    CHECK(filter->GetSortMethodUsed() == names[method]);
    CHECK(filter->GetOutput()->GetCellData()->HasArray("CyclicGroup") == (method == 2));
    CHECK(filter->GetOutput()->GetCells() == grid->GetCells());
    CHECK(filter->IsOrderProven() == (method < 3));
    CHECK((filter->GetNumberOfMisorderedFaces() < 0) == (method == 4));
    CHECK((filter->GetNumberOfMisorderedFaces() == 0) == (method < 3));
    CHECK((filter->GetNumberOfCycles() == 0) == (method < 4));
  }
  CHECK(!grid->GetCellData()->HasArray("VisibilityOrder"));
}

void CheckAutomatic(TestChecks& checks)
{
  vtkNew<vtkVisibilityOrderFilter> filter;
  filter->SetInputData(SortMeshes::Lattice(4));
  CHECK(IsPermutation(RanksOf(filter), 64));
  CHECK(filter->GetSortMethodUsed() == "Power" && filter->IsOrderProven());
  filter->ConvexifyOff();
  filter->Update();
  CHECK(filter->GetSortMethodUsed() == "MPVO");
  filter->ConvexifyOn();
  filter->SetInputData(SortMeshes::LShape());
  filter->Update();
  CHECK(filter->GetSortMethodUsed() == "MPVO" && filter->IsOrderProven());
  auto moving = SortMeshes::Lattice(4);
  filter->SetInputData(moving);
  filter->Update();
  CHECK(filter->GetSortMethodUsed() == "Power");
  moving->GetPoints()->SetPoint(62, 0.3, 0.31, 0.32);
  moving->GetPoints()->Modified();
  moving->Modified();
  filter->Update();
  CHECK(filter->GetSortMethodUsed() == "MPVO");
}

// Down the third axis the lattice's layers come from below up.
void CheckDirection(TestChecks& checks)
{
  auto grid = SortMeshes::Lattice(4);
  vtkNew<vtkVisibilityOrderFilter> filter;
  filter->SetInputData(grid);
  for (int method = 0; method < 5; ++method)
  {
    filter->SetSortMethod(method);
    const Ranks ranks = RanksOf(filter);
    int wrong = 0;
    for (vtkIdType cell = 0; cell + 16 < 64; ++cell)
    {
      wrong += ranks[cell] < ranks[cell + 16] ? 0 : 1;
    }
    CHECK_AT_MOST(wrong, 0);
  }
}

void CheckCamera(TestChecks& checks)
{
  auto grid = SortMeshes::Kuhn(SortMeshes::JitteredLattice(4, 0.2));
  vtkNew<vtkVisibilityOrderFilter> filter;
  filter->SetInputData(grid);
  filter->SetDirection(-1.0, -2.0, -3.0);
  const Ranks byDirection = RanksOf(filter);
  vtkNew<vtkCamera> camera;
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(1.0, 2.0, 3.0);
  filter->SetCamera(camera);
  CHECK(filter->GetCamera() == camera);
  CHECK(RanksOf(filter) == byDirection && filter->IsOrderProven());
  vtkMTimeType before = filter->GetMTime();
  camera->SetPosition(-1.0, -2.0, -3.0);
  CHECK(filter->GetMTime() > before);
  CHECK(RanksOf(filter) != byDirection && filter->IsOrderProven());
  before = filter->GetOutput()->GetMTime();
  filter->Update();
  CHECK(filter->GetOutput()->GetMTime() == before);
  filter->SetCamera(nullptr);
  CHECK(RanksOf(filter) == byDirection);
}

// Cells without a place in the order come last, in the input's order.
void CheckOtherCells(TestChecks& checks)
{
  vtkSmartPointer<vtkUnstructuredGrid> grid = SortMeshes::Lattice(3);
  vtkNew<vtkUnsignedCharArray> imaginary;
  imaginary->SetName("Imaginary");
  imaginary->SetNumberOfValues(27);
  imaginary->FillValue(0);
  imaginary->SetValue(0, 1);
  imaginary->SetValue(13, 1);
  grid->GetCellData()->AddArray(imaginary);
  vtkNew<vtkVisibilityOrderFilter> filter;
  filter->SetInputData(grid);
  for (const int method : { 1, 2, 3 })
  {
    filter->SetSortMethod(method);
    const Ranks ranks = RanksOf(filter);
    CHECK(IsPermutation(ranks, 27));
    CHECK(ranks[0] == 25 && ranks[13] == 26);
  }
}

void CheckEmptyAndErrors(TestChecks& checks)
{
  vtkNew<vtkUnstructuredGrid> empty;
  vtkNew<vtkVisibilityOrderFilter> filter;
  vtkNew<MessageObserver> messages;
  messages->Watch(filter);
  messages->Watch(filter->GetExecutive());
  filter->SetInputData(empty);
  for (int method = 0; method < 5; ++method)
  {
    filter->SetSortMethod(method);
    filter->Update();
    CHECK(filter->GetOutput()->GetCellData()->HasArray("VisibilityOrder") == 1);
    CHECK(RanksOf(filter).empty() && filter->GetSortMethodUsed().empty());
    CHECK(filter->GetNumberOfMisorderedFaces() == -1 && !filter->IsOrderProven());
  }
  CHECK(messages->Count() == 0);
  filter->SetDirection(0.0, 0.0, 0.0);
  filter->Update();
  CHECK(messages->CountOf("Direction has no length") == 1);
  vtkNew<vtkVisibilityOrderFilter> unconnected;
  messages->Watch(unconnected->GetExecutive());
  unconnected->Update();
  CHECK(messages->CountOf("has 0 connections") == 1);
}
}

int TestVisibilityOrderFilter(int, char*[])
{
  TestChecks checks;
  CheckMethods(checks);
  CheckAutomatic(checks);
  CheckDirection(checks);
  CheckCamera(checks);
  CheckOtherCells(checks);
  CheckEmptyAndErrors(checks);
  return checks.Result();
}
