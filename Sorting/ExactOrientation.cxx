#include "ExactOrientation.h"

#include "Expansion.h"

namespace
{
// Shewchuk's bound for this order of operations, with room for the subtractions of the direction's
// case: (7 + 56 u) u with u = 2^-53.
constexpr double ErrorBound = 7.8e-16;

// What the filter says: the sign, or 2 where the error of the doubles may change it.
constexpr int Undecided = 2;

int FilteredSign(const double u[3], const double v[3], const double w[3])
{
  const double vw[3] = { v[1] * w[2], v[2] * w[0], v[0] * w[1] };
  const double wv[3] = { v[2] * w[1], v[0] * w[2], v[1] * w[0] };
  double determinant = 0.0;
  double magnitude = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    determinant += u[i] * (vw[i] - wv[i]);
    magnitude += std::fabs(u[i]) * (std::fabs(vw[i]) + std::fabs(wv[i]));
  }
  const double bound = ErrorBound * magnitude;
  if (determinant > bound || determinant < -bound)
  {
    return determinant > 0.0 ? 1 : -1;
  }
  return Undecided;
}

using Difference = Expansion<2>;

// The sign of u x v . w.
int ExactSign(const Difference u[3], const Difference v[3], const Difference w[3])
{
  Expansion<192> sum;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const auto vw = Expansion<8>::Product(v[j], w[k]);
    const auto wv = Expansion<8>::Product(v[k], w[j]);
    sum.Add(Expansion<32>::Product(u[i], vw));
    sum.Add(Expansion<32>::Product(u[i], wv), -1.0);
  }
  return sum.GetSign();
}
}

namespace ExactOrientation
{
//------------------------------------------------------------------------------
int SideOfPoint(const double a[3], const double b[3], const double c[3], const double p[3])
{
  const double u[3] = { a[0] - p[0], a[1] - p[1], a[2] - p[2] };
  const double v[3] = { c[0] - p[0], c[1] - p[1], c[2] - p[2] };
  const double w[3] = { b[0] - p[0], b[1] - p[1], b[2] - p[2] };
  const int sign = FilteredSign(u, v, w);
  if (sign != Undecided)
  {
    return sign;
  }
  Difference exactU[3], exactV[3], exactW[3];
  for (int i = 0; i < 3; ++i)
  {
    exactU[i] = Difference::Difference(a[i], p[i]);
    exactV[i] = Difference::Difference(c[i], p[i]);
    exactW[i] = Difference::Difference(b[i], p[i]);
  }
  return ExactSign(exactU, exactV, exactW);
}

//------------------------------------------------------------------------------
int SideOfDirection(
  const double a[3], const double b[3], const double c[3], const double direction[3])
{
  const double u[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const double v[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  const int sign = FilteredSign(u, v, direction);
  if (sign != Undecided)
  {
    return sign;
  }
  Difference exactU[3], exactV[3], exactW[3];
  for (int i = 0; i < 3; ++i)
  {
    exactU[i] = Difference::Difference(b[i], a[i]);
    exactV[i] = Difference::Difference(c[i], a[i]);
    exactW[i].Add(direction[i]);
  }
  return ExactSign(exactU, exactV, exactW);
}

//------------------------------------------------------------------------------
int Turn(const double a[2], const double b[2], const double c[2])
{
  const double left = (b[0] - a[0]) * (c[1] - a[1]);
  const double right = (b[1] - a[1]) * (c[0] - a[0]);
  const double determinant = left - right;
  const double bound = ErrorBound * (std::fabs(left) + std::fabs(right));
  if (determinant > bound || determinant < -bound)
  {
    return determinant > 0.0 ? 1 : -1;
  }
  Expansion<16> sum;
  sum.Add(
    Expansion<8>::Product(Difference::Difference(b[0], a[0]), Difference::Difference(c[1], a[1])));
  sum.Add(
    Expansion<8>::Product(Difference::Difference(b[1], a[1]), Difference::Difference(c[0], a[0])),
    -1.0);
  return sum.GetSign();
}
}
