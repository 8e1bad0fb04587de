#include "ConcaveCells.h"

#include "FaceTriangulation.h"
#include "PolyhedronSurface.h"

#include <cstddef>
#include <utility>

namespace
{
using Triangle = std::array<int, 3>;

// Appends the triangles of a face, by the surface's vertices; false where it runs through itself.
bool AddFace(const PolyhedronSurface& surface, int face, const std::vector<double>& points,
  std::vector<Triangle>& triangles)
{
  const TetrahedralSplit::Solid solid = surface.GetSolid();
  const std::vector<int> vertices(solid.Begin(face), solid.End(face));
  std::vector<long long> ids;
  std::vector<double> corners;
  for (const int vertex : vertices)
  {
    ids.push_back(surface.GetIds()[vertex]);
    const double* x = &points[3 * static_cast<size_t>(vertex)];
    corners.insert(corners.end(), x, x + 3);
  }
  const std::vector<Triangle> parts = FaceTriangulation::Triangulate(ids, corners);
  for (const Triangle& part : parts)
  {
    triangles.push_back({ { vertices[part[0]], vertices[part[1]], vertices[part[2]] } });
  }
  return parts.size() + 2 == vertices.size();
}

double SignedVolume(const std::vector<Triangle>& triangles, const std::vector<double>& points)
{
  double six = 0.0;
  for (const Triangle& t : triangles)
  {
    const auto edge = [&](int corner, int axis)
    { return points[3 * static_cast<size_t>(t[corner]) + axis] - points[axis]; };
    for (int x = 0; x < 3; ++x)
    {
      const int y = (x + 1) % 3, z = (x + 2) % 3;
      six += edge(0, x) * (edge(1, y) * edge(2, z) - edge(1, z) * edge(2, y));
    }
  }
  return six / 6.0;
}
}

namespace ConcaveCells
{
//------------------------------------------------------------------------------
ConcaveCell Cut(PolyhedronSurface& surface, const std::vector<double>& points)
{
  ConcaveCell cell;
  bool isSimple = true;
  const int faces = surface.GetSolid().NumberOfFaces;
  for (int face = 0; face < faces; ++face)
  {
    isSimple = AddFace(surface, face, points, cell.Triangles) && isSimple;
  }
  if (SignedVolume(cell.Triangles, points) < 0.0)
  {
    surface.Turn();
    for (Triangle& triangle : cell.Triangles)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  if (isSimple)
  {
    cell.Mesh = TetGenMesher::Fill({ points, cell.Triangles }, TetGenSettings());
  }
  else
  {
    cell.Mesh.Failure = "a face runs through itself";
  }
  return cell;
}
}
