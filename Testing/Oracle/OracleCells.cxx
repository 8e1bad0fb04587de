#include "OracleCells.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void OracleCells::AddTetrahedron(const std::vector<OracleVertex>& vertices)
{
  if (IsSolid(vertices))
  {
    this->TetrahedronSpheres.push_back(GetSphere(vertices));
    this->Tetrahedra.emplace_back(
      std::array<OracleVertex, 4>{ vertices[0], vertices[1], vertices[2], vertices[3] });
  }
}

//------------------------------------------------------------------------------
void OracleCells::AddPolyhedron(
  const std::vector<OracleVertex>& vertices, const std::vector<std::vector<int>>& loops)
{
  if (!IsSolid(vertices))
  {
    return;
  }
  std::vector<OracleFace> faces;
  for (const std::vector<int>& loop : loops)
  {
    std::vector<OracleVertex> corners;
    for (int corner : loop)
    {
      corners.push_back(vertices[corner]);
    }
    const OracleFace face(corners);
    if (!face.IsDegenerate())
    {
      faces.push_back(face);
    }
  }
  const Sphere sphere = GetSphere(vertices);
  if (OraclePolyhedron::IsConvex(faces, sphere.Center))
  {
    this->PolyhedronSpheres.push_back(sphere);
    this->Polyhedra.emplace_back(faces, sphere.Center);
  }
  else
  {
    this->WarpedSpheres.push_back(sphere);
    this->WarpedCells.emplace_back(faces);
  }
}

//------------------------------------------------------------------------------
template <typename Cell>
void OracleCells::Clip(const OracleRay& ray, const std::vector<Sphere>& spheres,
  const std::vector<Cell>& cells, std::vector<OracleSegment>& segments)
{
  OracleSegment segment;
  for (std::size_t index = 0; index < cells.size(); ++index)
  {
    if (Meets(ray, spheres[index]) && cells[index].Clip(ray, segment))
    {
      segments.push_back(segment);
    }
  }
}

//------------------------------------------------------------------------------
void OracleCells::Clip(const OracleRay& ray, std::vector<OracleSegment>& segments) const
{
  segments.clear();
  Clip(ray, this->TetrahedronSpheres, this->Tetrahedra, segments);
  Clip(ray, this->PolyhedronSpheres, this->Polyhedra, segments);
  Clip(ray, this->WarpedSpheres, this->WarpedCells, segments);
  std::sort(segments.begin(), segments.end(),
    [](const OracleSegment& a, const OracleSegment& b)
    { return a.Entry + a.Exit < b.Entry + b.Exit; });
}

//------------------------------------------------------------------------------
bool OracleCells::IsSolid(const std::vector<OracleVertex>& vertices)
{
  OracleVector longest, normal;
  bool finite = true;
  for (const OracleVertex& vertex : vertices)
  {
    const OracleVector edge = vertex.Position - vertices[0].Position;
    longest = edge.Length() > longest.Length() ? edge : longest;
    finite = finite && vertex.Position.IsFinite() && std::isfinite(vertex.Scalar);
  }
  for (const OracleVertex& vertex : vertices)
  {
    const OracleVector cross = longest.Cross(vertex.Position - vertices[0].Position);
    normal = cross.Length() > normal.Length() ? cross : normal;
  }
  double thickness = 0.0;
  double size = longest.Length();
  for (const OracleVertex& vertex : vertices)
  {
    const double height = normal.Dot(vertex.Position - vertices[0].Position);
    thickness = std::max(thickness, std::abs(height));
    size = std::max(size, vertex.Position.Length());
  }
  // Rounding of the coordinates alone gives a flat cell a few units in the last place of thickness.
  return finite && thickness > 1e-15 * normal.Length() * size;
}

//------------------------------------------------------------------------------
OracleCells::Sphere OracleCells::GetSphere(const std::vector<OracleVertex>& vertices)
{
  OracleVector center;
  for (const OracleVertex& vertex : vertices)
  {
    center = center + vertex.Position * (1.0 / static_cast<double>(vertices.size()));
  }
  double radius = 0.0;
  for (const OracleVertex& vertex : vertices)
  {
    radius = std::max(radius, (vertex.Position - center).Length());
  }
  // A margin for the rounding of the distance: a sphere may only be too large.
  return { center, radius * 1.001 + 1e-12 * center.Length() };
}

//------------------------------------------------------------------------------
bool OracleCells::Meets(const OracleRay& ray, const Sphere& sphere)
{
  const OracleVector offset = (sphere.Center - ray.Origin).Cross(ray.Direction);
  return offset.Dot(offset) <= sphere.Radius * sphere.Radius;
}
