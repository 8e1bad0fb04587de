/**
 * One ray: the points Origin + t Direction with Near <= t <= Far, t in world length.
 *
 * Origin is the point of the ray's line nearest to the mesh's centre (the coordinates' zero), so
 * that a far eye costs no digits; Near and Far may have either sign, and Near >= Far is an empty
 * ray. Right and Up complete Direction to an orthonormal basis.
 */

#ifndef OracleRay_h
#define OracleRay_h

#include "OracleVector.h"

struct OracleRay
{
  OracleVector Origin;
  OracleVector Direction;
  OracleVector Right;
  OracleVector Up;
  double Near = 0.0;
  double Far = 0.0;

  /** The ray from `start` to `end`. */
  OracleRay(const OracleVector& start, const OracleVector& end);

  OracleVector GetPoint(double t) const { return this->Origin + this->Direction * t; }

  /** Ends the ray at the point `end` of its line, where that comes before Far. */
  void EndAt(const OracleVector& end);

  /** Keeps the part on the side to which `normal` points, seen from the plane through `point`. */
  void ClipByPlane(const OracleVector& point, const OracleVector& normal);

  /**
   * The side to which every ray is thought to be moved by an infinitesimal amount. It decides the
   * cells of a ray that runs exactly inside a face or an edge: one of the cells around it, not all.
   */
  static OracleVector GetNudge() { return { 0.536, 0.717, 0.446 }; }
};

#endif
