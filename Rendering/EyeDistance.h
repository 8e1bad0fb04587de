#ifndef EyeDistance_h
#define EyeDistance_h

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

class ViewRays;

/**
 * @class EyeDistance
 * @brief How far points are from the eye, in world lengths, as shells count it: spheres around the
 * eye in perspective, planes across the view in parallel projection.
 */
class EyeDistance
{
public:
  explicit EyeDistance(const ViewRays& rays);

  /// From the eye to a point in mesh coordinates; in parallel projection its distance is z.
  glm::dvec3 To(const glm::dvec3& point) const;
  /// The distance of what To returned.
  double Of(const glm::dvec3& vector) const;
  /// A tetrahedron's corners, as To returned them: bounds of its distances.
  void FindRange(const glm::dvec3 (&corners)[4], double range[2]) const;

private:
  bool IsParallel;
  glm::dmat4 MeshToEye;
};

#endif
