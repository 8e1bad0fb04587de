#include "TileExactRows.h"

#include "TileView.h"

#include <cmath>

namespace
{
// Of the terms of a difference: many times what their rounding is.
constexpr double Rounding = 1e-13;
// In pixels, besides.
constexpr double Margin = 1.0 / 64.0;
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
  const double margin = Margin + Rounding * terms / std::abs(a);
  const Edge edge{ (exit.B - entry.B) / a, (exit.E - entry.E) / a + (a > 0.0 ? -margin : margin) };
  if (std::isfinite(edge.Slope) && std::isfinite(edge.Offset))
  {
    Side& side = a > 0.0 ? this->Left : this->Right;
    side.Edges[side.Count++] = edge;
  }
}
