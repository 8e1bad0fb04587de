#include "TileSpanOracle.h"

#include "TileExactCell.h"
#include "TileGroup.h"
#include "TileView.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
TileSpanOracle::TileSpanOracle(const TileGroup& group, int k)
  : ScalarA(group.ScalarA[k])
  , ScalarB(group.ScalarB[k])
  , ScalarP(group.ScalarP[k])
  , ScalarU(group.ScalarU[k])
{
  for (int f = 0; f < (group.Cut[k] != 0 ? 6 : 4); ++f)
  {
    const bool enters = f < 4 ? (group.Entries[k] >> f & 1) != 0 : f == TileGroup::CutEntry;
    (enters ? this->Entries : this->Exits).push_back({ group.A[f][k], group.B[f][k], group.P[f][k], f >= 4 ? Cut : Face });
  }
}

//------------------------------------------------------------------------------
TileSpanOracle::TileSpanOracle(const TileExactCell& cell, const TileView& view)
  : ScalarA(cell.ScalarA)
  , ScalarB(cell.ScalarB)
  , ScalarP(cell.ScalarE)
  , ScalarU(cell.ScalarC)
  , Width(view.Width)
  , Height(view.Height)
{
  this->Entries.push_back({ 0.0, 0.0, view.NearU, End });
  this->Exits.push_back({ 0.0, 0.0, view.FarU, End });
  for (const TileExactCell::Plane& plane : cell.Planes)
  {
    (plane.IsEntry ? this->Entries : this->Exits)
      .push_back({ -plane.A / plane.C, -plane.B / plane.C, -plane.E / plane.C, plane.Tolerance > 0.0 ? EdgeOn : Face });
  }
}

//------------------------------------------------------------------------------
double TileSpanOracle::Plane::TermsAt(double x, double y) const
{
  const double terms = std::abs(this->A * x) + std::abs(this->B * y) + std::abs(this->P);
  // A cut that there is not lies before or behind everything, a plane that is seen edge-on does either.
  return terms < 1e29 && this->Is != End ? terms : 0.0;
}

//------------------------------------------------------------------------------
TileSpanOracle::Ray TileSpanOracle::Cross(double x, double y) const
{
  Ray ray;
  for (const Plane& in : this->Entries)
  {
    ray.Entry = std::min(ray.Entry, in.At(x, y));
    ray.Terms = std::max(ray.Terms, in.TermsAt(x, y));
    for (const Plane& out : this->Exits)
    {
      ray.Exit = std::max(ray.Exit, out.At(x, y));
      ray.Terms = std::max(ray.Terms, out.TermsAt(x, y));
      const double apart = in.At(x, y) - out.At(x, y), slope = std::hypot(in.A - out.A, in.B - out.B);
      const bool areCuts = in.Is >= Cut && out.Is >= Cut;
      ray.Inside = areCuts ? ray.Inside : std::min(ray.Inside, apart / std::max(slope, 1e-300));
    }
  }
  // Beginning or ending at the near or the far plane.
  ray.Terms = std::max({ ray.Terms, std::abs(ray.Entry), std::abs(ray.Exit) });
  return ray;
}

//------------------------------------------------------------------------------
TileSpanOracle::Scalar TileSpanOracle::ScalarAt(double x, double y, double u) const
{
  const double terms[4] = { this->ScalarA * x, this->ScalarB * y, this->ScalarP, this->ScalarU * u };
  Scalar scalar{ 0.0, 0.0 };
  for (const double term : terms)
  {
    scalar.Value += term;
    scalar.Terms += std::abs(term);
  }
  return scalar;
}

//------------------------------------------------------------------------------
double TileSpanOracle::RoundingOf(const Plane& in, const Plane& out) const
{
  auto terms = [this](const Plane& plane)
  { return std::abs(plane.A) * this->Width + std::abs(plane.B) * this->Height + std::abs(plane.P); };
  return 2e-13 * (terms(in) + terms(out));
}

//------------------------------------------------------------------------------
bool TileSpanOracle::IsLevel(const Plane& in, const Plane& out) const
{
  return 1e3 * this->RoundingOf(in, out) >= std::abs(in.A - out.A);
}

//------------------------------------------------------------------------------
bool TileSpanOracle::BoundsRows() const
{
  auto bounds = [this](const Plane& in)
  {
    return in.Is != EdgeOn && std::all_of(this->Exits.begin(), this->Exits.end(),
      [&](const Plane& out)
      { return out.Is != EdgeOn && ((in.Is == End && out.Is == End) || !this->IsLevel(in, out)); });
  };
  return std::all_of(this->Entries.begin(), this->Entries.end(), bounds);
}

//------------------------------------------------------------------------------
double TileSpanOracle::FindOutside(double x, double y) const
{
  double outside = 0.0;
  for (const Plane& in : this->Entries)
  {
    for (const Plane& out : this->Exits)
    {
      const bool bounds = in.Is != EdgeOn && out.Is != EdgeOn && !this->IsLevel(in, out);
      const double beyond = -(in.At(x, y) - out.At(x, y) + this->RoundingOf(in, out)) / std::abs(in.A - out.A);
      outside = bounds ? std::max(outside, beyond) : outside;
    }
  }
  return outside;
}
