#ifndef NearPlaneCut_h
#define NearPlaneCut_h

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <vector>

/**
 * @class NearPlaneCut
 * @brief The part of a convex cell's surface before a plane, closed by a cap in that plane.
 *
 * Triangles that share an edge get the same point on it, and so does the cap: no pixel falls
 * between them. Scalars are interpolated along the edges.
 */
class NearPlaneCut
{
public:
  /// A corner: point and scalar.
  using Triangle = std::array<glm::vec4, 3>;

  /// `plane`: normal and offset, the positive side stays.
  explicit NearPlaneCut(const glm::vec4& plane)
    : Plane(plane)
  {
  }

  /// Counterclockwise as seen from outside.
  void AddTriangle(const Triangle& triangle);
  /// Closes the cell and returns all of its triangles; the next cell may follow.
  std::vector<Triangle> Finish();

private:
  float HeightOf(const glm::vec4& corner) const;
  glm::vec4 Cross(const glm::vec4& a, const glm::vec4& b) const;
  void AddCap();

  glm::vec4 Plane;
  std::vector<Triangle> Kept;
  std::vector<glm::vec4> Rim;
};

#endif
