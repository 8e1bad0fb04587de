#include "OracleSpheres.h"

#include <algorithm>

//------------------------------------------------------------------------------
OracleVector OracleSpheres::GetCenter(const std::vector<OracleVertex>& vertices)
{
  OracleVector center;
  for (const OracleVertex& vertex : vertices)
  {
    center = center + vertex.Position * (1.0 / static_cast<double>(vertices.size()));
  }
  return center;
}

//------------------------------------------------------------------------------
void OracleSpheres::Add(const std::vector<OracleVertex>& vertices)
{
  const OracleVector center = GetCenter(vertices);
  double radius = 0.0;
  for (const OracleVertex& vertex : vertices)
  {
    radius = std::max(radius, (vertex.Position - center).Length());
  }
  // A margin for the rounding of the distance: a sphere may only be too large.
  const Sphere sphere = { center, radius * 1.001 + 1e-12 * center.Length() };
  std::size_t run = this->Levels[0].size();
  this->Levels[0].push_back(sphere);
  for (std::size_t level = 1; level < this->Levels.size(); ++level)
  {
    run /= Run;
    std::vector<Sphere>& spheres = this->Levels[level];
    if (run == spheres.size())
    {
      spheres.push_back(sphere);
    }
    spheres[run] = Enclose(spheres[run], sphere);
  }
}

//------------------------------------------------------------------------------
std::size_t OracleSpheres::CountMissed(const OracleRay& ray, std::size_t index) const
{
  std::size_t missed = 0;
  std::size_t cells = 1;
  for (const std::vector<Sphere>& spheres : this->Levels)
  {
    if (index % cells != 0 || Meets(ray, spheres[index / cells]))
    {
      break;
    }
    missed = cells;
    cells *= Run;
  }
  return missed;
}

//------------------------------------------------------------------------------
OracleSpheres::Sphere OracleSpheres::Enclose(const Sphere& a, const Sphere& b)
{
  const OracleVector way = b.Center - a.Center;
  const double distance = way.Length();
  if (distance + b.Radius <= a.Radius)
  {
    return a;
  }
  if (distance + a.Radius <= b.Radius)
  {
    return b;
  }
  const double radius = (distance + a.Radius + b.Radius) / 2.0;
  const OracleVector center = a.Center + way * ((radius - a.Radius) / distance);
  return { center, radius * (1.0 + 1e-9) + 1e-12 * center.Length() };
}

//------------------------------------------------------------------------------
bool OracleSpheres::Meets(const OracleRay& ray, const Sphere& sphere)
{
  const OracleVector offset = (sphere.Center - ray.Origin).Cross(ray.Direction);
  return offset.Dot(offset) <= sphere.Radius * sphere.Radius;
}
