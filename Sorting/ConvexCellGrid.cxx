#include "ConvexCellGrid.h"

#include "CarriedData.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace
{
// Of all ways to give a grid its polyhedra this one is the same in every VTK.
void InsertCells(vtkUnstructuredGrid* grid, vtkUnsignedCharArray* types, const vtkIdType* offsets,
  const vtkIdType* ids)
{
  grid->Allocate(types->GetNumberOfValues());
  vtkNew<vtkIdList> list;
  for (vtkIdType cell = 0; cell < types->GetNumberOfValues(); ++cell)
  {
    const vtkIdType begin = offsets[cell], end = offsets[cell + 1];
    list->SetNumberOfIds(end - begin);
    std::copy(ids + begin, ids + end, list->GetPointer(0));
    grid->InsertNextCell(types->GetValue(cell), list);
  }
  grid->Squeeze();
}
}

ConvexCellGrid::ConvexCellGrid() = default;
ConvexCellGrid::~ConvexCellGrid() = default;

void ConvexCellGrid::Allocate(const ConvexCellCursor& end)
{
  this->Types->SetNumberOfValues(end.Cell);
  this->Offsets->SetNumberOfValues(end.Cell + 1);
  this->Offsets->SetValue(end.Cell, end.Id);
  this->Ids->SetNumberOfValues(end.Id);
  this->SourceCells->SetName("SourceCell");
  this->SourceCells->SetNumberOfValues(end.Cell);
}

ConvexCellArrays ConvexCellGrid::GetArrays()
{
  return { this->Types->GetPointer(0), this->Offsets->GetPointer(0), this->Ids->GetPointer(0),
    this->SourceCells->GetPointer(0) };
}

void ConvexCellGrid::MakeCells()
{
  this->Cells = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const unsigned char* begin = this->Types->GetPointer(0);
  const unsigned char* end = begin + this->Types->GetNumberOfValues();
  if (std::find(begin, end, VTK_POLYHEDRON) != end)
  {
    InsertCells(
      this->Cells, this->Types, this->Offsets->GetPointer(0), this->Ids->GetPointer(0));
    return;
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(this->Offsets, this->Ids);
  this->Cells->SetCells(this->Types, cells);
}

void ConvexCellGrid::FillCells(vtkUnstructuredGrid* output)
{
  if (!this->Cells)
  {
    this->MakeCells();
  }
  output->CopyStructure(this->Cells);
}

ConvexCellFates::ConvexCellFates(const std::vector<ConvexCellPlan>& plans)
  : NumberOfCells(static_cast<vtkIdType>(plans.size()))
{
  for (const ConvexCellPlan& plan : plans)
  {
    this->AllWhole = this->AllWhole && plan.Fate == ConvexCellPlan::Whole;
    this->AnyTetrahedra = this->AnyTetrahedra || plan.Fate == ConvexCellPlan::Tetrahedra;
    this->AnyImaginary = this->AnyImaginary || plan.Fate == ConvexCellPlan::Imaginary;
  }
}

void ConvexCellGrid::FillCellData(
  vtkCellData* input, const ConvexCellFates& fates, vtkCellData* output) const
{
  const auto whole = CarriedData::WholeArrays(input, fates.NumberOfCells);
  if (fates.AllWhole)
  {
    output->PassData(whole);
  }
  else
  {
    CarriedData::CopyTuples(whole, output, this->SourceCells->GetPointer(0),
      this->SourceCells->GetNumberOfValues());
  }
  if (fates.AnyTetrahedra)
  {
    output->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
  }
  if (fates.AnyImaginary)
  {
    output->RemoveArray("Imaginary");
  }
  output->AddArray(this->SourceCells);
}

std::vector<int> ConvexCellGrid::CountBySource(vtkIdType inputCells) const
{
  std::vector<int> counts(inputCells, 0);
  const vtkIdType* source = this->SourceCells->GetPointer(0);
  for (vtkIdType cell = 0; cell < this->SourceCells->GetNumberOfValues(); ++cell)
  {
    ++counts[source[cell]];
  }
  return counts;
}
