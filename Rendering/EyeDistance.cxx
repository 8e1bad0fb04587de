#include "EyeDistance.h"

#include "ViewRays.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

#include <algorithm>

//------------------------------------------------------------------------------
EyeDistance::EyeDistance(const ViewRays& rays)
  : IsParallel(rays.Eye.w == 0.0)
  , MeshToEye(rays.MeshToWorld)
{
  if (this->IsParallel)
  {
    const double lengthPerDepth = glm::length(glm::dvec3(rays.World[0]));
    const glm::dvec4 distance = -lengthPerDepth * glm::row(rays.MeshToView, 2);
    this->MeshToEye = glm::row(glm::dmat4(0.0), 2, distance);
    return;
  }
  this->MeshToEye[3] -= rays.MeshToWorld * rays.Eye;
}

//------------------------------------------------------------------------------
glm::dvec3 EyeDistance::To(const glm::dvec3& point) const
{
  return glm::dvec3(this->MeshToEye * glm::dvec4(point, 1.0));
}

//------------------------------------------------------------------------------
double EyeDistance::Of(const glm::dvec3& vector) const
{
  return this->IsParallel ? vector.z : glm::length(vector);
}

//------------------------------------------------------------------------------
void EyeDistance::FindRange(const glm::dvec3 (&corners)[4], double range[2]) const
{
  // No point is nearer than its share along an axis, whatever the axis; the cell's own is a good
  // one.
  const glm::dvec3 middle = corners[0] + corners[1] + corners[2] + corners[3];
  const double length = glm::length(middle);
  const glm::dvec3 axis =
    this->IsParallel || !(length > 0.0) ? glm::dvec3(0.0, 0.0, 1.0) : middle / length;
  range[0] = glm::dot(axis, corners[0]);
  range[1] = this->Of(corners[0]);
  for (int i = 1; i < 4; ++i)
  {
    range[0] = std::min(range[0], glm::dot(axis, corners[i]));
    range[1] = std::max(range[1], this->Of(corners[i]));
  }
  range[0] = this->IsParallel ? range[0] : std::max(range[0], 0.0);
}
