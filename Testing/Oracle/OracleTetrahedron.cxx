#include "OracleTetrahedron.h"

#include <algorithm>

//------------------------------------------------------------------------------
OracleTetrahedron::OracleTetrahedron(std::array<OracleVertex, 4> vertices)
{
  std::sort(vertices.begin(), vertices.end(),
    [](const OracleVertex& a, const OracleVertex& b) { return a.Id < b.Id; });
  for (int opposite = 0; opposite < 4; ++opposite)
  {
    std::array<OracleVector, 3> face;
    for (int vertex = 0, corner = 0; vertex < 4; ++vertex)
    {
      if (vertex != opposite)
      {
        face[corner++] = vertices[vertex].Position;
      }
    }
    Plane& plane = this->Planes[opposite];
    plane.Point = face[0];
    plane.Normal = (face[1] - face[0]).Cross(face[2] - face[0]);
    plane.Height = plane.Normal.Dot(vertices[opposite].Position - face[0]);
    plane.Scalar = vertices[opposite].Scalar;
    plane.Gradient = vertices[opposite].Gradient;
    plane.Color = vertices[opposite].Color;
  }
}

//------------------------------------------------------------------------------
bool OracleTetrahedron::Clip(const OracleRay& ray, OracleSegment& segment) const
{
  double entry = ray.Near;
  double exit = ray.Far;
  for (const Plane& plane : this->Planes)
  {
    const double height = plane.Normal.Dot(ray.Origin - plane.Point);
    const double slope = plane.Normal.Dot(ray.Direction);
    const double inwards = slope * plane.Height;
    if (inwards > 0.0)
    {
      entry = std::max(entry, -height / slope);
    }
    else if (inwards < 0.0)
    {
      exit = std::min(exit, -height / slope);
    }
    else
    {
      const double side = height != 0.0 ? height : plane.Normal.Dot(OracleRay::GetNudge());
      exit = side * plane.Height > 0.0 ? exit : entry;
    }
  }
  if (!(entry < exit))
  {
    return false;
  }
  segment.Entry = entry;
  segment.Exit = exit;
  const Values first = this->Interpolate(ray, entry), last = this->Interpolate(ray, exit);
  segment.EntryScalar = first.Scalar;
  segment.EntryGradient = first.Gradient;
  segment.EntryColor = first.Color;
  segment.ExitScalar = last.Scalar;
  segment.ExitGradient = last.Gradient;
  segment.ExitColor = last.Color;
  return true;
}

//------------------------------------------------------------------------------
OracleTetrahedron::Values OracleTetrahedron::Interpolate(const OracleRay& ray, double t) const
{
  double sum = 0.0;
  double least = this->Planes[0].Scalar, greatest = least;
  Values values;
  for (const Plane& plane : this->Planes)
  {
    const double height =
      plane.Normal.Dot(ray.Origin - plane.Point) + t * plane.Normal.Dot(ray.Direction);
    // Rounding alone can leave [0, 1]; a scalar outside the vertices' range would fool MIP.
    const double weight = std::clamp(height / plane.Height, 0.0, 1.0);
    sum += weight;
    values.Scalar += weight * plane.Scalar;
    least = std::min(least, plane.Scalar);
    greatest = std::max(greatest, plane.Scalar);
    values.Gradient = values.Gradient + plane.Gradient * weight;
    values.Color = values.Color + plane.Color * weight;
  }
  // One scalar at all corners stays what it is to the last bit: it may lie on a step.
  values.Scalar = std::clamp(values.Scalar / sum, least, greatest);
  values.Gradient = values.Gradient * (1.0 / sum);
  values.Color = values.Color * (1.0 / sum);
  return values;
}
