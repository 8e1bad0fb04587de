#include "RayOrder.h"

#include "EdgeThrough.h"
#include "vtkCell.h"
#include "vtkIdList.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace
{
// Of the diagonal: what rounding may do to a depth.
constexpr double Slack = 1e-9;
}

// A line, and the shear that makes it the third axis.
struct RayOrder::Ray
{
  double Origin[3];
  int Axes[3];
  double Shear[2];
  double Sign;

  Ray(const double origin[3], const double direction[3])
  {
    int main = 0;
    for (int i = 0; i < 3; ++i)
    {
      this->Origin[i] = origin[i];
      main = std::abs(direction[i]) > std::abs(direction[main]) ? i : main;
    }
    this->Axes[0] = (main + 1) % 3;
    this->Axes[1] = (main + 2) % 3;
    this->Axes[2] = main;
    this->Shear[0] = direction[this->Axes[0]] / direction[main];
    this->Shear[1] = direction[this->Axes[1]] / direction[main];
    this->Sign = direction[main] < 0.0 ? -1.0 : 1.0;
  }

  std::array<double, 3> Transform(const std::array<double, 3>& p) const
  {
    const double depth = p[this->Axes[2]] - this->Origin[this->Axes[2]];
    return { { p[this->Axes[0]] - this->Origin[this->Axes[0]] - this->Shear[0] * depth,
      p[this->Axes[1]] - this->Origin[this->Axes[1]] - this->Shear[1] * depth,
      this->Sign * depth } };
  }
};

//------------------------------------------------------------------------------
RayOrder::RayOrder(vtkUnstructuredGrid* grid, const std::vector<bool>& skipped)
  : NumberOfCells(grid->GetNumberOfCells())
{
  std::map<Point, vtkIdType> known;
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    Point p;
    grid->GetPoint(id, p.data());
    this->Points.push_back(p);
    this->Merged.push_back(known.emplace(p, id).first->second);
  }
  this->ReadCells(grid, skipped);
  this->MakeTree();
}

//------------------------------------------------------------------------------
void RayOrder::ReadCells(vtkUnstructuredGrid* grid, const std::vector<bool>& skipped)
{
  this->Offsets.push_back(0);
  std::vector<vtkIdType> corners;
  for (vtkIdType id = 0; id < this->NumberOfCells; ++id)
  {
    vtkCell* cell = grid->GetCell(id);
    if (cell->GetCellDimension() != 3 || (!skipped.empty() && skipped[id]))
    {
      continue;
    }
    for (int face = 0; face < cell->GetNumberOfFaces(); ++face)
    {
      vtkIdList* ids = cell->GetFace(face)->GetPointIds();
      corners.assign(ids->begin(), ids->end());
      if (cell->GetFace(face)->GetCellType() == VTK_PIXEL)
      {
        std::swap(corners[2], corners[3]);
      }
      this->AddFace(corners);
    }
    this->Offsets.push_back(static_cast<int>(this->Triangles.size()));
    this->CellIds.push_back(id);
  }
}

//------------------------------------------------------------------------------
void RayOrder::AddFace(const std::vector<vtkIdType>& corners)
{
  std::vector<vtkIdType> ids;
  for (const vtkIdType corner : corners)
  {
    if (ids.empty() || this->Merged[corner] != ids.back())
    {
      ids.push_back(this->Merged[corner]);
    }
  }
  std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
  for (std::size_t i = 2; i < ids.size(); ++i)
  {
    std::array<vtkIdType, 3> triangle = { { ids[0], ids[i - 1], ids[i] } };
    std::sort(triangle.begin(), triangle.end());
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2])
    {
      this->Triangles.push_back(triangle);
    }
  }
}

//------------------------------------------------------------------------------
void RayOrder::MakeTree()
{
  BoxTree::Box all;
  for (std::size_t cell = 0; cell < this->CellIds.size(); ++cell)
  {
    BoxTree::Box box;
    for (int at = this->Offsets[cell]; at < this->Offsets[cell + 1]; ++at)
    {
      for (const vtkIdType id : this->Triangles[at])
      {
        box.Add(this->Points[id].data());
        all.Add(this->Points[id].data());
      }
    }
    this->Boxes.push_back(box);
  }
  this->Diagonal = std::hypot(
    std::hypot(all.High[0] - all.Low[0], all.High[1] - all.Low[1]), all.High[2] - all.Low[2]);
  this->Tree = std::make_unique<BoxTree>(this->Boxes);
}

//------------------------------------------------------------------------------
RayOrder::Point RayOrder::RandomPointIn(int cell, unsigned int seed) const
{
  // Between two points of its faces: a mean of all corners would stay near the middle. A little
  // inwards: a ray within the plane of a face meets cells by the whim of rounding. Of random numbers
  // those with little to set up, as every ray does.
  std::minstd_rand random(seed);
  std::exponential_distribution<double> weight;
  const int begin = this->Offsets[cell], count = this->Offsets[cell + 1] - begin;
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
  const Point& first = this->Points[this->Triangles[begin][0]];
  Point p = first;
  for (int at = 0; at < 9 * count; ++at)
  {
    const vtkIdType id = this->Triangles[begin + at / 9][at / 3 % 3];
    p[at % 3] += inwards / (3 * count) * (this->Points[id][at % 3] - first[at % 3]);
  }
  for (int half = 0; half < 2; ++half)
  {
    const auto& triangle = this->Triangles[begin + random() % count];
    for (int i = 0; i < 9; ++i)
    {
      p[i % 3] += weights[3 * half + i / 3] * (this->Points[triangle[i / 3]][i % 3] - first[i % 3]);
    }
  }
  return p;
}

