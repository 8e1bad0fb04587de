/**
 * The part of a ray inside one cell: entry and exit as ray parameters in world length, entry <
 * exit, and scalar, gradient and colour at both, linear between them.
 */

#ifndef OracleSegment_h
#define OracleSegment_h

#include "OracleVector.h"

struct OracleSegment
{
  double Entry = 0.0;
  double Exit = 0.0;
  double EntryScalar = 0.0;
  double ExitScalar = 0.0;
  OracleVector EntryGradient;
  OracleVector ExitGradient;
  OracleVector EntryColor;
  OracleVector ExitColor;

  /** The gradient where `share` of the segment is passed. */
  OracleVector GetGradient(double share) const
  {
    return this->EntryGradient * (1.0 - share) + this->ExitGradient * share;
  }

  /** The vertices' colour there. */
  OracleVector GetColor(double share) const
  {
    return this->EntryColor * (1.0 - share) + this->ExitColor * share;
  }

  /** Sets the scalars of this part of a whole segment with the scalars `first` and `last`. */
  void Interpolate(const OracleSegment& whole, double first, double last)
  {
    const double slope = (last - first) / (whole.Exit - whole.Entry);
    // An end that is not cut keeps its scalar to the last bit.
    this->EntryScalar = first + slope * (this->Entry - whole.Entry);
    this->ExitScalar = last - slope * (whole.Exit - this->Exit);
  }
};

#endif
