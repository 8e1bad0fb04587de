#ifndef DrawnCells_h
#define DrawnCells_h

#include "vtkType.h"

#include <vector>

class BackToFrontOrder;
class ShellCells;
class TetrahedraSelection;

/**
 * @class DrawnCells
 * @brief The cells worth drawing from back to front, in runs: one after the other as they come, or
 * a group that is put in order per pixel.
 */
class DrawnCells
{
public:
  struct Run
  {
    int First = 0; ///< index into Cells
    int Count = 0;
    bool IsCyclic = false;
  };

  void Build(const BackToFrontOrder& order, const TetrahedraSelection& selection);
  /// Those that are seen.
  void Build(const BackToFrontOrder& order, const ShellCells& cells);

  std::vector<unsigned int> Cells;
  std::vector<Run> Runs;
  /// Cells of groups beyond LargestGroup: they are drawn as they come, not resolved.
  vtkIdType NumberOfUnresolvedCells = 0;

  /// Peeling costs the group twice per layer: a larger one takes a minute a frame in software.
  static constexpr int LargestGroup = 1500;

private:
  template <class Predicate>
  void BuildFrom(const BackToFrontOrder& order, const Predicate& isDrawn);
  template <class Predicate>
  void Append(
    const vtkIdType* begin, const vtkIdType* end, const Predicate& isDrawn, bool isCyclic);
};

#endif
