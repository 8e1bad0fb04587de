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

#include "TetrahedralSplit.h"

#include <array>
#include <vector>

namespace StarCell
{
using Point = std::array<double, 3>;

/** False where the planes leave nothing between them. `sign`: -1 where the cell is inside out. */
bool FindKernel(const TetrahedralSplit::Solid& solid, const vtkIdType* ids,
  const double (*points)[3], double sign, Point& kernel);

/** visit(a, b, c, hasVolume) for each tetrahedron (kernel, a, b, c), positive. */
template <typename Visit>
void VisitPieces(const TetrahedralSplit::Solid& solid, const vtkIdType* ids,
  const double (*points)[3], double sign, const Point& kernel, Visit visit)
{
  for (int face = 0; face < solid.NumberOfFaces; ++face)
  {
    TetrahedralSplit::VisitTriangles(solid, face, ids,
      [&](int a, int b, int c)
      {
        const bool turned = sign < 0.0;
        const int second = turned ? c : b, third = turned ? b : c;
        visit(a, second, third,
          TetrahedralSplit::SixVolumes(
            kernel.data(), points[a], points[second], points[third]) > 0.0);
      });
  }
}

/** Whether the point, rounded as it may be, sees every triangle that has an area. */
bool SeesAll(const TetrahedralSplit::Solid& solid, const vtkIdType* ids, const double (*points)[3],
  double sign, const Point& kernel);

/** By vertex: the weights that make a linear field's value at the kernel of its values there. */
std::vector<double> FindWeights(const TetrahedralSplit::Solid& solid, const vtkIdType* ids,
  const double (*points)[3], const Point& kernel);
}

#endif
