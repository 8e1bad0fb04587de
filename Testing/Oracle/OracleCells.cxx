#include "OracleCells.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void OracleCells::AddTetrahedron(const std::vector<OracleVertex>& vertices)
{
  if (IsSolid(vertices))
  {
    this->TetrahedronSpheres.Add(vertices);
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
  const OracleVector center = OracleSpheres::GetCenter(vertices);
  if (OraclePolyhedron::IsConvex(faces, center))
  {
    this->PolyhedronSpheres.Add(vertices);
    this->Polyhedra.emplace_back(faces, center);
  }
  else
  {
    this->WarpedSpheres.Add(vertices);
    this->WarpedCells.emplace_back(faces);
  }
}

//------------------------------------------------------------------------------
template <typename Cell>
void OracleCells::Clip(const OracleRay& ray, const OracleSpheres& spheres,
  const std::vector<Cell>& cells, std::vector<OracleSegment>& segments)
{
  OracleSegment segment;
  for (std::size_t index = 0; index < cells.size();)
  {
    const std::size_t missed = spheres.CountMissed(ray, index);
    if (missed == 0 && cells[index].Clip(ray, segment))
    {
      segments.push_back(segment);
    }
    index += std::max<std::size_t>(missed, 1);
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
