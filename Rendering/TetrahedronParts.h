#ifndef TetrahedronParts_h
#define TetrahedronParts_h

#include "ProjectedPoints.h"
#include "ProjectedTetrahedron.h"

#include <vector>

/**
 * @class TetrahedronParts
 * @brief What the near plane leaves of a tetrahedron: nothing, the cell, or parts of it.
 *
 * Cells that share an edge cut it at one point. One corner left makes a smaller tetrahedron, two or
 * three a prism of three.
 */
namespace TetrahedronParts
{
/// From back to front.
std::vector<ProjectedTetrahedron> BeforeNearPlane(const ProjectedPoints& points,
  const ProjectedTetrahedron::Corners& corners, const ProjectedTetrahedron::Values& values,
  int cell);
}

#endif
