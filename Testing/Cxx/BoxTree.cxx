#include "BoxTree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace
{
// Slabs, widened by `slack` so that rounding loses nothing.
bool Meets(const BoxTree::Box& box, const BoxTree::Line& line, double slack)
{
  double first = -std::numeric_limits<double>::infinity(), last = -first;
  for (int i = 0; i < 3; ++i)
  {
    const double a = (box.Low[i] - line.Origin[i] - slack) * line.Inverse[i];
    const double b = (box.High[i] - line.Origin[i] + slack) * line.Inverse[i];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first <= last + 1e-12 * (std::abs(first) + std::abs(last));
}

// Of no component 1 / 0, which times 0 is no number: what is as good as parallel is far away.
double InverseOf(double component)
{
  return std::abs(component) < 1e-200 ? 1e200 : 1.0 / component;
}

double SlackOf(const BoxTree::Box& box, const std::vector<BoxTree::Line>& lines)
{
  double slack = 0.0;
  for (const BoxTree::Line& line : lines)
  {
    for (int i = 0; i < 3; ++i)
    {
      slack = std::max({ slack, std::abs(box.Low[i] - line.Origin[i]),
        std::abs(box.High[i] - line.Origin[i]) });
    }
  }
  return 2e-12 * slack;
}
}

struct BoxTree::Search
{
  const std::vector<Line>& Lines;
  const std::function<void(int, int)>& Found;
  double Slack;
  // The lines that met the box of each level, one level after the other.
  std::vector<int> Open;
};

//------------------------------------------------------------------------------
BoxTree::Line::Line(const double origin[3], const double direction[3])
{
  for (int i = 0; i < 3; ++i)
  {
    this->Origin[i] = origin[i];
    this->Inverse[i] = InverseOf(direction[i]);
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
void BoxTree::Visit(int at, std::size_t begin, Search& search) const
{
  const Node& node = this->Nodes[at];
  std::vector<int>& open = search.Open;
  const std::size_t end = open.size();
  std::size_t next = end;
  open.resize(end + (end - begin));
  for (std::size_t i = begin; i < end; ++i)
  {
    open[next] = open[i];
    next += Meets(node.Bounds, search.Lines[open[i]], search.Slack) ? 1 : 0;
  }
  open.resize(next);
  if (node.Second != 0 && next > end)
  {
    this->Visit(at + 1, end, search);
    this->Visit(node.Second, end, search);
  }
  else
  {
    for (std::size_t i = end; i < next; ++i)
    {
      search.Found(open[i], this->Members[node.Begin]);
    }
  }
  open.resize(end);
}

//------------------------------------------------------------------------------
void BoxTree::ForEachNear(
  const std::vector<Line>& lines, const std::function<void(int, int)>& found) const
{
  if (this->Nodes.empty())
  {
    return;
  }
  Search search = { lines, found, SlackOf(this->Nodes.front().Bounds, lines), {} };
  search.Open.resize(lines.size());
  std::iota(search.Open.begin(), search.Open.end(), 0);
  this->Visit(0, 0, search);
}
