#include "PlanarRegion.h"

#include "ExactOrientation.h"

#include <algorithm>
#include <cmath>

namespace
{
using PlanarRegion::Point;
using PlanarRegion::Polygon;
using PlanarRegion::Segment;

// Segments that are compared for each cut: the longest, for their directions are the surest.
constexpr size_t NumberOfCandidates = 6;

double Cross(const Point& o, const Point& a, const Point& b)
{
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

double Length(const Segment& s)
{
  return std::hypot(s.To[0] - s.From[0], s.To[1] - s.From[1]);
}

// The line through a segment; distances are positive on its left.
class Line
{
public:
  explicit Line(const Segment& s)
    : Origin(s.From)
  {
    const double length = Length(s);
    this->Direction = { { (s.To[0] - s.From[0]) / length, (s.To[1] - s.From[1]) / length } };
  }
  double Distance(const Point& p) const
  {
    return this->Direction[0] * (p[1] - this->Origin[1]) -
           this->Direction[1] * (p[0] - this->Origin[0]);
  }

private:
  Point Origin;
  Point Direction;
};

Point Between(const Point& a, const Point& b, double distanceA, double distanceB)
{
  const double t = distanceA / (distanceA - distanceB);
  return { { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]) } };
}

// The part of a convex polygon on the side of a line where sign * distance >= 0.
Polygon Clip(const Polygon& polygon, const Line& line, double sign, double tolerance)
{
  Polygon clipped;
  for (size_t i = 0; i < polygon.size(); ++i)
  {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    const double atA = sign * line.Distance(a);
    const double atB = sign * line.Distance(b);
    if (atA >= -tolerance)
    {
      clipped.push_back(a);
    }
    if ((atA > tolerance && atB < -tolerance) || (atA < -tolerance && atB > tolerance))
    {
      clipped.push_back(Between(a, b, atA, atB));
    }
  }
  return clipped;
}

// Puts what a line leaves of a segment to its left and to its right; what lies on it is done with.
void Distribute(const Segment& segment, const Line& line, double tolerance,
  std::vector<Segment>& left, std::vector<Segment>& right)
{
  const double from = line.Distance(segment.From);
  const double to = line.Distance(segment.To);
  if (std::fabs(from) <= tolerance && std::fabs(to) <= tolerance)
  {
    return;
  }
  if (from >= -tolerance && to >= -tolerance)
  {
    left.push_back(segment);
  }
  else if (from <= tolerance && to <= tolerance)
  {
    right.push_back(segment);
  }
  else
  {
    const Point middle = Between(segment.From, segment.To, from, to);
    (from > 0.0 ? left : right).push_back({ segment.From, middle });
    (from > 0.0 ? right : left).push_back({ middle, segment.To });
  }
}

int CountCuts(const std::vector<Segment>& segments, const Line& line, double tolerance)
{
  return static_cast<int>(std::count_if(segments.begin(), segments.end(),
    [&](const Segment& s)
    {
      const double from = line.Distance(s.From);
      const double to = line.Distance(s.To);
      return std::min(from, to) < -tolerance && std::max(from, to) > tolerance;
    }));
}

// Leaves the segment that cuts the fewest others at the front.
void ChooseCut(std::vector<Segment>& segments, double tolerance)
{
  const size_t count = std::min(NumberOfCandidates, segments.size());
  std::partial_sort(segments.begin(), segments.begin() + count, segments.end(),
    [](const Segment& a, const Segment& b) { return Length(a) > Length(b); });
  size_t best = 0;
  int fewest = -1;
  for (size_t i = 0; i < count && fewest != 0; ++i)
  {
    const int cuts = CountCuts(segments, Line(segments[i]), tolerance);
    if (fewest < 0 || cuts < fewest)
    {
      fewest = cuts;
      best = i;
    }
  }
  std::swap(segments[0], segments[best]);
}

double Area(const Polygon& polygon)
{
  double area = 0.0;
  for (size_t i = 2; i < polygon.size(); ++i)
  {
    area += Cross(polygon[0], polygon[i - 1], polygon[i]) / 2.0;
  }
  return area;
}

bool IsThin(const Polygon& polygon, double tolerance)
{
  double perimeter = 0.0;
  for (size_t i = 0; i < polygon.size(); ++i)
  {
    perimeter += Length({ polygon[i], polygon[(i + 1) % polygon.size()] });
  }
  return polygon.size() < 3 || Area(polygon) <= tolerance * perimeter;
}

