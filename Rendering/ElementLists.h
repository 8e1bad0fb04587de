#ifndef ElementLists_h
#define ElementLists_h

#include "ActiveCells.h"

#include <vector>

/**
 * @class ElementLists
 * @brief The active cells of shell after shell as the vertices that the GPU makes elements of, one
 * per cell: the ids of its four corners and its own, counted from the first cell.
 */
class ElementLists
{
public:
  /// Of the cells `begin` to `end` - 1, whose corners, 4 ids per cell, start at `corners`. All of
  /// these must outlive the lists. Uses all threads.
  void Begin(const ShellCells& cells, const ShellPlan& plan, vtkIdType begin, vtkIdType end,
    const int* corners);
  /// To the next shell, the first one at first.
  void Advance();

  static constexpr int IntegersPerVertex = 5;
  std::vector<int> Vertices;
  int GetNumberOfElements() const
  {
    return static_cast<int>(this->Vertices.size() / IntegersPerVertex);
  }

private:
  void Write(const ActiveCells& part, int* vertex) const;

  std::vector<ActiveCells> Parts;
  const int* Corners = nullptr;
  vtkIdType FirstCell = 0;
};

#endif
