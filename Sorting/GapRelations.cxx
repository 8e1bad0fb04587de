#include "GapRelations.h"

#include "ExactOrientation.h"
#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
using Point = std::array<double, 3>;
using Polygon = std::vector<Point>;

// Cosine beyond which a point is too far to the side to be projected.
constexpr double SmallestCosine = 1e-3;

// Share of a triangle's perimeter below which the width of what two triangles share counts as none.
constexpr double RelativeTolerance = 1e-12;

/** Tests triangles for one eye. */
class Viewer
{
public:
  Viewer(const double* points, const double eye[4])
    : Points(points)
  {
    std::copy_n(eye, 4, this->Eye.begin());
  }

  /** But for rounding: no ray is sure to meet the triangle. */
  bool IsEdgeOn(const GapTriangle& triangle) const;
  bool IsBehind(const GapTriangle& far, const GapTriangle& near) const;

  const double* At(int point) const { return this->Points + 3 * static_cast<long long>(point); }

  std::array<double, 4> Eye;

private:
  Point GetNormal(const double* from, const double* to) const;
  double GetPerimeter(const GapTriangle& triangle) const;
  Polygon ClipToCone(const GapTriangle& near, const GapTriangle& far) const;

  const double* Points;
};

//------------------------------------------------------------------------------
// Of the plane through an edge and the eye.
Point Viewer::GetNormal(const double* from, const double* to) const
{
  double edge[3], toEye[3];
  Point normal;
  vtkMath::Subtract(to, from, edge);
  for (int i = 0; i < 3; ++i)
  {
    toEye[i] = this->Eye[i] - this->Eye[3] * from[i];
  }
  vtkMath::Cross(edge, toEye, normal.data());
  return normal;
}

//------------------------------------------------------------------------------
double Viewer::GetPerimeter(const GapTriangle& triangle) const
{
  double perimeter = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    perimeter += std::sqrt(vtkMath::Distance2BetweenPoints(
      this->At(triangle.Points[i]), this->At(triangle.Points[(i + 1) % 3])));
  }
  return perimeter;
}

//------------------------------------------------------------------------------
bool Viewer::IsEdgeOn(const GapTriangle& triangle) const
{
  const double bound = RelativeTolerance * this->GetPerimeter(triangle);
  for (int edge = 0; edge < 3; ++edge)
  {
    const double* from = this->At(triangle.Points[edge]);
    const Point normal = this->GetNormal(from, this->At(triangle.Points[(edge + 1) % 3]));
    double relative[3];
    vtkMath::Subtract(this->At(triangle.Points[(edge + 2) % 3]), from, relative);
    if (std::abs(vtkMath::Dot(relative, normal.data())) <= bound * vtkMath::Norm(normal.data()))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
Polygon Viewer::ClipToCone(const GapTriangle& near, const GapTriangle& far) const
{
  Polygon polygon;
  for (const int point : near.Points)
  {
    polygon.push_back({ { this->At(point)[0], this->At(point)[1], this->At(point)[2] } });
  }
  for (int edge = 0; edge < 3 && !polygon.empty(); ++edge)
  {
    const double* from = this->At(far.Points[edge]);
    const Point normal = this->GetNormal(from, this->At(far.Points[(edge + 1) % 3]));
    const auto distance = [&](const double* x)
    {
      double relative[3];
      vtkMath::Subtract(x, from, relative);
      return vtkMath::Dot(relative, normal.data());
    };
    const double sign = distance(this->At(far.Points[(edge + 2) % 3])) < 0.0 ? -1.0 : 1.0;
    Polygon clipped;
    for (size_t i = 0; i < polygon.size(); ++i)
    {
      const Point& a = polygon[i];
      const Point& b = polygon[(i + 1) % polygon.size()];
      const double atA = sign * distance(a.data());
      const double atB = sign * distance(b.data());
      if (atA >= 0.0)
      {
        clipped.push_back(a);
      }
      if ((atA > 0.0 && atB < 0.0) || (atA < 0.0 && atB > 0.0))
      {
        const double t = atA / (atA - atB);
        clipped.push_back(
          { { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]) } });
      }
    }
    polygon = std::move(clipped);
  }
  return polygon;
}

