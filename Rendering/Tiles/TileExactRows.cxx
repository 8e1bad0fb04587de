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
  this->Entries.Lines[0] = { 0.0, 0.0, view.NearU };
  this->Exits.Lines[0] = { 0.0, 0.0, view.FarU };
  for (const TileExactCell::Plane& plane : cell.Planes)
  {
    // What is seen edge-on bounds nothing: a ray within its tolerance counts as moved.
    if (plane.Tolerance > 0.0)
    {
      this->HasEdgeOn = true;
      continue;
    }
    Surface& surface = plane.IsEntry ? this->Entries : this->Exits;
    surface.Lines[surface.Count++] = { plane.A * plane.Inverse, plane.B * plane.Inverse, plane.E * plane.Inverse };
  }
  // Of a cell between them they bound nothing that its faces do not, where rounding leaves those their place.
  bool isBounded = cell.IsBetween && !this->HasEdgeOn;
  for (int i = 1; i < this->Entries.Count; ++i)
  {
    for (int j = 1; j < this->Exits.Count; ++j)
    {
      isBounded = this->AddEdge(this->Entries.Lines[i], this->Exits.Lines[j], view) && isBounded;
    }
  }
  for (int i = 1; !isBounded && i < this->Entries.Count; ++i)
  {
    this->AddEdge(this->Entries.Lines[i], this->Exits.Lines[0], view);
  }
  for (int j = 1; !isBounded && j < this->Exits.Count; ++j)
  {
    this->AddEdge(this->Entries.Lines[0], this->Exits.Lines[j], view);
  }
}

//------------------------------------------------------------------------------
bool TileExactRows::AddEdge(const Line& entry, const Line& exit, const TileView& view)
{
  const double a = entry.A - exit.A;
  const double inverse = 1.0 / a;
  const double terms = (std::abs(entry.A) + std::abs(exit.A)) * view.Width +
    (std::abs(entry.B) + std::abs(exit.B)) * view.Height + std::abs(entry.E) + std::abs(exit.E);
  const double margin = Margin + Rounding * terms * std::abs(inverse);
  const Edge edge{ (exit.B - entry.B) * inverse, (exit.E - entry.E) * inverse + (a > 0.0 ? -margin : margin) };
  if (std::isfinite(edge.Slope) && std::isfinite(edge.Offset))
  {
    Side& side = a > 0.0 ? this->Left : this->Right;
    side.Edges[side.Count++] = edge;
  }
  return margin < 2.0 * Margin;
}
