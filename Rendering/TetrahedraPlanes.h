#ifndef TetrahedraPlanes_h
#define TetrahedraPlanes_h

#include "vtkType.h"

#include <vector>

class ScalarField;

/**
 * @class TetrahedraPlanes
 * @brief What a fragment needs of its tetrahedron: the planes of the faces, the corners' scalars.
 *
 * A face's plane is computed in double from its corners in ascending order of their ids and
 * anchored at the first of them, so the two cells of a shared face hold the same numbers: no ray
 * can slip between them, however thin they are.
 *
 * Planes: 6 x 4 floats per cell. For the face opposite corner i, i = 0..3: normal and inverse
 * height of corner i over it, below zero where the normal points away from the cell, 0 for a flat
 * cell; then corner 0, which lies on faces 1, 2 and 3, and corner 1, which lies on face 0, each
 * with one unused.
 */
class TetrahedraPlanes
{
public:
  /// `points` 4 floats each, `corners` 4 ascending ids per cell.
  static std::vector<float> Planes(
    const std::vector<float>& points, const std::vector<int>& corners);

  /// Cells that are flat once their points are floats: no fragment draws them.
  static vtkIdType CountFlatCells(const std::vector<float>& planes);

  /// 4 floats per cell; a cell's own scalar stands four times.
  static std::vector<float> Scalars(const ScalarField& scalars, const std::vector<int>& corners);
};

#endif