//------------------------------------------------------------------------------
bool Viewer::IsBehind(const GapTriangle& far, const GapTriangle& near) const
{
  const Polygon polygon = this->ClipToCone(near, far);
  if (polygon.size() < 3)
  {
    return false;
  }
  double area = 0.0, perimeter = 0.0;
  Point middle{ { 0.0, 0.0, 0.0 } };
  for (size_t i = 0; i < polygon.size(); ++i)
  {
    double a[3], b[3], cross[3];
    vtkMath::Subtract(polygon[i].data(), polygon[0].data(), a);
    vtkMath::Subtract(polygon[(i + 1) % polygon.size()].data(), polygon[0].data(), b);
    vtkMath::Cross(a, b, cross);
    area += vtkMath::Norm(cross);
    perimeter += std::sqrt(
      vtkMath::Distance2BetweenPoints(polygon[i].data(), polygon[(i + 1) % polygon.size()].data()));
    for (int k = 0; k < 3; ++k)
    {
      middle[k] += polygon[i][k] / static_cast<double>(polygon.size());
    }
  }
  // Measured by the triangle: what rounding leaves about a common corner is no sliver of itself.
  if (area <= RelativeTolerance * this->GetPerimeter(near) * perimeter)
  {
    return false;
  }
  // The gap is on the eye's side of the far triangle, and what is in front of it is there too.
  const double *p = this->At(far.Points[0]), *q = this->At(far.Points[1]),
               *r = this->At(far.Points[2]);
  return ExactOrientation::SideOfPoint(p, q, r, middle.data()) ==
         ExactOrientation::SideOfEye(p, q, r, this->Eye.data());
}

/** The image of a triangle on a plane before the eye, as far as its box goes. */
struct Box
{
  double Low[2] = { -std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  double High[2] = { std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity() };

  bool Overlaps(const Box& other) const
  {
    return this->Low[0] <= other.High[0] && other.Low[0] <= this->High[0] &&
           this->Low[1] <= other.High[1] && other.Low[1] <= this->High[1];
  }
};

/** Projects triangles onto a plane that faces the eye. */
class Screen
{
public:
  Screen(const Viewer& viewer, const std::vector<GapTriangle>& triangles);
  Box Project(const GapTriangle& triangle) const;

private:
  const Viewer& View;
  double Axes[3][3];
};

//------------------------------------------------------------------------------
Screen::Screen(const Viewer& viewer, const std::vector<GapTriangle>& triangles)
  : View(viewer)
{
  double* away = this->Axes[2];
  std::fill_n(away, 3, 0.0);
  for (const GapTriangle& triangle : triangles)
  {
    const double* x = viewer.At(triangle.Points[0]);
    for (int i = 0; i < 3; ++i)
    {
      away[i] += viewer.Eye[3] == 0.0 ? -viewer.Eye[i] : x[i] - viewer.Eye[i];
    }
  }
  vtkMath::Normalize(away);
  vtkMath::Perpendiculars(away, this->Axes[0], this->Axes[1], 0.0);
}

//------------------------------------------------------------------------------
Box Screen::Project(const GapTriangle& triangle) const
{
  Box box;
  std::swap(box.Low, box.High);
  for (const int point : triangle.Points)
  {
    const double* x = this->View.At(point);
    double relative[3];
    for (int i = 0; i < 3; ++i)
    {
      relative[i] = x[i] - this->View.Eye[3] * this->View.Eye[i];
    }
    const double depth = this->View.Eye[3] == 0.0 ? 1.0 : vtkMath::Dot(relative, this->Axes[2]);
    if (!(depth > SmallestCosine * vtkMath::Norm(relative)) && this->View.Eye[3] != 0.0)
    {
      return Box();
    }
    for (int i = 0; i < 2; ++i)
    {
      const double at = vtkMath::Dot(relative, this->Axes[i]) / depth;
      box.Low[i] = std::min(box.Low[i], at);
      box.High[i] = std::max(box.High[i], at);
    }
  }
  return box;
}
}

namespace GapRelations
{
//------------------------------------------------------------------------------
std::vector<std::pair<int, int>> Find(const double* points, const std::vector<GapTriangle>& far,
  const std::vector<GapTriangle>& near, const double eye[4])
{
  const Viewer viewer(points, eye);
  const Screen screen(viewer, far);
  struct Boxed
  {
    Box Bounds;
    const GapTriangle* Triangle;
  };
  std::vector<Boxed> boxed;
  for (const GapTriangle& triangle : near)
  {
    if (!viewer.IsEdgeOn(triangle))
    {
      boxed.push_back({ screen.Project(triangle), &triangle });
    }
  }
  std::sort(boxed.begin(), boxed.end(),
    [](const Boxed& a, const Boxed& b) { return a.Bounds.Low[0] < b.Bounds.Low[0]; });
  std::vector<std::pair<int, int>> pairs;
  for (const GapTriangle& triangle : far)
  {
    const Box box = screen.Project(triangle);
    const bool isEdgeOn = viewer.IsEdgeOn(triangle);
    for (const Boxed& other : boxed)
    {
      if (isEdgeOn || other.Bounds.Low[0] > box.High[0])
      {
        break;
      }
      if (other.Triangle->Cell != triangle.Cell && box.Overlaps(other.Bounds) &&
          viewer.IsBehind(triangle, *other.Triangle))
      {
        pairs.emplace_back(triangle.Cell, other.Triangle->Cell);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}
}
