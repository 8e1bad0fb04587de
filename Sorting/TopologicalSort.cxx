#include "TopologicalSort.h"

#include <hwy/cache_control.h>

namespace TopologicalSort
{
//------------------------------------------------------------------------------
vtkIdType* Run(std::vector<WaitingCell>& cells, const std::vector<int>& longLists, CellStack& stack,
  const OrderEnd& order)
{
  // Plain pointers: this loop is most of the time that a frame takes.
  int* const bottom = stack.Cells.data();
  int* top = bottom + stack.Size;
  WaitingCell* all = cells.data();
  const OrderEnd end = order;
  vtkIdType* ordered = end.Next;
  while (top != bottom)
  {
    const int cell = *--top;
    if (cell < end.NumberOfMeshCells)
    {
      *ordered = end.InputIds[cell];
      ordered += end.Step;
    }
    const WaitingCell& own = all[cell];
    const int* next = own.Next;
    const int* last = next + own.State();
    if (own.State() == WaitingCell::LongList)
    {
      next = longLists.data() + own.Next[0];
      last = longLists.data() + own.Next[1];
    }
    for (; next != last; ++next)
    {
      // What is needed when the cell is taken: its line is here, those that it leads to may not be.
      WaitingCell& waiting = all[*next];
      hwy::Prefetch(end.InputIds + *next);
      hwy::Prefetch(all + waiting.Next[0]);
      hwy::Prefetch(all + waiting.Next[1]);
      if ((waiting.State() -= WaitingCell::Unit) < WaitingCell::Unit)
      {
        *top++ = *next;
      }
    }
  }
  stack.Size = 0;
  return ordered;
}
}
