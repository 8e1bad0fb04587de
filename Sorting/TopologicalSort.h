/**
 * The loop of a topological sort that takes the cell released last, so that it moves through
 * neighbours in memory.
 */
#ifndef TopologicalSort_h
#define TopologicalSort_h

#include "vtkType.h"

#include <vector>

/** What the sort touches of a cell, in a quarter of a line of the cache. */
struct alignas(16) WaitingCell
{
  static constexpr int Unit = 8;
  static constexpr int LongList = 4;

  /** The cells that it releases, or where they begin and end in the long lists; the last is the
   *  state: cells that must come before it and are not in the order yet, times Unit, plus the
   *  number of those that it releases; LongList instead of that number where they are more than
   *  three. */
  int Next[4];

  int& State() { return this->Next[3]; }
  int State() const { return this->Next[3]; }
  bool IsWaiting() const { return this->State() >= Unit; }
};

/** Cells to take next, the last first. */
struct CellStack
{
  /** Room for every cell; what is at Size and after it means nothing. */
  std::vector<int> Cells;
  int Size = 0;

  void Push(int cell) { this->Cells[this->Size++] = cell; }
};

/** One end of the order, and where it grows to. */
struct OrderEnd
{
  /** The id by which a cell stands in the order, of the cells of the mesh; others are left out. */
  const int* InputIds;
  int NumberOfMeshCells;
  vtkIdType* Next;
  int Step;
};

namespace TopologicalSort
{
/** Takes cells off `stack` and puts those released on it, until it is empty. Returns where the next
 *  cell would go. What waits for a circle stays out. */
vtkIdType* Run(std::vector<WaitingCell>& cells, const std::vector<int>& longLists, CellStack& stack,
  const OrderEnd& order);
}

#endif
