#ifndef VoxelApproximation_h
#define VoxelApproximation_h

#include "CellApproximation.h"

/**
 * @class VoxelApproximation
 * @brief The faces that look to the eye in one colour and one opacity per cell.
 *
 * Paper: Williams, "Interactive splatting of nonrectilinear volumes", 1992, as in Cignoni et al.
 * 1995: the mean of colour and opacity of the corners, whatever the cell's thickness. The opacities
 * are those of a thickness that is one for the mesh, given by the caller.
 */
class VoxelApproximation : public CellApproximation
{
public:
  /// `thickness`: world length.
  explicit VoxelApproximation(double thickness)
    : Thickness(thickness)
  {
  }

  glm::vec4 Classify(const glm::vec4& value) const override;
  void Append(const ProjectedTetrahedron& cell, ApproximationTriangles& triangles) const override;

private:
  double Thickness;
};

#endif
