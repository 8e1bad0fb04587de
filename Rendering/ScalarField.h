#ifndef ScalarField_h
#define ScalarField_h

#include "vtkType.h"

#include <array>
#include <vector>

class vtkDataArray;

/**
 * @class ScalarField
 * @brief One scalar per point or cell, normalised over the range in which the transfer function
 * changes.
 */
class ScalarField
{
public:
  /// `component`: which of the array's components; -1 takes the magnitude. `limits`: beyond them
  /// the transfer function is constant, and 0 and 1 of the normalised scalars lie within them.
  void Build(vtkDataArray* array, int component, bool onePerCell, const double limits[2]);

  /// Range, normalised.
  std::array<float, 2> GetNormalisedRange() const;

  /// The least and the greatest normalised scalar of a cell; false where one is not finite.
  bool FindCellRange(vtkIdType cell, const int* corners, int count, float range[2]) const;

  /// One per tuple; not a number where the array's value is not finite.
  std::vector<float> Values;
  /// The least and the greatest finite value.
  double Range[2] = { 0.0, 0.0 };
  /// What 0 and 1 stand for.
  double Normal[2] = { 0.0, 0.0 };
  bool OnePerCell = false;
  vtkIdType NumberOfNonFiniteValues = 0;

private:
  void FindRange(vtkDataArray* array, int component);
};

#endif
