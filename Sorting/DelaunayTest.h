/**
 * Across how many faces a mesh is not strictly Delaunay.
 *
 * A contact of two cells is regular where a corner of one lies outside the other's circumsphere,
 * by more than rounding can account for: the determinant in double precision is compared with a
 * bound on its own error (as Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997). A tie
 * counts as irregular, and so does every face of a cell that has no circumsphere. Depends on no
 * view.
 *
 * Not guaranteed: coordinates whose fifth powers leave the range of doubles (about 1e-60 to 1e60)
 * count as irregular.
 */
#ifndef DelaunayTest_h
#define DelaunayTest_h

#include "CellComplex.h"

#include <functional>

namespace DelaunayTest
{
/** Fills in the corners of a cell, three coordinates each; called by several threads. */
using CornersOf = std::function<void(int cell, std::vector<double>& corners)>;
/** Whether the corners of a cell lie on one sphere. */
using IsCospherical = std::function<bool(int cell)>;

int CountIrregularContacts(
  const CellComplex& complex, const CornersOf& cornersOf, const IsCospherical& isCospherical);

/** Whether b lies strictly outside the circumsphere of p0 p1 p2 a, beyond rounding. False for a
 *  flat tetrahedron. */
bool IsStrictlyOutside(
  const double p0[3], const double p1[3], const double p2[3], const double a[3], const double b[3]);
}

#endif
