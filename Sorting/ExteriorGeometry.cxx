#include "ExteriorGeometry.h"

#include "vtkBoundingBox.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace
{
constexpr double RelativeTolerance = 1e-12;

long long EdgeKey(int from, int to)
{
  return (static_cast<long long>(from) << 32) | to;
}
}

//------------------------------------------------------------------------------
ExteriorGeometry::ExteriorGeometry(const CellComplex& mesh)
  : Mesh(mesh)
  , Points(mesh.Points)
{
  vtkBoundingBox box;
  for (const CellComplex::BoundaryTriangle& triangle : mesh.Boundary)
  {
    for (const int point : triangle.Points)
    {
      const double* x = this->At(point);
      box.AddPoint(x[0], x[1], x[2]);
    }
  }
  if (!mesh.Boundary.empty())
  {
    std::copy_n(this->At(mesh.Boundary.front().Points[0]), 3, this->Center.begin());
    this->Tolerance = RelativeTolerance * box.GetDiagonalLength();
  }
  for (size_t i = 0; i < this->Points.size(); ++i)
  {
    this->Points[i] -= this->Center[i % 3];
  }
  this->FindPlanes();
}

//------------------------------------------------------------------------------
void ExteriorGeometry::FindPlanes()
{
  const std::vector<CellComplex::BoundaryTriangle>& boundary = this->Mesh.Boundary;
  std::unordered_map<long long, int> triangleOfEdge;
  std::vector<double> areas(boundary.size());
  for (size_t t = 0; t < boundary.size(); ++t)
  {
    areas[t] = vtkMath::Norm(this->GetNormal(boundary[t].Points).data());
    for (int i = 0; i < 3; ++i)
    {
      triangleOfEdge[EdgeKey(boundary[t].Points[i], boundary[t].Points[(i + 1) % 3])] =
        static_cast<int>(t);
    }
  }
  this->PlaneOfTriangle.assign(boundary.size(), -1);
  // The largest first: their normals are the surest.
  std::vector<int> seeds(boundary.size());
  std::iota(seeds.begin(), seeds.end(), 0);
  std::stable_sort(seeds.begin(), seeds.end(), [&](int a, int b) { return areas[a] > areas[b]; });
  for (const int seed : seeds)
  {
    if (this->PlaneOfTriangle[seed] < 0)
    {
      this->GrowPlane(seed, triangleOfEdge);
    }
  }
}

//------------------------------------------------------------------------------
void ExteriorGeometry::GrowPlane(int seed, const std::unordered_map<long long, int>& triangleOfEdge)
{
  const auto& boundary = this->Mesh.Boundary;
  const int plane =
    this->AddPlane(this->GetNormal(boundary[seed].Points), boundary[seed].Points[0], seed);
  if (plane < 0)
  {
    return;
  }
  std::vector<int> open(1, seed);
  this->PlaneOfTriangle[seed] = plane;
  while (!open.empty())
  {
    const auto& points = boundary[open.back()].Points;
    open.pop_back();
    for (int i = 0; i < 3; ++i)
    {
      const auto found = triangleOfEdge.find(EdgeKey(points[(i + 1) % 3], points[i]));
      if (found == triangleOfEdge.end() || this->PlaneOfTriangle[found->second] >= 0)
      {
        continue;
      }
      const auto& next = boundary[found->second].Points;
      const bool isInPlane =
        std::all_of(next, next + 3, [&](int point) { return this->SideOf(plane, point) == 0; });
      if (isInPlane &&
          vtkMath::Dot(this->GetNormal(next).data(), this->Planes[plane].Normal.data()) > 0.0)
      {
        this->PlaneOfTriangle[found->second] = plane;
        open.push_back(found->second);
      }
    }
  }
}

//------------------------------------------------------------------------------
double ExteriorGeometry::Distance(int plane, int point) const
{
  const Plane& p = this->Planes[plane];
  const double* x = this->At(point);
  return p.Normal[0] * (x[0] - p.Origin[0]) + p.Normal[1] * (x[1] - p.Origin[1]) +
         p.Normal[2] * (x[2] - p.Origin[2]);
}

