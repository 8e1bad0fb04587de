#include "BoxHierarchy.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace
{
constexpr int LargestLeaf = 8;

bool IsLeaf(int begin, int end)
{
  return end - begin <= LargestLeaf;
}
}

//------------------------------------------------------------------------------
BoxHierarchy::BoxHierarchy(std::vector<vtkBoundingBox> boxes)
  : Boxes(std::move(boxes))
  , Members(this->Boxes.size())
{
  std::iota(this->Members.begin(), this->Members.end(), 0);
  this->Build(0, 0, static_cast<int>(this->Members.size()));
}

//------------------------------------------------------------------------------
void BoxHierarchy::Build(int node, int begin, int end)
{
  this->Nodes.resize(std::max(this->Nodes.size(), static_cast<size_t>(node) + 1));
  vtkBoundingBox middles, bounds;
  const auto middleOf = [this](int member, int axis)
  { return this->Boxes[member].GetBound(2 * axis) + this->Boxes[member].GetBound(2 * axis + 1); };
  for (int i = begin; i < end; ++i)
  {
    const int member = this->Members[i];
    bounds.AddBox(this->Boxes[member]);
    middles.AddPoint(middleOf(member, 0), middleOf(member, 1), middleOf(member, 2));
  }
  this->Nodes[node] = bounds;
  if (IsLeaf(begin, end))
  {
    return;
  }
  int axis = 0;
  for (int i = 1; i < 3; ++i)
  {
    axis = middles.GetLength(i) > middles.GetLength(axis) ? i : axis;
  }
  const int half = (begin + end) / 2;
  std::nth_element(this->Members.begin() + begin, this->Members.begin() + half,
    this->Members.begin() + end,
    [&](int a, int b) { return middleOf(a, axis) < middleOf(b, axis); });
  this->Build(2 * node + 1, begin, half);
  this->Build(2 * node + 2, half, end);
}

//------------------------------------------------------------------------------
void BoxHierarchy::FindMet(const vtkBoundingBox& box, std::vector<int>& met) const
{
  met.clear();
  this->FindMet(0, 0, static_cast<int>(this->Members.size()), box, met);
}

//------------------------------------------------------------------------------
void BoxHierarchy::FindMet(
  int node, int begin, int end, const vtkBoundingBox& box, std::vector<int>& met) const
{
  if (!this->Nodes[node].Intersects(box))
  {
    return;
  }
  if (!IsLeaf(begin, end))
  {
    const int half = (begin + end) / 2;
    this->FindMet(2 * node + 1, begin, half, box, met);
    this->FindMet(2 * node + 2, half, end, box, met);
    return;
  }
  for (int i = begin; i < end; ++i)
  {
    if (this->Boxes[this->Members[i]].Intersects(box))
    {
      met.push_back(this->Members[i]);
    }
  }
}
