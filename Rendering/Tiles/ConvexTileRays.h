/**
 * The ray through every pixel in mesh coordinates, in double: for cells that floats on the screen do
 * not serve.
 *
 * A ray is parametrised by its depth along the view axis from the plane through the mesh's centre;
 * whole numbers are pixel centres.
 */
#ifndef ConvexTileRays_h
#define ConvexTileRays_h

#include "TileView.h"

#include <glm/vec3.hpp>

#include <array>

class ConvexTileRays
{
public:
  void Build(const TileView::Camera& camera);

  glm::dvec3 PointAt(double x, double y) const
  {
    return this->Point[0] + x * this->Point[1] + y * this->Point[2];
  }
  glm::dvec3 DirectionAt(double x, double y) const
  {
    return this->Direction[0] + x * this->Direction[1] + y * this->Direction[2];
  }

  /** At pixel 0, 0; the change in x and in y. */
  std::array<glm::dvec3, 3> Point, Direction;
  /** Depth of the plane that depths count from; near and far plane from there. */
  double Reference = 0.0, Near = 0.0, Far = 0.0;
};

#endif
