#include "TileExactRows.h"

#include "TileView.h"

#include <algorithm>
#include <cmath>

namespace
{
// Of the terms of a difference: many times what their rounding is.
constexpr double Rounding = 1e-13;
}

//------------------------------------------------------------------------------
TileExactRows::TileExactRows(const TileExactCell& cell, const TileView& view)
{
  // The near plane is an entry, too, and the far plane an exit.
  Line entries[5] = { { 0.0, 0.0, view.NearU } }, exits[5] = { { 0.0, 0.0, view.FarU } };
  int entered = 1, left = 1;
  for (const TileExactCell::Plane& plane : cell.Planes)
  {
    // What is seen edge-on bounds nothing: a ray within its tolerance counts as moved.
    if (plane.Tolerance <= 0.0)
    {
      Line& line = plane.IsEntry ? entries[entered++] : exits[left++];
      line = { plane.A * plane.Inverse, plane.B * plane.Inverse, plane.E * plane.Inverse };
    }
  }
  for (int i = 0; i < entered; ++i)
  {
    for (int j = i == 0 ? 1 : 0; j < left; ++j)
    {
      this->AddEdge(entries[i], exits[j], view);
    }
  }
}

//------------------------------------------------------------------------------
void TileExactRows::AddEdge(const Line& entry, const Line& exit, const TileView& view)
{
  const double a = entry.A - exit.A;
  const double terms = (std::abs(entry.A) + std::abs(exit.A)) * view.Width +
    (std::abs(entry.B) + std::abs(exit.B)) * view.Height + std::abs(entry.E) + std::abs(exit.E);
  const double margin = 1.0 + Rounding * terms / std::abs(a);
  const Edge edge{ (exit.B - entry.B) / a, (exit.E - entry.E) / a + (a > 0.0 ? -margin : margin), a > 0.0 };
  if (std::isfinite(edge.Slope) && std::isfinite(edge.Offset))
  {
    this->Edges[this->Count++] = edge;
  }
}

//------------------------------------------------------------------------------
void TileExactRows::Narrow(int y, int& first, int& last) const
{
  double begin = first, end = last;
  for (int i = 0; i < this->Count; ++i)
  {
    const Edge& edge = this->Edges[i];
    const double x = edge.Slope * y + edge.Offset;
    begin = edge.IsLeft ? std::max(begin, x) : begin;
    end = edge.IsLeft ? end : std::min(end, x);
  }
  // Back to whole pixels of the row.
  first = static_cast<int>(std::ceil(std::min(begin, last + 1.0)));
  last = static_cast<int>(std::floor(std::max(end, first - 1.0)));
}
