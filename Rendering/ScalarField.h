#ifndef ScalarField_h
#define ScalarField_h

#include "vtkType.h"

#include <vector>

class vtkDataArray;

/**
 * @class ScalarField
 * @brief One scalar per point or cell, normalised to [0,1] over its finite range.
 */
class ScalarField
{
public:
  /// `component`: which of the array's components; -1 takes the magnitude.
  void Build(vtkDataArray* array, int component, bool onePerCell);

  /// One per tuple; not a number where the array's value is not finite.
  std::vector<float> Values;
  double Range[2] = { 0.0, 0.0 };
  bool OnePerCell = false;
  vtkIdType NumberOfNonFiniteValues = 0;

private:
  void FindRange(vtkDataArray* array, int component);
};

#endif
