/**
 * One convex polyhedron with plane faces: a ray enters through the largest front plane and leaves
 * through the smallest back plane. Scalars are linear on each triangle of a face and between entry
 * and exit.
 */

#ifndef OraclePolyhedron_h
#define OraclePolyhedron_h

#include "OracleFace.h"
#include "OracleRay.h"
#include "OracleSegment.h"

#include <vector>

class OraclePolyhedron
{
public:
  /** The faces of a closed surface; `inside` is any position within. */
  OraclePolyhedron(const std::vector<OracleFace>& faces, const OracleVector& inside);

  /** Whether the faces are plane and all vertices on one side of each, to rounding. */
  static bool IsConvex(const std::vector<OracleFace>& faces, const OracleVector& inside);

  /** False where the ray misses the polyhedron. */
  bool Clip(const OracleRay& ray, OracleSegment& segment) const;

private:
  /** The whole line's segment, without scalars; empty (Entry >= Exit) where it misses. */
  OracleSegment FindWhole(const OracleRay& ray) const;
  double Interpolate(const OracleVector& position) const;

  std::vector<OracleFace> Faces;
  std::vector<double> Sides; // the distance of the position within from each face's plane
};

#endif
