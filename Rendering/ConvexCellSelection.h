#ifndef ConvexCellSelection_h
#define ConvexCellSelection_h

#include "ConvexCellFaces.h"
#include "vtkType.h"

#include <functional>
#include <vector>

class ScalarField;

/**
 * @class ConvexCellSelection
 * @brief Which cells are worth drawing.
 */
class ConvexCellSelection
{
public:
  /// Whether a cell whose scalars reach from `low` to `high`, normalised, changes no pixel.
  using Emptiness = std::function<bool(float low, float high)>;

  /// Finds the cells with a scalar that is not finite and those that are empty.
  void Classify(
    const ConvexCellFaces::Rows& corners, const ScalarField& scalars, const Emptiness& isEmpty);

  bool IsDrawn(int cell) const { return this->Classes[cell] == Drawn; }

  /// Ascending.
  std::vector<unsigned int> DrawnCells;
  vtkIdType NumberOfTransparentCells = 0;
  vtkIdType NumberOfInvalidCells = 0;

private:
  enum Class : unsigned char
  {
    Drawn,
    Transparent,
    Invalid
  };
  std::vector<Class> Classes;
};

#endif
