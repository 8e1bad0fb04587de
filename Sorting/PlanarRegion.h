/**
 * A region of the plane, given by its directed boundary, as convex polygons.
 *
 * The region may be concave, have holes, or fall apart; where pieces of the boundary run back on
 * themselves they bound nothing. Method: the lines of the segments cut a rectangle about them until
 * no segment is left inside a piece; a piece belongs to the region where the boundary winds around
 * it.
 */
#ifndef PlanarRegion_h
#define PlanarRegion_h

#include <array>
#include <vector>

namespace PlanarRegion
{
using Point = std::array<double, 2>;
/** Convex, counter-clockwise. */
using Polygon = std::vector<Point>;

/** The region lies to the left of it. */
struct Segment
{
  Point From;
  Point To;
};

/** Convex polygons that tile the region. What is thinner than `tolerance` may be missing. */
std::vector<Polygon> Partition(const std::vector<Segment>& boundary, double tolerance);

/** Whether two convex polygons share more than a strip of width `tolerance`. */
bool Overlap(const Polygon& a, const Polygon& b, double tolerance);

/** The corners of the convex hull; points closer to it than `tolerance` are no corners. */
Polygon ConvexHull(Polygon points, double tolerance);
}

#endif
