#include "Enclosure.h"

#include "ConvexHull.h"
#include "ExteriorGeometry.h"
#include "PlaneDivision.h"
#include "vtkBoundingBox.h"
#include "vtkMath.h"

#include <algorithm>
#include <map>
#include <set>

namespace
{
using Triangle = ConvexHull::Triangle;

// The triangles about `seed` that lie in its plane, `seed` included; they are marked as taken.
std::vector<int> GrowFacet(const ExteriorGeometry& geometry, const std::vector<Triangle>& triangles,
  const std::map<std::pair<int, int>, int>& triangleOfEdge, int seed, int plane,
  std::vector<char>& taken)
{
  std::vector<int> facet(1, seed);
  taken[seed] = 1;
  for (size_t next = 0; next < facet.size(); ++next)
  {
    const Triangle t = triangles[facet[next]];
    for (int i = 0; i < 3; ++i)
    {
      const int other = triangleOfEdge.at({ t[(i + 1) % 3], t[i] });
      const Triangle& o = triangles[other];
      if (!taken[other] &&
          std::all_of(o.begin(), o.end(), [&](int p) { return geometry.SideOf(plane, p) == 0; }))
      {
        taken[other] = 1;
        facet.push_back(other);
      }
    }
  }
  return facet;
}
}

//------------------------------------------------------------------------------
Enclosure::Enclosure(ExteriorGeometry& geometry)
  : Geometry(geometry)
{
  this->IndexBoundary();
}

//------------------------------------------------------------------------------
void Enclosure::IndexBoundary()
{
  const auto& boundary = this->Geometry.Mesh.Boundary;
  for (int t = 0; t < static_cast<int>(boundary.size()); ++t)
  {
    for (const int point : boundary[t].Points)
    {
      std::vector<int>& triangles = this->TrianglesOfPoint[point];
      if (triangles.empty())
      {
        this->BoundaryPoints.push_back(point);
      }
      triangles.push_back(t);
    }
  }
  std::sort(this->BoundaryPoints.begin(), this->BoundaryPoints.end(),
    [&](int a, int b) { return this->Geometry.At(a)[0] < this->Geometry.At(b)[0]; });
}

//------------------------------------------------------------------------------
void Enclosure::TakeConvexHull()
{
  const std::vector<Triangle> triangles =
    ConvexHull::Build(this->Geometry.Mesh.Points.data(), this->BoundaryPoints);
  std::map<std::pair<int, int>, int> triangleOfEdge;
  std::vector<std::pair<double, int>> seeds;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      triangleOfEdge[{ triangles[t][i], triangles[t][(i + 1) % 3] }] = t;
    }
    seeds.emplace_back(-vtkMath::Norm(this->Geometry.GetNormal(triangles[t].data()).data()), t);
  }
  // The largest first: their normals are the surest.
  std::sort(seeds.begin(), seeds.end());
  std::vector<char> taken(triangles.size(), 0);
  for (const auto& seed : seeds)
  {
    const Triangle& t = triangles[seed.second];
    const int plane = taken[seed.second]
                        ? -1
                        : this->Geometry.AddPlane(this->Geometry.GetNormal(t.data()), t[0], -1);
    if (plane < 0)
    {
      continue;
    }
    std::vector<int> points;
    for (const int member :
      GrowFacet(this->Geometry, triangles, triangleOfEdge, seed.second, plane, taken))
    {
      points.insert(points.end(), triangles[member].begin(), triangles[member].end());
    }
    this->AddFacet(plane, points);
  }
}

//------------------------------------------------------------------------------
void Enclosure::TakeBox()
{
  vtkBoundingBox box;
  for (const int point : this->BoundaryPoints)
  {
    const double* x = this->Geometry.At(point);
    box.AddPoint(x[0], x[1], x[2]);
  }
  std::array<int, 8> corners{};
  for (int c = 0; c < 8; ++c)
  {
    std::array<double, 3> x;
    box.GetCorner(c, x.data());
    // A corner of the mesh that is one of the box must be the same point.
    const auto same = std::find_if(this->BoundaryPoints.begin(), this->BoundaryPoints.end(),
      [&](int point) { return std::equal(x.begin(), x.end(), this->Geometry.At(point)); });
    corners[c] = same == this->BoundaryPoints.end() ? this->Geometry.AddPoint(x) : *same;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int high = 0; high < 2; ++high)
    {
      std::vector<int> points;
      for (int c = 0; c < 8; ++c)
      {
        if (((c >> axis) & 1) == high)
        {
          points.push_back(corners[c]);
        }
      }
      std::array<double, 3> normal{ { 0.0, 0.0, 0.0 } };
      normal[axis] = high ? 1.0 : -1.0;
      this->AddFacet(this->Geometry.AddPlane(normal, points[0], -1), points);
    }
  }
}

