#ifndef ActiveCells_h
#define ActiveCells_h

#include "vtkType.h"

#include <vector>

class ShellCells;
class ShellPlan;

/**
 * @class ActiveCells
 * @brief The cells of a part of the mesh that overlap a shell, shell after shell from front to
 * back.
 *
 * A cell enters the list with its first shell and leaves it when its last has passed.
 */
class ActiveCells
{
public:
  /// Of the cells `begin` to `end` - 1.
  void Begin(const ShellCells& cells, const ShellPlan& plan, vtkIdType begin, vtkIdType end);
  /// To the next shell, the first one at first.
  void Advance();

  std::vector<vtkIdType> Cells;

private:
  struct Entry
  {
    vtkIdType Cell;
    int LastShell;
  };
  // Sorted by first shell: those of shell s are Starts[s] .. Starts[s + 1] - 1.
  std::vector<Entry> Entries;
  std::vector<vtkIdType> Starts;
  std::vector<Entry> Active;
  int Shell = -1;
};

#endif
