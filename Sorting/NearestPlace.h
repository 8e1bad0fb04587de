/**
 * The place of a triangle, or of the surface of a tetrahedron, that is nearest to a point.
 */
#ifndef NearestPlace_h
#define NearestPlace_h

namespace NearestPlace
{
/** The square of the distance; `weights`: of the corners, at the nearest place. */
double FindOnTriangle(
  const double x[3], const double a[3], const double b[3], const double c[3], double weights[3]);

/** The same for the surface of a tetrahedron. */
double FindOnTetrahedron(const double x[3], const double* const corners[4], double weights[4]);

inline double SquareDistance(
  const double x[3], const double a[3], const double b[3], const double c[3])
{
  double weights[3];
  return FindOnTriangle(x, a, b, c, weights);
}
}

#endif
