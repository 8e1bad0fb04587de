#include "OracleFace.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
bool HasSmallerId(const OracleVertex& a, const OracleVertex& b)
{
  return a.Id < b.Id;
}

bool HasSameId(const OracleVertex& a, const OracleVertex& b)
{
  return a.Id == b.Id;
}
}

//------------------------------------------------------------------------------
OracleFace::OracleFace(std::vector<OracleVertex> loop)
{
  loop.erase(std::unique(loop.begin(), loop.end(), HasSameId), loop.end());
  while (loop.size() > 1 && HasSameId(loop.front(), loop.back()))
  {
    loop.pop_back();
  }
  if (loop.size() < 3)
  {
    return;
  }
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end(), HasSmallerId), loop.end());
  if (HasSmallerId(loop.back(), loop[1]))
  {
    std::reverse(loop.begin() + 1, loop.end());
  }
  this->Point = loop[0].Position;
  for (std::size_t corner = 2; corner < loop.size(); ++corner)
  {
    const OracleVector a = loop[corner - 1].Position - this->Point;
    this->Normal = this->Normal + a.Cross(loop[corner].Position - this->Point);
    Triangle triangle = { loop[0], loop[corner - 1], loop[corner] };
    std::sort(triangle.begin(), triangle.end(), HasSmallerId);
    this->Triangles.push_back(triangle);
  }
  this->Length = this->Normal.Length();
}

//------------------------------------------------------------------------------
double OracleFace::GetDistance(const OracleVector& position) const
{
  return this->Normal.Dot(position - this->Point) / this->Length;
}

//------------------------------------------------------------------------------
double OracleFace::GetWarp() const
{
  double warp = 0.0;
  for (const Triangle& triangle : this->Triangles)
  {
    for (const OracleVertex& vertex : triangle)
    {
      warp = std::max(warp, std::abs(this->GetDistance(vertex.Position)));
    }
  }
  return warp;
}

//------------------------------------------------------------------------------
double OracleFace::Interpolate(const OracleVector& position, double& inside) const
{
  inside = -std::numeric_limits<double>::infinity();
  double scalar = 0.0;
  for (const Triangle& triangle : this->Triangles)
  {
    double smallest;
    const double candidate = this->Interpolate(triangle, position, smallest);
    if (smallest > inside)
    {
      inside = smallest;
      scalar = candidate;
    }
  }
  return scalar;
}

//------------------------------------------------------------------------------
double OracleFace::Interpolate(
  const Triangle& triangle, const OracleVector& position, double& inside) const
{
  const OracleVector a = triangle[0].Position - position, b = triangle[1].Position - position;
  const OracleVector c = triangle[2].Position - position;
  const std::array<double, 3> areas = { this->Normal.Dot(b.Cross(c)), this->Normal.Dot(c.Cross(a)),
    this->Normal.Dot(a.Cross(b)) };
  const double whole = this->Normal.Dot((b - a).Cross(c - a));
  double sum = 0.0, scalar = 0.0;
  double least = triangle[0].Scalar, greatest = least;
  inside = 1.0;
  for (int corner = 0; corner < 3; ++corner)
  {
    const double weight = areas[corner] / whole;
    inside = std::min(inside, weight);
    // Rounding alone can leave [0, 1]; a scalar outside the vertices' range would fool MIP.
    const double clamped = std::clamp(weight, 0.0, 1.0);
    sum += clamped;
    scalar += clamped * triangle[corner].Scalar;
    least = std::min(least, triangle[corner].Scalar);
    greatest = std::max(greatest, triangle[corner].Scalar);
  }
  // One scalar at all corners stays what it is to the last bit: it may lie on a step.
  return std::clamp(scalar / sum, least, greatest);
}
