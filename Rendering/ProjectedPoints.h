#ifndef ProjectedPoints_h
#define ProjectedPoints_h

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

class ViewRays;

/**
 * @class ProjectedPoints
 * @brief A mesh's points as the eye of one frame sees them.
 */
class ProjectedPoints
{
public:
  struct Point
  {
    /// x, y and w in clip coordinates: points on one ray differ by a factor, and whatever is linear
    /// in space is linear in these, in perspective and parallel projection.
    glm::dvec3 Ray;
    /// Along the view axis, from the reference plane of class ViewRays.
    double Depth;
    /// World length of a depth of 1 along the ray through the point.
    double Length;
    /// Mesh coordinates.
    glm::dvec3 Place;

    /// Normalised device coordinates; of points before the near plane only.
    glm::dvec2 GetScreen() const { return glm::dvec2(this->Ray) / this->Ray.z; }
  };

  /// `points`: 4 floats each, mesh coordinates. Keeps the address of `rays`.
  void Build(const std::vector<float>& points, const ViewRays& rays);

  const Point& operator[](int id) const { return this->Points[id]; }
  /// Where the edge from `kept` to `lost` meets the near plane, `weight` of the way.
  Point CutAtNearPlane(const Point& kept, const Point& lost, double& weight) const;
  bool IsBeforeNearPlane(const Point& point) const { return point.Depth > this->Near; }

  double LengthAt(const glm::dvec2& screen) const;

private:
  Point Project(const glm::dvec3& place) const;

  std::vector<Point> Points;
  const ViewRays* Rays = nullptr;
  double Near = 0.0;
};

#endif
