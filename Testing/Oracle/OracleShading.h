/**
 * Phong's model, two-sided, at one point of a volume.
 *
 *     kappa (ambient sum(light) + diffuse sum(light |n.l|)) + specular sum(light (r.v)^p)
 *
 * n is the unit gradient, l points to the light, v to the eye, r = 2 (n.l) n - l; (r.v) below zero
 * is no highlight, a gradient of zero is lit by the ambient term alone. A light's ambient term is
 * its diffuse colour as it arrives plus its own ambient colour, which is everywhere.
 */

#ifndef OracleShading_h
#define OracleShading_h

#include "OracleLight.h"

#include <array>
#include <vector>

class OracleShading
{
public:
  using Color = std::array<double, 3>;

  double Ambient = 0.1;
  double Diffuse = 0.7;
  double Specular = 0.2;
  double Power = 10.0;
  std::vector<OracleLight> Lights;

  /** The colour that `kappa` becomes; `toEye` is a unit vector. */
  Color Shade(const Color& kappa, const OracleVector& gradient, const OracleVector& point,
    const OracleVector& toEye) const;

private:
  double GetHighlight(
    const OracleVector& normal, const OracleVector& toLight, const OracleVector& toEye) const;
};

#endif
