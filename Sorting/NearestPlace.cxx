#include "NearestPlace.h"

#include <algorithm>

namespace
{
double Dot(const double u[3], const double v[3])
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

void Subtract(const double u[3], const double v[3], double w[3])
{
  std::transform(u, u + 3, v, w, [](double p, double q) { return p - q; });
}

// `share`: of b.
double SquareOfEdge(const double x[3], const double a[3], const double b[3], double& share)
{
  double ax[3], ab[3];
  Subtract(x, a, ax);
  Subtract(b, a, ab);
  const double length = Dot(ab, ab);
  share = length > 0.0 ? std::min(1.0, std::max(0.0, Dot(ax, ab) / length)) : 0.0;
  const double off[3] = { ax[0] - share * ab[0], ax[1] - share * ab[1], ax[2] - share * ab[2] };
  return Dot(off, off);
}

double SquareOfEdges(const double x[3], const double* const corners[3], double weights[3])
{
  double least = -1.0;
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3;
    double share;
    const double square = SquareOfEdge(x, corners[i], corners[next], share);
    if (least < 0.0 || square < least)
    {
      least = square;
      weights[i] = 1.0 - share;
      weights[next] = share;
      weights[(i + 2) % 3] = 0.0;
    }
  }
  return least;
}
}

namespace NearestPlace
{
//------------------------------------------------------------------------------
double FindOnTriangle(
  const double x[3], const double a[3], const double b[3], const double c[3], double weights[3])
{
  double ab[3], ac[3], ax[3];
  Subtract(b, a, ab);
  Subtract(c, a, ac);
  Subtract(x, a, ax);
  const double bb = Dot(ab, ab), bc = Dot(ab, ac), cc = Dot(ac, ac);
  const double area = bb * cc - bc * bc;
  const double v = cc * Dot(ax, ab) - bc * Dot(ax, ac), w = bb * Dot(ax, ac) - bc * Dot(ax, ab);
  if (area > 0.0 && v >= 0.0 && w >= 0.0 && v + w <= area)
  {
    // Above the triangle.
    weights[1] = v / area;
    weights[2] = w / area;
    weights[0] = 1.0 - weights[1] - weights[2];
    double off[3];
    for (int i = 0; i < 3; ++i)
    {
      off[i] = ax[i] - weights[1] * ab[i] - weights[2] * ac[i];
    }
    return Dot(off, off);
  }
  const double* const corners[3] = { a, b, c };
  return SquareOfEdges(x, corners, weights);
}

//------------------------------------------------------------------------------
double FindOnTetrahedron(const double x[3], const double* const corners[4], double weights[4])
{
  double least = -1.0;
  for (int apart = 0; apart < 4; ++apart)
  {
    const int a = (apart + 1) % 4, b = (apart + 2) % 4, c = (apart + 3) % 4;
    double here[3];
    const double square = FindOnTriangle(x, corners[a], corners[b], corners[c], here);
    if (least < 0.0 || square < least)
    {
      least = square;
      weights[apart] = 0.0;
      weights[a] = here[0];
      weights[b] = here[1];
      weights[c] = here[2];
    }
  }
  return least;
}
}
