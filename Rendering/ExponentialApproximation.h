#ifndef ExponentialApproximation_h
#define ExponentialApproximation_h

#include "CellApproximation.h"

/**
 * @class ExponentialApproximation
 * @brief Shirley's and Tuchman's triangles with extinction and length interpolated, not opacity.
 *
 * Paper: Stein, Becker and Max, "Sorting and hardware assisted rendering for volume visualization",
 * 1994, where a texture holds the exponential. Of constant extinction it is exact in parallel
 * projection, where the length inside a cell is linear on its triangles.
 */
class ExponentialApproximation : public CellApproximation
{
public:
  bool IsExponential() const override { return true; }
  void Append(const ProjectedTetrahedron& cell, ApproximationTriangles& triangles) const override;
};

#endif
