#include "TopologicalSort.h"

namespace TopologicalSort
{
//------------------------------------------------------------------------------
int* Run(std::vector<WaitingCell>& cells, const std::vector<int>& longLists,
  CellStack& stack, int numberOfMeshCells, int* ordered, int step)
{
  // Plain pointers: this loop is most of the time that a frame takes.
  int* const bottom = stack.Cells.data();
  int* top = bottom + stack.Size;
  WaitingCell* all = cells.data();
  while (top != bottom)
  {
    const int cell = *--top;
    if (cell < numberOfMeshCells)
    {
      *ordered = cell;
      ordered += step;
    }
    const WaitingCell& own = all[cell];
    const int* next = own.Next;
    const int* end = next + own.State();
    if (own.State() == WaitingCell::LongList)
    {
      next = longLists.data() + own.Next[0];
      end = longLists.data() + own.Next[1];
    }
    for (; next != end; ++next)
    {
      if ((all[*next].State() -= WaitingCell::Unit) < WaitingCell::Unit)
      {
        *top++ = *next;
      }
    }
  }
  stack.Size = 0;
  return ordered;
}
}
