#include "OracleQuadrature.h"

#include "vtkMath.h"

#include <cmath>

namespace
{
using Legendre = std::array<double, OracleQuadrature::Size + 1>;

/** The Legendre polynomials of degree 0 to Size at x in [-1, 1]. */
Legendre EvaluateLegendre(double x)
{
  Legendre p = { 1.0, x };
  for (int n = 1; n < OracleQuadrature::Size; ++n)
  {
    p[n + 1] = ((2 * n + 1) * x * p[n] - n * p[n - 1]) / (n + 1);
  }
  return p;
}

double EvaluateSlope(double x, const Legendre& p)
{
  const int n = OracleQuadrature::Size;
  return n * (x * p[n] - p[n - 1]) / (x * x - 1.0);
}

/** The k-th root of the polynomial of degree Size, ascending, by Newton's method. */
double FindRoot(int k)
{
  double x = -std::cos(vtkMath::Pi() * (k + 0.75) / (OracleQuadrature::Size + 0.5));
  for (int step = 0; step < 10; ++step)
  {
    const Legendre p = EvaluateLegendre(x);
    x -= p[OracleQuadrature::Size] / EvaluateSlope(x, p);
  }
  return x;
}
}

//------------------------------------------------------------------------------
OracleQuadrature::OracleQuadrature()
{
  std::array<Legendre, Size> p;
  for (int i = 0; i < Size; ++i)
  {
    const double x = FindRoot(i);
    p[i] = EvaluateLegendre(x);
    const double slope = EvaluateSlope(x, p[i]);
    this->Nodes[i] = (1.0 + x) / 2.0;
    this->Weights[i] = 1.0 / ((1.0 - x * x) * slope * slope);
  }
  // The interpolant's Legendre series, integrated term by term: P_k has (P_k+1 - P_k-1) / (2 k +
  // 1).
  for (int i = 0; i < Size; ++i)
  {
    for (int j = 0; j < Size; ++j)
    {
      double sum = p[i][1] + 1.0;
      for (int k = 1; k < Size; ++k)
      {
        sum += p[j][k] * (p[i][k + 1] - p[i][k - 1]);
      }
      this->Running[i][j] = this->Weights[j] * sum / 2.0;
    }
  }
}

//------------------------------------------------------------------------------
double OracleQuadrature::Integrate(const Values& values) const
{
  double sum = 0.0;
  for (int i = 0; i < Size; ++i)
  {
    sum += this->Weights[i] * values[i];
  }
  return sum;
}

//------------------------------------------------------------------------------
OracleQuadrature::Values OracleQuadrature::IntegrateToNodes(const Values& values) const
{
  Values integrals = {};
  for (int i = 0; i < Size; ++i)
  {
    for (int j = 0; j < Size; ++j)
    {
      integrals[i] += this->Running[i][j] * values[j];
    }
  }
  return integrals;
}
