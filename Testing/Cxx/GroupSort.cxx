#include "GroupSort.h"

#include "vtkCamera.h"
#include "vtkDataSet.h"
#include "vtkIdTypeArray.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <numeric>
#include <random>

vtkStandardNewMacro(GroupSort);

//------------------------------------------------------------------------------
void GroupSort::Modified()
{
  this->SettingsTime.Modified();
  this->Superclass::Modified();
}

//------------------------------------------------------------------------------
void GroupSort::FindInnerOrder(std::vector<vtkIdType>& order)
{
  order.clear();
  if (!this->Inner)
  {
    order.resize(static_cast<size_t>(this->Input->GetNumberOfCells()));
    std::iota(order.begin(), order.end(), 0);
    return;
  }
  this->Inner->SetInput(this->Input);
  this->Inner->SetCamera(this->Camera);
  this->Inner->SetModelTransform(this->ModelTransform);
  this->Inner->InitTraversal();
  while (vtkIdTypeArray* batch = this->Inner->GetNextCells())
  {
    order.insert(
      order.end(), batch->GetPointer(0), batch->GetPointer(0) + batch->GetNumberOfTuples());
  }
}

//------------------------------------------------------------------------------
const std::vector<vtkIdType>& GroupSort::SortCells(const double*)
{
  std::vector<vtkIdType>& order = this->Order;
  ++this->NumberOfSorts;
  this->FindInnerOrder(order);
  const auto cells = static_cast<vtkIdType>(order.size());
  const vtkIdType size = this->GroupSize > 0 ? this->GroupSize : cells;
  std::mt19937 random(1);
  this->GroupCells.clear();
  this->GroupOffsets = { 0 };
  for (vtkIdType begin = 0; begin < cells; begin += 2 * size)
  {
    const auto first = order.begin() + begin;
    const auto last = order.begin() + std::min(begin + size, cells);
    std::shuffle(first, last, random);
    this->GroupCells.insert(this->GroupCells.end(), first, last);
    this->GroupOffsets.push_back(static_cast<vtkIdType>(this->GroupCells.size()));
  }
  return order;
}

//------------------------------------------------------------------------------
void GroupSort::FindCyclicGroups(std::vector<vtkIdType>& cells, std::vector<vtkIdType>& offsets)
{
  cells = this->GroupCells;
  offsets = this->GroupOffsets;
}
