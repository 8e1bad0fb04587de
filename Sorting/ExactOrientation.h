/**
 * On which side of a triangle's plane an eye lies, decided exactly.
 *
 * Method: the determinant in double precision with a bound on its error; where the bound does not
 * decide, the same determinant in expansions (Shewchuk, Adaptive Precision Floating-Point
 * Arithmetic and Fast Robust Geometric Predicates, 1997; the code is our own).
 *
 * Not guaranteed for coordinates whose products leave the range of doubles (beyond about 1e100, or
 * below 1e-100).
 */
#ifndef ExactOrientation_h
#define ExactOrientation_h

namespace ExactOrientation
{
/** The sign, -1, 0 or 1, of (b - a) x (c - a) . (p - a): 1 where p lies on the side to which the
 *  normal of the triangle points. */
int SideOfPoint(const double a[3], const double b[3], const double c[3], const double p[3]);

/** The sign of (b - a) x (c - a) . direction. */
int SideOfDirection(
  const double a[3], const double b[3], const double c[3], const double direction[3]);

/** The sign of (b - a) x (c - a) in the plane: 1 where a, b, c turn to the left. */
int Turn(const double a[2], const double b[2], const double c[2]);

/** Either of them: `eye` is a point where eye[3] is 1, a direction (towards the eye) where it is
 *  0. */
inline int SideOfEye(const double a[3], const double b[3], const double c[3], const double eye[4])
{
  return eye[3] == 0.0 ? SideOfDirection(a, b, c, eye) : SideOfPoint(a, b, c, eye);
}

/** The same for three ids of `points`, an array of three values per point. */
inline int SideOfEye(const double* points, const int triangle[3], const double eye[4])
{
  return SideOfEye(
    points + 3LL * triangle[0], points + 3LL * triangle[1], points + 3LL * triangle[2], eye);
}
}

#endif
