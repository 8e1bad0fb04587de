#include "RayOrder.h"

#include "EdgeThrough.h"
#include "ShearedRay.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
// Of the diagonal: what rounding may do to a depth.
constexpr double Slack = 1e-9;
// So that their segments stay in the cache.
constexpr int RaysAtOnce = 256;
}

struct RayOrder::Rays
{
  std::vector<Point> Directions;
  std::vector<ShearedRay> Sheared;
  std::vector<BoxTree::Line> Lines;
};

// One cell after the other in the same memory.
struct RayOrder::Scratch
{
  std::vector<Point> Corners;
  std::vector<double> Hits;
};

//------------------------------------------------------------------------------
RayOrder::RayOrder(vtkUnstructuredGrid* grid, const std::vector<bool>& skipped)
  : NumberOfCells(grid->GetNumberOfCells())
  , Cells(grid, skipped)
  , Tree(Cells.Boxes)
{
}

//------------------------------------------------------------------------------
RayOrder::Point RayOrder::RandomPointIn(int cell, unsigned int seed) const
{
  // Between two points of its faces: a mean of all corners would stay near the middle. A little
  // inwards: a ray within the plane of a face meets cells by the whim of rounding. Of random numbers
  // those with little to set up, as every ray does.
  std::minstd_rand random(seed);
  std::exponential_distribution<double> weight;
  const int begin = this->Cells.Offsets[cell], count = this->Cells.Offsets[cell + 1] - begin;
  double weights[6];
  const double inwards = 0.05, share = std::uniform_real_distribution<double>()(random);
  for (int half = 0; half < 2; ++half)
  {
    double* w = weights + 3 * half;
    for (int i = 0; i < 3; ++i)
    {
      w[i] = weight(random);
    }
    const double part = (half == 0 ? share : 1.0 - share) * (1.0 - inwards);
    const double scale = part / (w[0] + w[1] + w[2]);
    std::for_each(w, w + 3, [scale](double& value) { value *= scale; });
  }
  const Point& first = this->Cells.Points[this->Cells.Triangles[begin][0]];
  Point p = first;
  for (int at = 0; at < 9 * count; ++at)
  {
    const vtkIdType id = this->Cells.Triangles[begin + at / 9][at / 3 % 3];
    p[at % 3] += inwards / (3 * count) * (this->Cells.Points[id][at % 3] - first[at % 3]);
  }
  for (int half = 0; half < 2; ++half)
  {
    const auto& triangle = this->Cells.Triangles[begin + random() % count];
    for (int i = 0; i < 9; ++i)
    {
      p[i % 3] += weights[3 * half + i / 3] * (this->Cells.Points[triangle[i / 3]][i % 3] - first[i % 3]);
    }
  }
  return p;
}

//------------------------------------------------------------------------------
void RayOrder::AddSegments(const ShearedRay& ray, int cell, bool fromEye, Scratch& scratch,
  std::vector<Segment>& segments) const
{
  scratch.Corners.clear();
  for (int at = this->Cells.CornerOffsets[cell]; at < this->Cells.CornerOffsets[cell + 1]; ++at)
  {
    scratch.Corners.push_back(ray.Transform(this->Cells.Corners[at]));
  }
  std::vector<double>& hits = scratch.Hits;
  hits.clear();
  for (int at = this->Cells.Offsets[cell]; at < this->Cells.Offsets[cell + 1]; ++at)
  {
    const auto& places = this->Cells.Places[at];
    const Point* corners = scratch.Corners.data();
    double depth = 0.0;
    if (ShearedRay::Hit(corners[places[0]], corners[places[1]], corners[places[2]], depth))
    {
      hits.push_back(depth);
    }
  }
  std::sort(hits.begin(), hits.end());
  for (std::size_t i = 1; i < hits.size(); i += 2)
  {
    const double begin = fromEye ? std::max(0.0, hits[i - 1]) : hits[i - 1];
    // What is shorter than the slack says nothing: an eye on a face touches both of its cells.
    if (hits[i] > begin + Slack * this->Cells.Diagonal)
    {
      segments.push_back({ begin, hits[i], this->Cells.CellIds[cell] });
    }
  }
}

//------------------------------------------------------------------------------
int RayOrder::CountOverlaps(const std::vector<Segment>& segments) const
{
  const double slack = Slack * this->Cells.Diagonal;
  // Where each ends before the next one begins they are all apart.
  if (std::adjacent_find(segments.begin(), segments.end(),
        [slack](const Segment& near, const Segment& far)
        { return near.End > far.Begin + slack; }) == segments.end())
  {
    return 0;
  }
  int overlaps = 0;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    for (std::size_t j = i + 1; j < segments.size(); ++j)
    {
      const Segment& near = segments[i];
      const Segment& far = segments[j];
      const bool apart = near.End <= far.Begin + slack || far.End <= near.Begin + slack;
      overlaps += apart || near.Cell == far.Cell ? 0 : 1;
    }
  }
  return overlaps;
}