//------------------------------------------------------------------------------
int ExteriorGeometry::SideOf(int plane, int point) const
{
  const double distance = this->Distance(plane, point);
  return (distance > this->Tolerance) - (distance < -this->Tolerance);
}

//------------------------------------------------------------------------------
std::array<double, 3> ExteriorGeometry::GetNormal(const int points[3]) const
{
  double a[3], b[3];
  std::array<double, 3> normal;
  vtkMath::Subtract(this->At(points[1]), this->At(points[0]), a);
  vtkMath::Subtract(this->At(points[2]), this->At(points[0]), b);
  vtkMath::Cross(a, b, normal.data());
  return normal;
}

//------------------------------------------------------------------------------
std::vector<int> ExteriorGeometry::FindHull(int plane, const std::vector<int>& points) const
{
  std::map<PlanarRegion::Point, int> pointAt;
  PlanarRegion::Polygon projected;
  for (const int point : points)
  {
    projected.push_back(this->Project(plane, point));
    pointAt.emplace(projected.back(), point);
  }
  std::vector<int> hull;
  for (const PlanarRegion::Point& corner : PlanarRegion::ConvexHull(projected, this->Tolerance))
  {
    hull.push_back(pointAt.at(corner));
  }
  return hull;
}

//------------------------------------------------------------------------------
PlanarRegion::Point ExteriorGeometry::Project(int plane, int point) const
{
  const Plane& p = this->Planes[plane];
  double relative[3];
  vtkMath::Subtract(this->At(point), p.Origin.data(), relative);
  return { { vtkMath::Dot(relative, p.Axes[0].data()), vtkMath::Dot(relative, p.Axes[1].data()) } };
}

//------------------------------------------------------------------------------
int ExteriorGeometry::FindPoint(
  int plane, const PlanarRegion::Point& at, const std::vector<int>& near)
{
  for (const int point : near)
  {
    const PlanarRegion::Point other = this->Project(plane, point);
    if (std::hypot(other[0] - at[0], other[1] - at[1]) <= 4.0 * this->Tolerance)
    {
      return point;
    }
  }
  const Plane& p = this->Planes[plane];
  std::array<double, 3> x;
  for (int i = 0; i < 3; ++i)
  {
    x[i] = p.Origin[i] + at[0] * p.Axes[0][i] + at[1] * p.Axes[1][i];
  }
  return this->AddPoint(x);
}

//------------------------------------------------------------------------------
int ExteriorGeometry::AddPoint(const std::array<double, 3>& x)
{
  this->Points.insert(this->Points.end(), x.begin(), x.end());
  return this->GetNumberOfPoints() - 1;
}

//------------------------------------------------------------------------------
int ExteriorGeometry::AddIntersection(int from, int to, double distanceFrom, double distanceTo)
{
  const double t = distanceFrom / (distanceFrom - distanceTo);
  std::array<double, 3> x;
  for (int i = 0; i < 3; ++i)
  {
    x[i] = this->At(from)[i] + t * (this->At(to)[i] - this->At(from)[i]);
  }
  return this->AddPoint(x);
}

//------------------------------------------------------------------------------
int ExteriorGeometry::AddPlane(const std::array<double, 3>& normal, int point, int triangle)
{
  Plane plane;
  plane.Normal = normal;
  plane.Triangle = triangle;
  std::copy_n(this->At(point), 3, plane.Origin.begin());
  if (!(vtkMath::Normalize(plane.Normal.data()) > std::numeric_limits<double>::min()))
  {
    return -1;
  }
  vtkMath::Perpendiculars(plane.Normal.data(), plane.Axes[0].data(), plane.Axes[1].data(), 0.0);
  this->Planes.push_back(plane);
  return static_cast<int>(this->Planes.size()) - 1;
}

//------------------------------------------------------------------------------
std::array<double, 3> ExteriorGeometry::GetMeshCoordinates(int point) const
{
  std::array<double, 3> x;
  for (int i = 0; i < 3; ++i)
  {
    x[i] = this->At(point)[i] + this->Center[i];
  }
  return x;
}