//------------------------------------------------------------------------------
bool RayOrder::Hit(const Ray& ray, const std::array<vtkIdType, 3>& triangle, double& depth) const
{
  const Point a = ray.Transform(this->Points[triangle[0]]);
  const Point b = ray.Transform(this->Points[triangle[1]]);
  const Point c = ray.Transform(this->Points[triangle[2]]);
  // Always from the smaller id to the larger: two triangles of an edge agree to the last bit.
  const double ab = a[0] * b[1] - a[1] * b[0];
  const double bc = b[0] * c[1] - b[1] * c[0];
  const double ac = a[0] * c[1] - a[1] * c[0];
  const bool sideA = bc >= 0.0, sideB = !(ac >= 0.0), sideC = ab >= 0.0;
  const double total = bc - ac + ab;
  if (sideA != sideB || sideB != sideC || total == 0.0)
  {
    return false;
  }
  depth = (bc * a[2] - ac * b[2] + ab * c[2]) / total;
  return true;
}

//------------------------------------------------------------------------------
void RayOrder::AddSegments(
  const Ray& ray, int cell, bool fromEye, std::vector<Segment>& segments) const
{
  std::vector<double> hits;
  for (int at = this->Offsets[cell]; at < this->Offsets[cell + 1]; ++at)
  {
    double depth = 0.0;
    if (this->Hit(ray, this->Triangles[at], depth))
    {
      hits.push_back(depth);
    }
  }
  std::sort(hits.begin(), hits.end());
  for (std::size_t i = 1; i < hits.size(); i += 2)
  {
    const double begin = fromEye ? std::max(0.0, hits[i - 1]) : hits[i - 1];
    // What is shorter than the slack says nothing: an eye on a face touches both of its cells.
    if (hits[i] > begin + Slack * this->Diagonal)
    {
      segments.push_back({ begin, hits[i], this->CellIds[cell] });
    }
  }
}

//------------------------------------------------------------------------------
int RayOrder::CountOverlaps(const std::vector<Segment>& segments) const
{
  const double slack = Slack * this->Diagonal;
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
    return std::lower_bound(this->CellIds.begin(), this->CellIds.end(), id) - this->CellIds.begin();
  };
  const auto cellA = placeOf(a), cellB = placeOf(b);
  if (!this->Boxes[cellA].Overlaps(this->Boxes[cellB]))
  {
    return false;
  }
  for (int at = 3 * this->Offsets[cellA]; at < 3 * this->Offsets[cellA + 1]; ++at)
  {
    const auto& own = this->Triangles[at / 3];
    const Point& from = this->Points[own[at % 3]];
    const Point& to = this->Points[own[(at + 1) % 3]];
    for (int other = this->Offsets[cellB]; other < this->Offsets[cellB + 1]; ++other)
    {
      const auto& corners = this->Triangles[other];
      const EdgeThrough::Triangle triangle = { { this->Points[corners[0]].data(),
        this->Points[corners[1]].data(), this->Points[corners[2]].data() } };
      if (EdgeThrough::Runs(from.data(), to.data(), triangle, Slack * this->Diagonal))
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
void RayOrder::Compare(const std::vector<Segment>& segments, const std::vector<vtkIdType>& rank,
  const std::vector<int>& groups, Result& result) const
{
  const double slack = Slack * this->Diagonal;
  bool wrong = false, crossing = false;
  ++result.Rays;
  if (const int overlaps = this->CountOverlaps(segments))
  {
    result.OverlappingPairs += overlaps;
    ++result.OverlappingRays;
    return;
  }
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    for (std::size_t j = i + 1; j < segments.size(); ++j)
    {
      const Segment& near = segments[i];
      const Segment& far = segments[j];
      if (near.Cell == far.Cell || far.End <= near.Begin + slack)
      {
        continue;
      }
      if (!groups.empty() && groups[near.Cell] >= 0 && groups[near.Cell] == groups[far.Cell])
      {
        continue;
      }
      bool bad = rank[near.Cell] <= rank[far.Cell];
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
  result.CrossingRays += crossing && !wrong ? 1 : 0;
}

//------------------------------------------------------------------------------
RayOrder::Result RayOrder::Check(const double eye[4], const std::vector<vtkIdType>& order,
  const std::vector<int>& groups, int rays) const
{
  Result result;
  if (this->CellIds.empty())
  {
    return result;
  }
  std::vector<vtkIdType> rank(this->NumberOfCells, -1);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    rank[order[i]] = static_cast<vtkIdType>(i);
  }
  std::mt19937 random(17);
  std::vector<Segment> segments;
  for (int i = 0; i < rays; ++i)
  {
    const int target = static_cast<int>(random() % this->CellIds.size());
    const Point through = this->RandomPointIn(target, static_cast<unsigned int>(random()));
    double direction[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      direction[axis] = eye[3] == 0.0 ? -eye[axis] : through[axis] - eye[axis];
    }
    const double* origin = eye[3] == 0.0 ? through.data() : eye;
    const Ray ray(origin, direction);
    segments.clear();
    this->Tree->ForEachNear(
      origin, direction, [&](int cell) { this->AddSegments(ray, cell, eye[3] != 0.0, segments); });
    std::sort(segments.begin(), segments.end(),
      [](const Segment& a, const Segment& b) { return a.Begin + a.End < b.Begin + b.End; });
    const bool first = result.Near < 0;
    this->Compare(segments, rank, groups, result);
    if (first && result.Near >= 0)
    {
      std::copy(direction, direction + 3, result.Direction.begin());
    }
  }
  return result;
}
