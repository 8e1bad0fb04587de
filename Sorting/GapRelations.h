/**
 * Which boundary triangles hide which across a gap, for an eye.
 *
 * Two triangles are related where a ray from the eye meets both. Each relation is a true one: an
 * order that does not follow it is wrong on some ray. Triangles of one mesh do not cross, so one
 * ray decides which is in front.
 */
#ifndef GapRelations_h
#define GapRelations_h

#include <utility>
#include <vector>

/** Ids of points, and whatever names its cell. */
struct GapTriangle
{
  int Points[3];
  int Cell;
};

namespace GapRelations
{
/** `points`: three per point. `far`: triangles with the gap on the eye's side, `near`: with the gap
 *  behind them. Pairs of cells, the one that comes first in the order first. `eye`: a point where
 *  eye[3] is 1, a direction towards the eye where it is 0. Overlaps thinner than rounding may be
 *  missing. */
std::vector<std::pair<int, int>> Find(const double* points, const std::vector<GapTriangle>& far,
  const std::vector<GapTriangle>& near, const double eye[4]);
}

#endif
