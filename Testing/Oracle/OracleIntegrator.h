/**
 * The optical model over one ray's segments, nearest first.
 *
 *     composite  C = int kappa tau exp(-int tau) dt,  alpha = 1 - exp(-int tau)
 *     additive   C = int kappa tau dt,                alpha = 0
 *     maximum, minimum   the extremum s of the segments' scalars: C = kappa(s) opacity(s),
 *                alpha = opacity(s), which is at most 1 here
 *
 * Composite is lit where there is a shading, and its extinction is multiplied by the gradient
 * opacity where the functions have one.
 *
 * A segment is split at the functions' breaks and each piece is halved until the two halves agree
 * with the whole to 1e-11 (relative to additive colours above 1). What a feature narrower than the
 * node spacing and not at a break does can be missed.
 */

#ifndef OracleIntegrator_h
#define OracleIntegrator_h

#include "OracleColors.h"
#include "OracleFunctions.h"
#include "OracleQuadrature.h"
#include "OracleRay.h"
#include "OracleSegment.h"
#include "OracleShading.h"

#include <array>
#include <vector>

class OracleIntegrator
{
public:
  using Rgba = std::array<double, 4>;

  /** `shading` may be null. The extremum's colour is always that of its scalar. */
  OracleIntegrator(
    const OracleFunctions& functions, const OracleShading* shading, OracleColors colors)
    : Functions(functions)
    , Shading(shading)
    , Colors(colors)
  {
  }

  Rgba Composite(const std::vector<OracleSegment>& segments, const OracleRay& ray) const;
  Rgba Add(const std::vector<OracleSegment>& segments, const OracleRay& ray) const;
  Rgba Maximum(const std::vector<OracleSegment>& segments) const;
  Rgba Minimum(const std::vector<OracleSegment>& segments) const;

private:
  /**
   * A stretch of the ray along which the scalar is linear, and its two halves; First and Last are
   * the shares of its segment that it lies between.
   */
  struct Piece
  {
    double Entry;
    double Exit;
    double Length;
    double First;
    double Last;
    const OracleSegment* Segment;
    const OracleRay* Ray;

    Piece GetPart(double from, double to) const;
    Piece GetFront() const { return this->GetPart(0.0, 0.5); }
    Piece GetBack() const { return this->GetPart(0.5, 1.0); }
  };

  /** Colour and optical depth of a stretch of the ray. */
  struct Light
  {
    std::array<double, 3> Color = { 0.0, 0.0, 0.0 };
    double Depth = 0.0;
  };

  Light Integrate(
    const std::vector<OracleSegment>& segments, const OracleRay& ray, bool absorbs) const;
  std::vector<Piece> Split(const OracleSegment& segment, const OracleRay& ray) const;
  /** Ascending shares of a way from `first` to `last` at which it passes a break; 0 and 1 too. */
  std::vector<double> FindBreaks(double first, double last) const;
  std::array<double, 3> GetColor(
    const Piece& piece, double share, const OracleFunctions::Values& values) const;
  Light Refine(
    const Piece& piece, const Light& whole, double transmittance, bool absorbs, int level) const;
  Light Estimate(const Piece& piece, bool absorbs) const;
  std::array<double, 3> Shade(
    const Piece& piece, double share, const OracleFunctions::Values& values) const;
  Rgba Project(double scalar) const;
  static Light Join(const Light& front, const Light& back, bool absorbs);
  static bool Agree(const Light& a, const Light& b, double transmittance, bool absorbs);

  const OracleFunctions& Functions;
  const OracleShading* Shading;
  OracleColors Colors;
  OracleQuadrature Quadrature;
};

#endif
