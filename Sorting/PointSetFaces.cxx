#include "PointSetFaces.h"

#include "ConvexHull.h"
#include "ConvexityTest.h"
#include "TetrahedralSplit.h"

#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace
{
using Triangle = ConvexHull::Triangle;
using Polygon = std::vector<int>;
using Edge = std::pair<int, int>;

/** Joins the triangles of one hull. */
class Faces
{
public:
  Faces(const std::vector<double>& points, std::vector<Triangle> triangles)
    : Points(points)
    , Triangles(std::move(triangles))
    , Groups(this->Triangles.size(), -1)
    , Size(TetrahedralSplit::SizeOf(reinterpret_cast<const double(*)[3]>(points.data()),
        static_cast<int>(points.size() / 3)))
  {
  }
  std::vector<Polygon> Join();

private:
  void Flood(int seed);
  bool LiesIn(int plane, const Triangle& triangle) const;
  Polygon FindOutline(int group) const;
  void AppendEdge(int from, int to, Polygon& outline) const;
  const double* At(int point) const { return this->Points.data() + 3 * point; }
  double AreaOf(int triangle) const
  {
    const Triangle& t = this->Triangles[triangle];
    return vtkTriangle::TriangleArea(this->At(t[0]), this->At(t[1]), this->At(t[2]));
  }

  const std::vector<double>& Points;
  const std::vector<Triangle> Triangles;
  std::vector<int> Groups; // by triangle: the one it was joined to
  std::map<Edge, int> Across; // the triangle of a directed edge
  const double Size;
};

bool Faces::LiesIn(int plane, const Triangle& triangle) const
{
  double normal[3], arm[3];
  const Triangle& t = this->Triangles[plane];
  vtkTriangle::ComputeNormal(this->At(t[0]), this->At(t[1]), this->At(t[2]), normal);
  return std::all_of(triangle.begin(), triangle.end(),
    [&](int point)
    {
      vtkMath::Subtract(this->At(point), this->At(t[0]), arm);
      return std::abs(vtkMath::Dot(arm, normal)) <= ConvexityTest::PlanarTolerance * this->Size;
    });
}

void Faces::Flood(int seed)
{
  std::vector<int> waiting{ seed };
  this->Groups[seed] = seed;
  while (!waiting.empty())
  {
    const Triangle t = this->Triangles[waiting.back()];
    waiting.pop_back();
    for (int edge = 0; edge < 3; ++edge)
    {
      const int other = this->Across.at({ t[(edge + 1) % 3], t[edge] });
      if (this->Groups[other] < 0 && this->LiesIn(seed, this->Triangles[other]))
      {
        this->Groups[other] = seed;
        waiting.push_back(other);
      }
    }
  }
}

// Points on the edge as well, the same for both of its faces.
void Faces::AppendEdge(int from, int to, Polygon& outline) const
{
  double along[3], arm[3];
  const auto ends = std::minmax(from, to);
  vtkMath::Subtract(this->At(ends.second), this->At(ends.first), along);
  const double length = vtkMath::Normalize(along);
  std::vector<std::pair<double, int>> between;
  for (int point = 0; point < static_cast<int>(this->Points.size() / 3); ++point)
  {
    vtkMath::Subtract(this->At(point), this->At(ends.first), arm);
    const double at = vtkMath::Dot(arm, along);
    for (int axis = 0; axis < 3; ++axis)
    {
      arm[axis] -= at * along[axis];
    }
    const double tolerance = ConvexityTest::InsideTolerance * this->Size;
    if (point != from && point != to && at > tolerance && at < length - tolerance &&
        vtkMath::Norm(arm) <= tolerance)
    {
      between.emplace_back(at, point);
    }
  }
  std::sort(between.begin(), between.end());
  if (from > to)
  {
    std::reverse(between.begin(), between.end());
  }
  outline.push_back(from);
  for (const auto& place : between)
  {
    outline.push_back(place.second);
  }
}

// Empty where it is not one closed line.
Polygon Faces::FindOutline(int group) const
{
  std::map<int, int> next;
  std::size_t count = 0;
  for (const auto& edge : this->Across)
  {
    const int other = this->Across.at({ edge.first.second, edge.first.first });
    if (this->Groups[edge.second] == group && this->Groups[other] != group)
    {
      next[edge.first.first] = edge.first.second;
      ++count;
    }
  }
  Polygon outline;
  if (next.size() != count || next.empty())
  {
    return outline;
  }
  int at = next.begin()->first;
  for (std::size_t i = 0; i < count; ++i, at = next[at])
  {
    this->AppendEdge(at, next[at], outline);
  }
  return at == next.begin()->first ? outline : Polygon();
}

std::vector<Polygon> Faces::Join()
{
  std::vector<int> order(this->Triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [this](int a, int b) { return this->AreaOf(a) > this->AreaOf(b); });
  for (int triangle = 0; triangle < static_cast<int>(this->Triangles.size()); ++triangle)
  {
    const Triangle& t = this->Triangles[triangle];
    for (int edge = 0; edge < 3; ++edge)
    {
      this->Across[{ t[edge], t[(edge + 1) % 3] }] = triangle;
    }
  }
  std::vector<Polygon> polygons;
  for (const int seed : order)
  {
    if (this->Groups[seed] < 0)
    {
      this->Flood(seed);
      polygons.push_back(this->FindOutline(seed));
    }
  }
  return polygons;
}
}

void PointSetFaces::List(
  const std::vector<vtkIdType>& ids, const std::vector<double>& points, vtkIdList* stream)
{
  stream->Reset();
  std::vector<int> all(ids.size());
  std::iota(all.begin(), all.end(), 0);
  Faces faces(points, ConvexHull::Build(points.data(), all));
  const std::vector<Polygon> polygons = faces.Join();
  stream->InsertNextId(static_cast<vtkIdType>(polygons.size()));
  for (const Polygon& polygon : polygons)
  {
    stream->InsertNextId(static_cast<vtkIdType>(polygon.size()));
    for (const int corner : polygon)
    {
      stream->InsertNextId(ids[corner]);
    }
  }
}