//------------------------------------------------------------------------------
void Enclosure::AddFacet(int plane, const std::vector<int>& points)
{
  ExteriorFace facet;
  facet.Plane = plane;
  facet.Corners = this->Geometry.FindHull(plane, points);
  if (facet.Corners.size() > 2)
  {
    this->Facets.push_back(facet);
  }
}

//------------------------------------------------------------------------------
std::vector<int> Enclosure::FindCovered(const ExteriorFace& facet)
{
  vtkBoundingBox box;
  for (const int corner : facet.Corners)
  {
    const double* x = this->Geometry.At(corner);
    box.AddPoint(x[0], x[1], x[2]);
  }
  box.Inflate(4.0 * this->Geometry.Tolerance);
  const auto first = std::lower_bound(this->BoundaryPoints.begin(), this->BoundaryPoints.end(),
    box.GetBound(0), [&](int point, double x) { return this->Geometry.At(point)[0] < x; });
  std::set<int> candidates;
  for (auto p = first;
       p != this->BoundaryPoints.end() && this->Geometry.At(*p)[0] <= box.GetBound(1); ++p)
  {
    if (this->Geometry.SideOf(facet.Plane, *p) == 0)
    {
      const std::vector<int>& triangles = this->TrianglesOfPoint[*p];
      candidates.insert(triangles.begin(), triangles.end());
    }
  }
  std::vector<int> covered;
  for (const int t : candidates)
  {
    const auto& points = this->Geometry.Mesh.Boundary[t].Points;
    const int plane = this->Geometry.PlaneOfTriangle[t];
    if (plane >= 0 &&
        vtkMath::Dot(this->Geometry.Planes[plane].Normal.data(),
          this->Geometry.Planes[facet.Plane].Normal.data()) > 0.0 &&
        std::all_of(points, points + 3,
          [&](int point) { return this->Geometry.SideOf(facet.Plane, point) == 0; }))
    {
      covered.push_back(t);
    }
  }
  return covered;
}

//------------------------------------------------------------------------------
std::vector<ExteriorFace> Enclosure::Uncover(
  const ExteriorFace& facet, const std::vector<int>& covered)
{
  // Around the facet, and the other way round about the triangles that lie on it.
  PlaneDivision division;
  for (size_t i = 0; i < facet.Corners.size(); ++i)
  {
    division.AddEdge(facet.Corners[i], facet.Corners[(i + 1) % facet.Corners.size()]);
  }
  for (const int t : covered)
  {
    const auto& points = this->Geometry.Mesh.Boundary[t].Points;
    for (int i = 0; i < 3; ++i)
    {
      division.AddEdge(points[(i + 1) % 3], points[i]);
    }
  }
  return division.Run(this->Geometry, facet);
}

//------------------------------------------------------------------------------
ExteriorPart Enclosure::FindExterior()
{
  ExteriorPart exterior;
  std::vector<char> isCovered(this->Geometry.Mesh.Boundary.size(), 0);
  for (const ExteriorFace& facet : this->Facets)
  {
    const std::vector<int> covered = this->FindCovered(facet);
    for (const int t : covered)
    {
      isCovered[t] = 1;
    }
    const std::vector<ExteriorFace> rest =
      covered.empty() ? std::vector<ExteriorFace>(1, facet) : this->Uncover(facet, covered);
    exterior.Faces.insert(exterior.Faces.end(), rest.begin(), rest.end());
  }
  for (int t = 0; t < static_cast<int>(isCovered.size()); ++t)
  {
    if (!isCovered[t] && this->Geometry.PlaneOfTriangle[t] >= 0)
    {
      const auto& points = this->Geometry.Mesh.Boundary[t].Points;
      ExteriorFace face;
      face.Corners = { points[0], points[2], points[1] };
      face.Plane = this->Geometry.PlaneOfTriangle[t];
      face.Direction = -1;
      face.Triangle = t;
      exterior.Faces.push_back(face);
    }
  }
  return exterior;
}

//------------------------------------------------------------------------------
double Enclosure::GetVolume() const
{
  ExteriorPart whole;
  whole.Faces = this->Facets;
  return whole.GetVolume(this->Geometry);
}

//------------------------------------------------------------------------------
bool Enclosure::IsOutside(const ExteriorPart& part) const
{
  const std::vector<int> points = part.GetPoints();
  return std::any_of(this->Facets.begin(), this->Facets.end(),
    [&](const ExteriorFace& facet)
    {
      return std::all_of(points.begin(), points.end(),
        [&](int point) { return this->Geometry.SideOf(facet.Plane, point) >= 0; });
    });
}
