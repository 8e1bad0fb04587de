#include "DrawnCells.h"

#include "BackToFrontOrder.h"
#include "ShellCells.h"
#include "TetrahedraSelection.h"

//------------------------------------------------------------------------------
template <class Predicate>
void DrawnCells::Append(
  const vtkIdType* begin, const vtkIdType* end, const Predicate& isDrawn, bool isCyclic)
{
  const int first = static_cast<int>(this->Cells.size());
  for (const vtkIdType* cell = begin; cell != end; ++cell)
  {
    if (isDrawn(*cell))
    {
      this->Cells.push_back(static_cast<unsigned int>(*cell));
    }
  }
  const int count = static_cast<int>(this->Cells.size()) - first;
  // What is left of a group may be a single cell, which hides nothing but itself.
  const bool peeled = isCyclic && count > 1 && count <= LargestGroup;
  this->NumberOfUnresolvedCells += isCyclic && count > LargestGroup ? count : 0;
  if (count == 0)
  {
    return;
  }
  if (!peeled && !this->Runs.empty() && !this->Runs.back().IsCyclic)
  {
    this->Runs.back().Count += count;
    return;
  }
  this->Runs.push_back({ first, count, peeled });
}

//------------------------------------------------------------------------------
template <class Predicate>
void DrawnCells::BuildFrom(const BackToFrontOrder& order, const Predicate& isDrawn)
{
  this->Cells.clear();
  this->Cells.reserve(order.Cells.size());
  this->Runs.clear();
  this->NumberOfUnresolvedCells = 0;
  const vtkIdType* cells = order.Cells.data();
  vtkIdType done = 0;
  for (const BackToFrontOrder::Span& group : order.CyclicGroups)
  {
    this->Append(cells + done, cells + group.Begin, isDrawn, false);
    this->Append(cells + group.Begin, cells + group.End, isDrawn, true);
    done = group.End;
  }
  this->Append(cells + done, cells + order.Cells.size(), isDrawn, false);
}

//------------------------------------------------------------------------------
void DrawnCells::Build(const BackToFrontOrder& order, const TetrahedraSelection& selection)
{
  this->BuildFrom(order, [&selection](vtkIdType cell) { return selection.IsDrawn(cell); });
}

//------------------------------------------------------------------------------
void DrawnCells::Build(const BackToFrontOrder& order, const ShellCells& cells)
{
  this->BuildFrom(order, [&cells](vtkIdType cell) { return cells.IsSeen(cell); });
}
