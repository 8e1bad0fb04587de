#include "OraclePolyhedron.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
/** What the rounding of coordinates can do to a distance, relative to the coordinates. */
const double Rounding = 1e-12;
}

//------------------------------------------------------------------------------
OraclePolyhedron::OraclePolyhedron(const std::vector<OracleFace>& faces, const OracleVector& inside)
  : Faces(faces)
{
  for (const OracleFace& face : faces)
  {
    this->Sides.push_back(face.GetDistance(inside));
  }
}

//------------------------------------------------------------------------------
bool OraclePolyhedron::IsConvex(const std::vector<OracleFace>& faces, const OracleVector& inside)
{
  for (const OracleFace& face : faces)
  {
    const double side = face.GetDistance(inside) > 0.0 ? 1.0 : -1.0;
    for (const OracleFace& other : faces)
    {
      for (const OracleFace::Triangle& triangle : other.GetTriangles())
      {
        for (const OracleVertex& vertex : triangle)
        {
          const double bound = Rounding * (vertex.Position.Length() + face.GetPoint().Length());
          if (side * face.GetDistance(vertex.Position) < -bound || face.GetWarp() > bound)
          {
            return false;
          }
        }
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool OraclePolyhedron::Clip(const OracleRay& ray, OracleSegment& segment) const
{
  const OracleSegment whole = this->FindWhole(ray);
  segment.Entry = std::max(whole.Entry, ray.Near);
  segment.Exit = std::min(whole.Exit, ray.Far);
  const bool isClosed = std::isfinite(whole.Exit - whole.Entry);
  if (!isClosed || !(segment.Entry < segment.Exit))
  {
    return false;
  }
  const double first = this->Interpolate(ray.GetPoint(whole.Entry));
  const double last = this->Interpolate(ray.GetPoint(whole.Exit));
  segment.Interpolate(whole, first, last);
  return true;
}

//------------------------------------------------------------------------------
OracleSegment OraclePolyhedron::FindWhole(const OracleRay& ray) const
{
  const double infinity = std::numeric_limits<double>::infinity();
  OracleSegment whole = { -infinity, infinity, 0.0, 0.0 };
  for (std::size_t index = 0; index < this->Faces.size(); ++index)
  {
    const OracleFace& face = this->Faces[index];
    const double height = face.GetNormal().Dot(ray.Origin - face.GetPoint());
    const double slope = face.GetNormal().Dot(ray.Direction);
    const double side = this->Sides[index];
    if (slope * side > 0.0)
    {
      whole.Entry = std::max(whole.Entry, -height / slope);
    }
    else if (slope * side < 0.0)
    {
      whole.Exit = std::min(whole.Exit, -height / slope);
    }
    else
    {
      const double decisive = height != 0.0 ? height : face.GetNormal().Dot(OracleRay::GetNudge());
      whole.Exit = decisive * side > 0.0 ? whole.Exit : -infinity;
    }
  }
  return whole;
}

//------------------------------------------------------------------------------
double OraclePolyhedron::Interpolate(const OracleVector& position) const
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const OracleFace& face : this->Faces)
  {
    nearest = std::min(nearest, std::abs(face.GetDistance(position)));
  }
  // Several faces can share a plane: the one that holds the position gives the scalar.
  const double bound = nearest + Rounding * position.Length();
  double best = -std::numeric_limits<double>::infinity();
  double scalar = 0.0;
  for (const OracleFace& face : this->Faces)
  {
    if (std::abs(face.GetDistance(position)) > bound)
    {
      continue;
    }
    double inside;
    const double candidate = face.Interpolate(position, inside);
    if (inside > best)
    {
      best = inside;
      scalar = candidate;
    }
  }
  return scalar;
}
