#include "ConvexHull.h"

#include "ExactOrientation.h"
#include "vtkMath.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <unordered_map>

//------------------------------------------------------------------------------
std::vector<ConvexHull::Triangle> ConvexHull::Build(
  const double* points, const std::vector<int>& ids)
{
  ConvexHull hull(points);
  std::vector<Triangle> triangles;
  if (hull.Start(ids))
  {
    hull.Grow();
  }
  for (const Facet& facet : hull.Facets)
  {
    if (facet.Alive)
    {
      triangles.push_back(facet.Corners);
    }
  }
  return triangles;
}

//------------------------------------------------------------------------------
bool ConvexHull::Sees(int point, const Triangle& t) const
{
  return ExactOrientation::SideOfPoint(
           this->At(t[0]), this->At(t[1]), this->At(t[2]), this->At(point)) > 0;
}

//------------------------------------------------------------------------------
double ConvexHull::Height(int point, const Triangle& t) const
{
  double normal[3], toPoint[3];
  vtkTriangle::ComputeNormal(this->At(t[0]), this->At(t[1]), this->At(t[2]), normal);
  vtkMath::Subtract(this->At(point), this->At(t[0]), toPoint);
  return vtkMath::Dot(normal, toPoint);
}

namespace
{
// The id at which `measure` is largest.
template <typename Measure>
int FindLargest(const std::vector<int>& ids, const Measure& measure)
{
  return *std::max_element(
    ids.begin(), ids.end(), [&](int a, int b) { return measure(a) < measure(b); });
}
}

//------------------------------------------------------------------------------
bool ConvexHull::Start(const std::vector<int>& ids)
{
  if (ids.size() < 4)
  {
    return false;
  }
  const int a = FindLargest(ids, [&](int p) { return -this->At(p)[0]; });
  const int b = FindLargest(
    ids, [&](int p) { return vtkMath::Distance2BetweenPoints(this->At(a), this->At(p)); });
  const int c = FindLargest(
    ids, [&](int p) { return vtkTriangle::TriangleArea(this->At(a), this->At(b), this->At(p)); });
  // The farthest may be flat by rounding alone: then any that is exactly off the plane will do.
  int d = FindLargest(ids, [&](int p) { return std::abs(this->Height(p, { { a, b, c } })); });
  const auto isOff = [&](int p) {
    return this->Sees(p, { { a, b, c } }) || this->Sees(p, { { a, c, b } });
  };
  if (!isOff(d))
  {
    const auto off = std::find_if(ids.begin(), ids.end(), isOff);
    if (off == ids.end())
    {
      return false;
    }
    d = *off;
  }
  // The base faces away from d.
  const int low = this->Sees(d, { { a, b, c } }) ? c : b;
  const int high = low == c ? b : c;
  for (const Triangle& t : { Triangle{ { a, low, high } }, Triangle{ { a, d, low } },
         Triangle{ { low, d, high } }, Triangle{ { high, d, a } } })
  {
    this->Facets.emplace_back();
    this->Facets.back().Corners = t;
  }
  const std::vector<int> all{ 0, 1, 2, 3 };
  this->Link(all);
  for (const int point : ids)
  {
    this->Keep(point, all);
  }
  return true;
}

//------------------------------------------------------------------------------
void ConvexHull::Grow()
{
  std::vector<int> visible;
  std::vector<HorizonEdge> edges;
  for (int facet = 0; facet < static_cast<int>(this->Facets.size()); ++facet)
  {
    if (!this->Facets[facet].Alive || this->Facets[facet].Outside.empty())
    {
      continue;
    }
    const int apex = this->TakeFarthest(this->Facets[facet]);
    this->FindVisible(facet, apex, visible, edges);
    this->ReplaceVisible(apex, visible, edges);
  }
}

//------------------------------------------------------------------------------
int ConvexHull::TakeFarthest(Facet& facet)
{
  const int apex =
    FindLargest(facet.Outside, [&](int p) { return this->Height(p, facet.Corners); });
  facet.Outside.erase(std::find(facet.Outside.begin(), facet.Outside.end(), apex));
  return apex;
}

//------------------------------------------------------------------------------
void ConvexHull::FindVisible(
  int facet, int apex, std::vector<int>& visible, std::vector<HorizonEdge>& edges)
{
  visible.assign(1, facet);
  edges.clear();
  this->Facets[facet].VisitedFor = apex;
  for (size_t next = 0; next < visible.size(); ++next)
  {
    const int from = visible[next];
    for (int edge = 0; edge < 3; ++edge)
    {
      const int to = this->Facets[from].Neighbors[edge];
      if (to < 0)
      {
        continue; // products have underflowed: the hull stays open
      }
      Facet& neighbor = this->Facets[to];
      if (neighbor.VisitedFor == apex)
      {
        continue;
      }
      if (this->Sees(apex, neighbor.Corners))
      {
        neighbor.VisitedFor = apex;
        visible.push_back(to);
        continue;
      }
      const int corner = this->Facets[from].Corners[(edge + 1) % 3];
      const auto& corners = neighbor.Corners;
      edges.push_back({ to,
        static_cast<int>(std::find(corners.begin(), corners.end(), corner) - corners.begin()) });
    }
  }
}

//------------------------------------------------------------------------------
void ConvexHull::ReplaceVisible(
  int apex, const std::vector<int>& visible, const std::vector<HorizonEdge>& edges)
{
  std::vector<int> fan;
  for (const HorizonEdge& edge : edges)
  {
    const Triangle corners = this->Facets[edge.Facet].Corners;
    const int index = static_cast<int>(this->Facets.size());
    this->Facets.emplace_back();
    // The neighbour's edge runs the other way round.
    this->Facets.back().Corners = { { corners[(edge.Edge + 1) % 3], corners[edge.Edge], apex } };
    this->Facets.back().Neighbors[0] = edge.Facet;
    this->Facets[edge.Facet].Neighbors[edge.Edge] = index;
    fan.push_back(index);
  }
  this->Link(fan);
  for (const int old : visible)
  {
    this->Facets[old].Alive = false;
    const std::vector<int> points = std::move(this->Facets[old].Outside);
    this->Facets[old].Outside.clear();
    for (const int point : points)
    {
      this->Keep(point, fan);
    }
  }
}

//------------------------------------------------------------------------------
void ConvexHull::Link(const std::vector<int>& fan)
{
  std::unordered_map<long long, std::array<int, 2>> open;
  const auto key = [](int from, int to) { return (static_cast<long long>(from) << 32) | to; };
  for (const int facet : fan)
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      const Triangle& t = this->Facets[facet].Corners;
      if (this->Facets[facet].Neighbors[edge] >= 0)
      {
        continue;
      }
      const auto found = open.find(key(t[(edge + 1) % 3], t[edge]));
      if (found == open.end())
      {
        open[key(t[edge], t[(edge + 1) % 3])] = { { facet, edge } };
        continue;
      }
      this->Facets[facet].Neighbors[edge] = found->second[0];
      this->Facets[found->second[0]].Neighbors[found->second[1]] = facet;
    }
  }
}

//------------------------------------------------------------------------------
void ConvexHull::Keep(int point, const std::vector<int>& facets)
{
  const auto seen = std::find_if(facets.begin(), facets.end(),
    [&](int facet) { return this->Sees(point, this->Facets[facet].Corners); });
  if (seen != facets.end())
  {
    this->Facets[*seen].Outside.push_back(point);
  }
}
