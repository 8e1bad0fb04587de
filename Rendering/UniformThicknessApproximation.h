#ifndef UniformThicknessApproximation_h
#define UniformThicknessApproximation_h

#include "CellApproximation.h"

/**
 * @class UniformThicknessApproximation
 * @brief Uniform thickness slabs: faces with colour and opacity of their corners, all cells alike
 * thick.
 *
 * Paper: Williams, "Interactive splatting of nonrectilinear volumes", 1992; as UTS1 and UTS2 in
 * Cignoni et al. 1995. UTS1 draws the faces that look to the eye; UTS2 draws the one back face
 * where three look to the eye. The paper gives no thickness; here it is one for the mesh, given by
 * the caller.
 */
class UniformThicknessApproximation : public CellApproximation
{
public:
  /// `thickness`: world length.
  UniformThicknessApproximation(double thickness, bool oneFaceForThree)
    : Thickness(thickness)
    , OneFaceForThree(oneFaceForThree)
  {
  }

  glm::vec4 Classify(const glm::vec4& value) const override;
  void Append(const ProjectedTetrahedron& cell, ApproximationTriangles& triangles) const override;

  /// Colour and opacity of a slab.
  static glm::vec4 ClassifySlab(const glm::vec4& value, double thickness);
  /// Corners, and behind them (before them) the slab.
  static ApproximationTriangles::Rim MakeSlab(
    const ProjectedTetrahedron& cell, double thickness, bool isFront);

private:
  double Thickness;
  bool OneFaceForThree;
};

#endif
