/**
 * One tetrahedron as four planes: a ray enters through the largest front plane and leaves through
 * the smallest back plane; scalars and gradients are interpolated barycentrically at both.
 *
 * A shared face gives both of its cells the same ray parameter, bit by bit, in any vertex
 * numbering.
 */

#ifndef OracleTetrahedron_h
#define OracleTetrahedron_h

#include "OracleRay.h"
#include "OracleSegment.h"
#include "OracleVertex.h"

#include <array>

class OracleTetrahedron
{
public:
  /** Four vertices in any order and winding; not all in one plane. */
  explicit OracleTetrahedron(std::array<OracleVertex, 4> vertices);

  /** False where the ray misses the tetrahedron. */
  bool Clip(const OracleRay& ray, OracleSegment& segment) const;

private:
  /** The plane of a face; Height, Scalar and Gradient are those of the opposite vertex. */
  struct Plane
  {
    OracleVector Point;
    OracleVector Normal;
    double Height;
    double Scalar;
    OracleVector Gradient;
  };

  void Interpolate(
    const OracleRay& ray, double t, double& scalar, OracleVector& gradient) const;

  std::array<Plane, 4> Planes;
};

#endif
