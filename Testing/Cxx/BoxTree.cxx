#include "BoxTree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace
{
// Slabs, widened so that rounding loses nothing.
bool Meets(const BoxTree::Box& box, const double origin[3], const double inverse[3])
{
  double first = -std::numeric_limits<double>::infinity(), last = -first;
  for (int i = 0; i < 3; ++i)
  {
    const double low = box.Low[i] - origin[i], high = box.High[i] - origin[i];
    const double slack = 1e-12 * (std::abs(low) + std::abs(high));
    if (std::isinf(inverse[i]))
    {
      if (low - slack > 0.0 || high + slack < 0.0)
      {
        return false;
      }
      continue;
    }
    const double a = (low - slack) * inverse[i], b = (high + slack) * inverse[i];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first <= last + 1e-12 * (std::abs(first) + std::abs(last));
}
}

//------------------------------------------------------------------------------
BoxTree::BoxTree(const std::vector<Box>& boxes)
  : Members(boxes.size())
{
  std::iota(this->Members.begin(), this->Members.end(), 0);
  this->Build(boxes, 0, static_cast<int>(boxes.size()));
}

//------------------------------------------------------------------------------
BoxTree::Box BoxTree::BoundsOf(const std::vector<Box>& boxes, int begin, int end) const
{
  Box bounds = boxes[this->Members[begin]];
  for (int at = begin; at < end; ++at)
  {
    const Box& box = boxes[this->Members[at]];
    for (int i = 0; i < 3; ++i)
    {
      bounds.Low[i] = std::min(bounds.Low[i], box.Low[i]);
      bounds.High[i] = std::max(bounds.High[i], box.High[i]);
    }
  }
  return bounds;
}

//------------------------------------------------------------------------------
void BoxTree::Build(const std::vector<Box>& boxes, int begin, int end)
{
  if (begin == end)
  {
    return;
  }
  const std::size_t self = this->Nodes.size();
  const Box bounds = this->BoundsOf(boxes, begin, end);
  this->Nodes.push_back({ bounds, begin, end, 0 });
  if (end - begin == 1)
  {
    return;
  }
  int axis = 0;
  for (int i = 1; i < 3; ++i)
  {
    axis = bounds.High[i] - bounds.Low[i] > bounds.High[axis] - bounds.Low[axis] ? i : axis;
  }
  const int middle = (begin + end) / 2;
  std::nth_element(this->Members.begin() + begin, this->Members.begin() + middle,
    this->Members.begin() + end,
    [&](int a, int b) {
      return boxes[a].Low[axis] + boxes[a].High[axis] < boxes[b].Low[axis] + boxes[b].High[axis];
    });
  this->Build(boxes, begin, middle);
  this->Nodes[self].Second = static_cast<int>(this->Nodes.size());
  this->Build(boxes, middle, end);
}

//------------------------------------------------------------------------------
void BoxTree::ForEachNear(
  const double origin[3], const double direction[3], const std::function<void(int)>& found) const
{
  const double inverse[3] = { 1.0 / direction[0], 1.0 / direction[1], 1.0 / direction[2] };
  std::vector<int> open;
  if (!this->Nodes.empty())
  {
    open.push_back(0);
  }
  while (!open.empty())
  {
    const int at = open.back();
    const Node& node = this->Nodes[at];
    open.pop_back();
    if (!Meets(node.Bounds, origin, inverse))
    {
      continue;
    }
    if (node.Second != 0)
    {
      open.push_back(at + 1);
      open.push_back(node.Second);
      continue;
    }
    std::for_each(
      this->Members.begin() + node.Begin, this->Members.begin() + node.End, std::cref(found));
  }
}
