/**
 * One cell whose faces are not plane, or which is not convex, as a closed surface of triangles: a
 * ray enters at the first and leaves at the last triangle that it meets. Scalars are linear on each
 * triangle and between entry and exit.
 *
 * Neighbours of such cells may overlap where a ray meets their shared triangles more than once.
 */

#ifndef OracleWarpedCell_h
#define OracleWarpedCell_h

#include "OracleFace.h"
#include "OracleRay.h"
#include "OracleSegment.h"

#include <vector>

class OracleWarpedCell
{
public:
  explicit OracleWarpedCell(const std::vector<OracleFace>& faces);

  /** False where the ray misses the cell. */
  bool Clip(const OracleRay& ray, OracleSegment& segment) const;

private:
  /** A vector in the ray's basis: right, up, along. */
  struct Projected
  {
    double Right;
    double Up;
    double Along;

    Projected(const OracleRay& ray, const OracleVector& vector);
    double Cross(const Projected& other) const;
  };

  static bool Intersect(const OracleRay& ray, const Projected& nudge,
    const OracleFace::Triangle& triangle, double& t, double& scalar);
  static int GetSide(double area, const Projected& p, const Projected& q, const Projected& nudge);

  std::vector<OracleFace> Faces;
};

#endif
