#include "BoundaryBSP.h"

#include "ExactOrientation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

//------------------------------------------------------------------------------
const double* BoundaryBSP::PointOf(int triangle, int corner) const
{
  return this->Complex->Points.data() + 3 * this->Complex->Boundary[triangle].Points[corner];
}

//------------------------------------------------------------------------------
BoundaryBSP::Plane BoundaryBSP::PlaneOf(int triangle) const
{
  const double* a = this->PointOf(triangle, 0);
  const double* b = this->PointOf(triangle, 1);
  const double* c = this->PointOf(triangle, 2);
  Plane plane = { { { 0.0, 0.0, 0.0 } }, 0.0 };
  double length = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    plane.Normal[i] = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
    length = std::hypot(length, plane.Normal[i]);
  }
  for (int i = 0; i < 3; ++i)
  {
    plane.Normal[i] /= length > 0.0 ? length : 1.0;
    plane.Offset += plane.Normal[i] * a[i];
  }
  return plane;
}

//------------------------------------------------------------------------------
double BoundaryBSP::DistanceOf(const Plane& plane, const Point& p) const
{
  return plane.Normal[0] * p[0] + plane.Normal[1] * p[1] + plane.Normal[2] * p[2] - plane.Offset;
}

//------------------------------------------------------------------------------
int BoundaryBSP::Classify(const Plane& plane, const Fragment& fragment) const
{
  bool front = false, back = false;
  for (int at = fragment.Begin; at < fragment.End; ++at)
  {
    const double distance = this->DistanceOf(plane, this->Corners[at]);
    front = front || distance > this->Tolerance;
    back = back || distance < -this->Tolerance;
  }
  return front ? (back ? 2 : 1) : (back ? -1 : 0);
}

//------------------------------------------------------------------------------
void BoundaryBSP::TakeBoundary(std::vector<Fragment>& fragments)
{
  double low[3] = { 1e300, 1e300, 1e300 }, high[3] = { -1e300, -1e300, -1e300 }, far = 0.0;
  const int count = static_cast<int>(this->Complex->Boundary.size());
  for (int triangle = 0; triangle < count; ++triangle)
  {
    const int begin = static_cast<int>(this->Corners.size());
    for (int corner = 0; corner < 3; ++corner)
    {
      const double* p = this->PointOf(triangle, corner);
      this->Corners.push_back({ { p[0], p[1], p[2] } });
      for (int i = 0; i < 3; ++i)
      {
        low[i] = std::min(low[i], p[i]);
        high[i] = std::max(high[i], p[i]);
        far = std::max(far, std::abs(p[i]));
      }
    }
    fragments.push_back({ triangle, begin, begin + 3, true });
  }
  const double diagonal =
    std::hypot(std::hypot(high[0] - low[0], high[1] - low[1]), high[2] - low[2]);
  // Far from the origin rounding is what limits the distances.
  this->Tolerance = std::max(1e-12 * diagonal, 8.0 * std::numeric_limits<double>::epsilon() * far);
}

