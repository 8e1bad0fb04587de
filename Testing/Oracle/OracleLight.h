/**
 * One light of the scene, in world units relative to the mesh's centre.
 *
 * A directional light shines along Direction everywhere; a positional one from Position, weakened
 * by 1 / (a + b d + c d d) at the distance d and, where it is a spot, by cosine^Exponent inside its
 * cone about Direction and to nothing outside. Colours include the light's intensity.
 */

#ifndef OracleLight_h
#define OracleLight_h

#include "OracleVector.h"

#include <array>

struct OracleLight
{
  bool IsPositional = false;
  bool IsSpot = false;
  OracleVector Position;
  OracleVector Direction;
  double ConeCosine = -1.0;
  double Exponent = 0.0;
  std::array<double, 3> Attenuation = { 1.0, 0.0, 0.0 };
  std::array<double, 3> Ambient = { 0.0, 0.0, 0.0 };
  std::array<double, 3> Diffuse = { 1.0, 1.0, 1.0 };
  std::array<double, 3> Specular = { 1.0, 1.0, 1.0 };

  /** The unit vector from a point to the light. */
  OracleVector GetDirectionFrom(const OracleVector& point) const;

  /** What arrives at a point, 1 for a directional light. */
  double GetShareAt(const OracleVector& point) const;
};

#endif
