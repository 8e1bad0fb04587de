#ifndef CutCells_h
#define CutCells_h

#include "ConvexCellFaces.h"

#include <glm/vec4.hpp>

#include <vector>

class ConvexCellSelection;
class ViewRays;

/**
 * @class CutCells
 * @brief The cells through which the near plane, the far plane or a clipping plane goes.
 */
namespace CutCells
{
/// Planes in mesh coordinates, normal and offset, the positive side stays: near plane, far plane,
/// then the clipping planes, which are given in view coordinates.
std::vector<glm::vec4> Planes(const ViewRays& rays, const std::vector<glm::vec4>& clippingPlanes);

/// Of the drawn cells those with corners on both sides of a plane, or on it. `points`: 4 floats
/// each.
std::vector<unsigned int> Find(const std::vector<float>& points,
  const ConvexCellFaces::Rows& corners, const ConvexCellSelection& selection,
  const std::vector<glm::vec4>& planes);

/// Of the drawn cells those that are behind the plane as a whole, ascending.
std::vector<unsigned int> FindBehind(const std::vector<float>& points,
  const ConvexCellFaces::Rows& corners, const ConvexCellSelection& selection,
  const glm::vec4& plane);
}

#endif
