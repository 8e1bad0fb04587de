/**
 * The optical model over one ray's segments, nearest first.
 *
 *     composite  C = int kappa tau exp(-int tau) dt,  alpha = 1 - exp(-int tau)
 *     additive   C = int kappa tau dt,                alpha = 0
 *     maximum, minimum   the extremum s of the segments' scalars: C = kappa(s) opacity(s),
 *                alpha = opacity(s)
 *
 * A segment is split at the functions' breaks and each piece is halved until the two halves agree
 * with the whole to 1e-11 (relative to additive colours above 1). What a feature narrower than the
 * node spacing and not at a break does can be missed.
 */

#ifndef OracleIntegrator_h
#define OracleIntegrator_h

#include "OracleFunctions.h"
#include "OracleQuadrature.h"
#include "OracleSegment.h"

#include <array>
#include <vector>

class OracleIntegrator
{
public:
  using Rgba = std::array<double, 4>;

  explicit OracleIntegrator(const OracleFunctions& functions)
    : Functions(functions)
  {
  }

  Rgba Composite(const std::vector<OracleSegment>& segments) const;
  Rgba Add(const std::vector<OracleSegment>& segments) const;
  Rgba Maximum(const std::vector<OracleSegment>& segments) const;
  Rgba Minimum(const std::vector<OracleSegment>& segments) const;

private:
  /** A stretch of the ray along which the scalar is linear, and its two halves. */
  struct Piece
  {
    double Entry;
    double Exit;
    double Length;

    Piece GetFront() const { return { this->Entry, this->GetMiddle(), this->Length / 2.0 }; }
    Piece GetBack() const { return { this->GetMiddle(), this->Exit, this->Length / 2.0 }; }
    double GetMiddle() const { return (this->Entry + this->Exit) / 2.0; }
  };

  /** Colour and optical depth of a stretch of the ray. */
  struct Light
  {
    std::array<double, 3> Color = { 0.0, 0.0, 0.0 };
    double Depth = 0.0;
  };

  Light Integrate(const std::vector<OracleSegment>& segments, bool absorbs) const;
  std::vector<Piece> Split(const OracleSegment& segment) const;
  Light Refine(
    const Piece& piece, const Light& whole, double transmittance, bool absorbs, int level) const;
  Light Estimate(const Piece& piece, bool absorbs) const;
  Rgba Project(double scalar) const;
  static Light Join(const Light& front, const Light& back, bool absorbs);
  static bool Agree(const Light& a, const Light& b, double transmittance, bool absorbs);

  const OracleFunctions& Functions;
  OracleQuadrature Quadrature;
};

#endif
