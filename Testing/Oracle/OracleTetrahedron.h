/**
 * One tetrahedron as four planes: a ray enters through the largest front plane and leaves through
 * the smallest back plane; scalars, gradients and colours are interpolated barycentrically at both.
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
  /** The plane of a face; Height and what follows are those of the opposite vertex. */
  struct Plane
  {
    OracleVector Point;
    OracleVector Normal;
    double Height;
    double Scalar;
    OracleVector Gradient;
    OracleVector Color;
  };

  /** What is linear in the cell, at a point of the ray. */
  struct Values
  {
    double Scalar = 0.0;
    OracleVector Gradient;
    OracleVector Color;
  };
  Values Interpolate(const OracleRay& ray, double t) const;

  std::array<Plane, 4> Planes;
};

#endif
