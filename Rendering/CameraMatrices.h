/**
 * What a camera's matrices must have for anything to be seen: an inverse, and a near and a far plane.
 *
 * A matrix of doubles has no far plane where the near one is 1e-16 of it, and an inverse all the same.
 */
#ifndef CameraMatrices_h
#define CameraMatrices_h

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <cmath>

namespace CameraMatrices
{
inline bool IsInvertible(const glm::dmat4& matrix)
{
  const double determinant = glm::determinant(matrix);
  return std::isfinite(determinant) && determinant != 0.0;
}

/** The view depth of the near plane (`z` is -1) or the far one (1); not finite where there is none. */
inline double DepthOfPlane(const glm::dmat4& clipToView, double z)
{
  const glm::dvec4 point = clipToView * glm::dvec4(0.0, 0.0, z, 1.0);
  return -point.z / point.w;
}
}

#endif
