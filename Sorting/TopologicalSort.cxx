#include "TopologicalSort.h"

#include <cstddef>

namespace TopologicalSort
{
//------------------------------------------------------------------------------
int* Run(std::vector<WaitingCell>& cells, const std::vector<int>& longLists,
  std::vector<int>& stack, int numberOfMeshCells, int* ordered, int step)
{
  // Plain pointers: this loop is most of the time that a frame takes.
  const std::size_t sources = stack.size();
  stack.resize(cells.size() + 1);
  int* top = stack.data() + sources;
  WaitingCell* all = cells.data();
  while (top != stack.data())
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
  stack.clear();
  return ordered;
}
}
