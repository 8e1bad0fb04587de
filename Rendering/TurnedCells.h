#ifndef TurnedCells_h
#define TurnedCells_h

#include "vtkType.h"

#include <vector>

/**
 * @class TurnedCells
 * @brief Tetrahedra that moved points have turned inside out.
 */
class TurnedCells
{
public:
  /// How the cells are now. `points` 4 floats each, `corners` 4 ids per cell. Uses all threads.
  void TakeSides(const std::vector<float>& points, const std::vector<int>& corners);

  /// How many cells are on the other side with these points.
  vtkIdType Count(const std::vector<float>& points, const std::vector<int>& corners) const;
  /// How many of these.
  vtkIdType Count(const std::vector<float>& points, const std::vector<int>& corners,
    const std::vector<int>& cells) const;

private:
  template <class CellAt>
  vtkIdType CountAmong(vtkIdType count, const std::vector<float>& points,
    const std::vector<int>& corners, const CellAt& cellAt) const;

  std::vector<signed char> Sides;
};

#endif