//------------------------------------------------------------------------------
bool RayOrder::HasEdgeThrough(vtkIdType a, vtkIdType b) const
{
  const auto placeOf = [this](vtkIdType id)
  {
    return std::lower_bound(this->Cells.CellIds.begin(), this->Cells.CellIds.end(), id) - this->Cells.CellIds.begin();
  };
  const auto cellA = placeOf(a), cellB = placeOf(b);
  if (!this->Cells.Boxes[cellA].Overlaps(this->Cells.Boxes[cellB]))
  {
    return false;
  }
  for (int at = 3 * this->Cells.Offsets[cellA]; at < 3 * this->Cells.Offsets[cellA + 1]; ++at)
  {
    const auto& own = this->Cells.Triangles[at / 3];
    const Point& from = this->Cells.Points[own[at % 3]];
    const Point& to = this->Cells.Points[own[(at + 1) % 3]];
    for (int other = this->Cells.Offsets[cellB]; other < this->Cells.Offsets[cellB + 1]; ++other)
    {
      const auto& corners = this->Cells.Triangles[other];
      const EdgeThrough::Triangle triangle = { { this->Cells.Points[corners[0]].data(),
        this->Cells.Points[corners[1]].data(), this->Cells.Points[corners[2]].data() } };
      if (EdgeThrough::Runs(from.data(), to.data(), triangle, Slack * this->Cells.Diagonal))
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool RayOrder::DoCross(vtkIdType a, vtkIdType b) const
{
  return this->HasEdgeThrough(a, b) || this->HasEdgeThrough(b, a);
}

//------------------------------------------------------------------------------
bool RayOrder::IsFarFirst(const std::vector<Segment>& segments, const std::vector<vtkIdType>& rank)
{
  return std::adjacent_find(segments.begin(), segments.end(),
           [&](const Segment& near, const Segment& far)
           { return rank[near.Cell] <= rank[far.Cell]; }) == segments.end();
}

//------------------------------------------------------------------------------
void RayOrder::Compare(const std::vector<Segment>& segments, const std::vector<vtkIdType>& rank,
  const std::vector<int>& groups, Result& result) const
{
  const double slack = Slack * this->Cells.Diagonal;
  bool wrong = false, crossing = false, letOff = false;
  ++result.Rays;
  if (const int overlaps = this->CountOverlaps(segments))
  {
    result.OverlappingPairs += overlaps;
    ++result.OverlappingRays;
    return;
  }
  // What is right for neighbours is right for all.
  const std::size_t reach = IsFarFirst(segments, rank) ? 1 : segments.size();
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    for (std::size_t j = i + 1; j < std::min(segments.size(), i + 1 + reach); ++j)
    {
      const Segment& near = segments[i];
      const Segment& far = segments[j];
      if (near.Cell == far.Cell || far.End <= near.Begin + slack)
      {
        continue;
      }
      bool bad = rank[near.Cell] <= rank[far.Cell];
      if (!groups.empty() && groups[near.Cell] >= 0 && groups[near.Cell] == groups[far.Cell])
      {
        letOff = letOff || (bad && !this->DoCross(near.Cell, far.Cell));
        continue;
      }
      if (bad && rank[near.Cell] >= 0 && this->DoCross(near.Cell, far.Cell))
      {
        crossing = true;
        bad = false;
      }
      result.Pairs += j == i + 1 ? 1 : 0;
      result.WrongPairs += j == i + 1 && bad ? 1 : 0;
      wrong = wrong || bad;
      if (bad && result.Near < 0)
      {
        result.Near = near.Cell;
        result.Far = far.Cell;
      }
    }
  }
  result.WrongRays += wrong ? 1 : 0;
  result.RaysLetOff += letOff && !wrong ? 1 : 0;
  result.CrossingRays += crossing && !wrong ? 1 : 0;
}

//------------------------------------------------------------------------------
RayOrder::Rays RayOrder::RaysFrom(const double eye[4], int count, std::mt19937& random) const
{
  Rays rays;
  for (int i = 0; i < count; ++i)
  {
    const int target = static_cast<int>(random() % this->Cells.CellIds.size());
    const Point through = this->RandomPointIn(target, static_cast<unsigned int>(random()));
    Point direction;
    for (int axis = 0; axis < 3; ++axis)
    {
      direction[axis] = eye[3] == 0.0 ? -eye[axis] : through[axis] - eye[axis];
    }
    const double* origin = eye[3] == 0.0 ? through.data() : eye;
    rays.Directions.push_back(direction);
    rays.Sheared.emplace_back(origin, direction.data());
    rays.Lines.emplace_back(origin, direction.data());
  }
  return rays;
}

//------------------------------------------------------------------------------
std::vector<std::vector<RayOrder::Segment>> RayOrder::SegmentsOf(
  const Rays& rays, bool fromEye) const
{
  std::vector<std::vector<Segment>> segments(rays.Lines.size());
  Scratch scratch;
  this->Tree.ForEachNear(rays.Lines, [&](int ray, int cell)
    { this->AddSegments(rays.Sheared[ray], cell, fromEye, scratch, segments[ray]); });
  for (auto& ofRay : segments)
  {
    std::sort(ofRay.begin(), ofRay.end(),
      [](const Segment& a, const Segment& b) { return a.Begin + a.End < b.Begin + b.End; });
  }
  return segments;
}

//------------------------------------------------------------------------------
RayOrder::Result RayOrder::Check(const double eye[4], const std::vector<vtkIdType>& order,
  const std::vector<int>& groups, int rays) const
{
  Result result;
  std::vector<vtkIdType> rank(this->NumberOfCells, -1);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    rank[order[i]] = static_cast<vtkIdType>(i);
  }
  std::mt19937 random(17);
  for (int done = 0; done < rays && !this->Cells.CellIds.empty(); done += RaysAtOnce)
  {
    const Rays some = this->RaysFrom(eye, std::min(RaysAtOnce, rays - done), random);
    const auto segments = this->SegmentsOf(some, eye[3] != 0.0);
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
      const bool first = result.Near < 0;
      this->Compare(segments[i], rank, groups, result);
      if (first && result.Near >= 0)
      {
        result.Direction = some.Directions[i];
      }
    }
  }
  return result;
}