//------------------------------------------------------------------------------
int BoundaryBSP::ChooseTriangle(const std::vector<Fragment>& fragments, int candidates)
{
  int best = 0;
  double bestCost = std::numeric_limits<double>::max();
  for (int trial = 0; trial < candidates; ++trial)
  {
    const Fragment& candidate = fragments[this->Random() % fragments.size()];
    const Plane plane = this->PlaneOf(candidate.Triangle);
    int counts[4] = { 0, 0, 0, 0 };
    for (const Fragment& fragment : fragments)
    {
      ++counts[this->Classify(plane, fragment) + 1];
    }
    // Cuts first; where they are equal, the tree that is less deep.
    const double cost = counts[3] + 0.1 * std::abs(counts[0] - counts[2]);
    if (cost < bestCost)
    {
      bestCost = cost;
      best = candidate.Triangle;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
void BoundaryBSP::Cut(const Plane& plane, const Fragment& fragment, Fragment& front, Fragment& back)
{
  std::vector<Point> parts[2];
  const int count = fragment.End - fragment.Begin;
  for (int at = 0; at < count; ++at)
  {
    const Point p = this->Corners[fragment.Begin + at];
    const Point q = this->Corners[fragment.Begin + (at + 1) % count];
    const double here = this->DistanceOf(plane, p), there = this->DistanceOf(plane, q);
    if (here >= -this->Tolerance)
    {
      parts[0].push_back(p);
    }
    if (here <= this->Tolerance)
    {
      parts[1].push_back(p);
    }
    if ((here > this->Tolerance && there < -this->Tolerance) ||
        (here < -this->Tolerance && there > this->Tolerance))
    {
      const double t = here / (here - there);
      Point middle;
      for (int i = 0; i < 3; ++i)
      {
        middle[i] = p[i] + t * (q[i] - p[i]);
      }
      parts[0].push_back(middle);
      parts[1].push_back(middle);
    }
  }
  Fragment* results[2] = { &front, &back };
  for (int side = 0; side < 2; ++side)
  {
    const int begin = static_cast<int>(this->Corners.size());
    this->Corners.insert(this->Corners.end(), parts[side].begin(), parts[side].end());
    *results[side] = { fragment.Triangle, begin, static_cast<int>(this->Corners.size()), true };
  }
}

//------------------------------------------------------------------------------
void BoundaryBSP::Divide(const Task& task, int candidates, std::vector<Task>& open)
{
  const int self = static_cast<int>(this->Nodes.size());
  Node node;
  node.Triangle = this->ChooseTriangle(task.Fragments, candidates);
  node.Begin = static_cast<int>(this->Fragments.size());
  const Plane plane = this->PlaneOf(node.Triangle);
  Task front = { {}, self, true }, back = { {}, self, false };
  for (const Fragment& fragment : task.Fragments)
  {
    // Its own triangle whatever rounding says, so that every node takes some.
    const int place = fragment.Triangle == node.Triangle ? 0 : this->Classify(plane, fragment);
    if (place == 0)
    {
      const Plane own = this->PlaneOf(fragment.Triangle);
      this->Fragments.push_back(fragment);
      this->Fragments.back().Agrees = own.Normal[0] * plane.Normal[0] +
                                        own.Normal[1] * plane.Normal[1] +
                                        own.Normal[2] * plane.Normal[2] >=
                                      0.0;
    }
    else if (place == 2)
    {
      Fragment near = fragment, far = fragment;
      this->Cut(plane, fragment, near, far);
      front.Fragments.push_back(near);
      back.Fragments.push_back(far);
    }
    else
    {
      (place > 0 ? front : back).Fragments.push_back(fragment);
    }
  }
  node.End = static_cast<int>(this->Fragments.size());
  this->Nodes.push_back(node);
  if (task.Parent >= 0)
  {
    (task.Front ? this->Nodes[task.Parent].Front : this->Nodes[task.Parent].Back) = self;
  }
  for (Task* child : { &front, &back })
  {
    if (!child->Fragments.empty())
    {
      open.push_back(std::move(*child));
    }
  }
}

//------------------------------------------------------------------------------
void BoundaryBSP::Build(const CellComplex& complex, int candidates)
{
  this->Complex = &complex;
  this->Random.seed(1);
  this->Corners.clear();
  this->Fragments.clear();
  this->Nodes.clear();
  // A convex boundary makes a tree as deep as it has faces: no recursion.
  std::vector<Task> open(1);
  open.back().Parent = -1;
  this->TakeBoundary(open.back().Fragments);
  if (open.back().Fragments.empty())
  {
    return;
  }
  while (!open.empty())
  {
    const Task task = std::move(open.back());
    open.pop_back();
    this->Divide(task, candidates, open);
  }
}

//------------------------------------------------------------------------------
bool BoundaryBSP::IsEdgeOn(int triangle, const double eye[4]) const
{
  const double* p = this->PointOf(triangle, 0);
  const Plane plane = this->PlaneOf(triangle);
  double height = 0.0, distance = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double toEye = eye[i] - eye[3] * p[i];
    height += plane.Normal[i] * toEye;
    distance += std::abs(toEye);
  }
  return std::abs(height) <= 1e-12 * distance;
}

//------------------------------------------------------------------------------
void BoundaryBSP::Traverse(const double eye[4], std::vector<Visit>& visits) const
{
  visits.clear();
  // A node, or the complement of one whose far side is done, with the side of the eye.
  std::vector<std::pair<int, int>> open;
  if (!this->Nodes.empty())
  {
    open.emplace_back(0, 0);
  }
  while (!open.empty())
  {
    const auto top = open.back();
    open.pop_back();
    if (top.first >= 0)
    {
      const Node& node = this->Nodes[top.first];
      const int side = ExactOrientation::SideOfEye(this->PointOf(node.Triangle, 0),
        this->PointOf(node.Triangle, 1), this->PointOf(node.Triangle, 2), eye);
      open.emplace_back(~top.first, side);
      const int far = side > 0 ? node.Back : node.Front;
      if (far >= 0)
      {
        open.emplace_back(far, 0);
      }
      continue;
    }
    const Node& node = this->Nodes[~top.first];
    const int side = this->IsEdgeOn(node.Triangle, eye) ? 0 : top.second;
    for (int at = node.Begin; at < node.End; ++at)
    {
      visits.push_back({ at, this->Fragments[at].Agrees ? side : -side });
    }
    const int near = top.second > 0 ? node.Front : node.Back;
    if (near >= 0)
    {
      open.emplace_back(near, 0);
    }
  }
}
