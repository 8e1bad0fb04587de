/**
 * A cell that is not convex, cut into tetrahedra from a point within, where one sees the whole
 * surface: one tetrahedron for each triangle of its faces.
 *
 * The point is the centre of the largest ball between the planes of the triangles: a linear
 * program, solved by an interior-point method (Boyd and Vandenberghe, Convex Optimization, 2004,
 * 11.4), exact enough for a point that is checked afterwards.
 */
#ifndef StarCell_h
#define StarCell_h

#include "FaceTriangles.h"

#include <array>
#include <vector>

namespace StarCell
{
using Point = std::array<double, 3>;

using Triangles = std::vector<FaceTriangles::Triangle>;

/** False where the planes leave nothing between them. `points`: as many as `count`; `sign`: -1 where
 *  the cell is inside out. */
bool FindKernel(const Triangles& triangles, const double (*points)[3], int count, double sign,
  Point& kernel);

/** visit(a, b, c, hasVolume) for each tetrahedron (kernel, a, b, c), positive. */
template <typename Visit>
void VisitPieces(const Triangles& triangles, const double (*points)[3], double sign,
  const Point& kernel, Visit visit)
{
  for (const FaceTriangles::Triangle& t : triangles)
  {
    const bool turned = sign < 0.0;
    const int second = t[turned ? 2 : 1], third = t[turned ? 1 : 2];
    visit(t[0], second, third,
      TetrahedralSplit::SixVolumes(kernel.data(), points[t[0]], points[second], points[third]) >
        0.0);
  }
}

/** Whether the point, rounded as it may be, sees every triangle that has an area. */
bool SeesAll(const Triangles& triangles, const double (*points)[3], int count, double sign,
  const Point& kernel);

/** By vertex: the weights that make a linear field's value at the kernel of its values there. */
std::vector<double> FindWeights(
  const Triangles& triangles, const double (*points)[3], int count, const Point& kernel);
}

#endif