// How often the boundary runs around a point. Angles add up whole whatever gaps rounding left.
int Winding(const std::vector<Segment>& boundary, const Polygon& piece)
{
  Point center{ { 0.0, 0.0 } };
  for (const Point& corner : piece)
  {
    center[0] += corner[0] / static_cast<double>(piece.size());
    center[1] += corner[1] / static_cast<double>(piece.size());
  }
  double angle = 0.0;
  for (const Segment& s : boundary)
  {
    const double dot = (s.From[0] - center[0]) * (s.To[0] - center[0]) +
                       (s.From[1] - center[1]) * (s.To[1] - center[1]);
    angle += std::atan2(Cross(center, s.From, s.To), dot);
  }
  return static_cast<int>(std::lround(angle / (2.0 * std::acos(-1.0))));
}

// The corners that stand out from the line between their neighbours.
Polygon DropFlatCorners(const Polygon& polygon, double tolerance)
{
  Polygon kept;
  for (size_t i = 0; i < polygon.size(); ++i)
  {
    const Point& before = kept.empty() ? polygon.back() : kept.back();
    // Two corners in one place must not be dropped for each other.
    const bool isLast = i + 1 == polygon.size() && !kept.empty();
    const Segment base{ before, isLast ? kept.front() : polygon[(i + 1) % polygon.size()] };
    if (-Cross(base.From, base.To, polygon[i]) > tolerance * Length(base))
    {
      kept.push_back(polygon[i]);
    }
  }
  return kept;
}

// A piece of the plane with what is left of the boundary in it.
struct Piece
{
  Polygon Outline;
  std::vector<Segment> Segments;
};

Piece Enclose(const std::vector<Segment>& boundary, double tolerance)
{
  Piece piece;
  Point low = boundary.front().From;
  Point high = low;
  for (const Segment& s : boundary)
  {
    for (int i = 0; i < 2; ++i)
    {
      low[i] = std::min({ low[i], s.From[i], s.To[i] });
      high[i] = std::max({ high[i], s.From[i], s.To[i] });
    }
    if (Length(s) > tolerance)
    {
      piece.Segments.push_back(s);
    }
  }
  piece.Outline = { low, { { high[0], low[1] } }, high, { { low[0], high[1] } } };
  return piece;
}
}

namespace PlanarRegion
{
//------------------------------------------------------------------------------
std::vector<Polygon> Partition(const std::vector<Segment>& boundary, double tolerance)
{
  std::vector<Polygon> region;
  if (boundary.empty())
  {
    return region;
  }
  std::vector<Piece> open(1, Enclose(boundary, tolerance));
  while (!open.empty())
  {
    Piece piece = std::move(open.back());
    open.pop_back();
    if (IsThin(piece.Outline, tolerance))
    {
      continue;
    }
    if (piece.Segments.empty())
    {
      if (Winding(boundary, piece.Outline) > 0)
      {
        region.push_back(std::move(piece.Outline));
      }
      continue;
    }
    ChooseCut(piece.Segments, tolerance);
    const Line line(piece.Segments.front());
    Piece left{ Clip(piece.Outline, line, 1.0, tolerance), {} };
    Piece right{ Clip(piece.Outline, line, -1.0, tolerance), {} };
    for (const Segment& segment : piece.Segments)
    {
      Distribute(segment, line, tolerance, left.Segments, right.Segments);
    }
    open.push_back(std::move(left));
    open.push_back(std::move(right));
  }
  return region;
}

//------------------------------------------------------------------------------
bool Overlap(const Polygon& a, const Polygon& b, double tolerance)
{
  const Polygon* polygons[2] = { &a, &b };
  for (int k = 0; k < 2; ++k)
  {
    const Polygon& edges = *polygons[k];
    for (size_t i = 0; i < edges.size(); ++i)
    {
      const Segment edge{ edges[i], edges[(i + 1) % edges.size()] };
      if (Length(edge) <= tolerance)
      {
        continue;
      }
      const Line line(edge);
      const Polygon& other = *polygons[1 - k];
      if (std::all_of(other.begin(), other.end(),
            [&](const Point& p) { return line.Distance(p) <= tolerance; }))
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
Polygon ConvexHull(Polygon points, double tolerance)
{
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3)
  {
    return {};
  }
  Polygon hull;
  // The lower chain, then the upper one (Andrew 1979). Exact, for one wrong turn among points in
  // line can lose the last of them.
  for (int chain = 0; chain < 2; ++chain)
  {
    const size_t start = hull.size();
    for (const Point& p : points)
    {
      while (hull.size() >= start + 2 && ExactOrientation::Turn(hull[hull.size() - 2].data(),
                                           hull.back().data(), p.data()) <= 0)
      {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return DropFlatCorners(hull, tolerance);
}
}
