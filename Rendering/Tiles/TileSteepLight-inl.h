/**
 * The colours of thin, lit fragments that lie in one piece of the transfer function, but along which the gradient
 * turns, or passes from one side of a light along the view to the other.
 *
 * They are cut where the gradient turns too far, and light is looked at in four places of a part: two on either side
 * of where it passes, so that this is no cut.
 */
#if defined(TileSteepLight_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileSteepLight_inl_h
#undef TileSteepLight_inl_h
#else
#define TileSteepLight_inl_h
#endif

#include "TileLight-inl.h"
#include "TileLitPieces-inl.h"
#include "TileMath-inl.h"
#include "TilePartColors-inl.h"
#include "TilePieces-inl.h"
#include "TileThinCourses-inl.h"
#include "TileThinShine-inl.h"
#include "TileTransfer.h"

#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Four Gauss nodes from 0 to 1.
struct FourNodes
{
  static constexpr int Count = 4;
  static constexpr float Places[Count] = { 0.06943184f, 0.33000948f, 0.66999052f, 0.93056816f };
  static constexpr float Weights[Count] = { 0.17392742f, 0.32607258f, 0.32607258f, 0.17392742f };
};

/// Where in a part light is looked at, and the share of the way that each place stands for.
struct SteepPlaces
{
  ShadeVector Place[FourNodes::Count], Weight[FourNodes::Count];

  /// Even ones, or two before and two behind `share`, where light passes.
  HWY_INLINE void Find(ShadeMask passes, ShadeVector share)
  {
    const ShadeFloat d;
    const auto left = hn::Sub(hn::Set(d, 1.0f), share);
    for (int i = 0; i < FourNodes::Count; ++i)
    {
      const auto inner = hn::Set(d, ThinPlaces[i % 2]);
      const auto place = i < 2 ? hn::Mul(share, inner) : hn::MulAdd(left, inner, share);
      const auto weight = hn::Mul(i < 2 ? share : left, hn::Set(d, 0.5f));
      this->Place[i] = hn::IfThenElse(passes, place, hn::Set(d, FourNodes::Places[i]));
      this->Weight[i] = hn::IfThenElse(passes, weight, hn::Set(d, FourNodes::Weights[i]));
    }
  }
};

/// Sums over places: of what is absorbed there, and of the light.
struct SteepSums
{
  ShadeVector Absorbed;
  GreySum Grey;
};

/// `Light`: class ThinHeadlight.
template <class Light>
class SteepLight
{
public:
  SteepLight(const TileTask& task, const ThinCourses& courses, const Light& light)
    : Transfer(*task.Transfer)
    , Courses(courses)
    , Shining(light)
    , Turn(TurnPerThin * task.Lighting->GreatestTurn)
  {
  }

  /// Colours what waits, pass after pass, and adds to `count` what is shaded beside a piece of each.
  template <class LookUp>
  HWY_INLINE void Color(const LookUp& values, TileLitPieces& waiting, TileFragments& q, TileShadeCount& count) const
  {
    constexpr int lanes = static_cast<int>(hn::MaxLanes(ShadeFloat()));
    for (int pass = 0; waiting.Count > 0; ++pass)
    {
      count.Lanes += (waiting.Count + lanes - 1) / lanes * lanes;
      this->ColorParts(values, pass < MostBends, waiting, q);
      count.Pieces += waiting.Count;
    }
  }

private:
  // By how much further than between two places the gradient may turn, and how far at most.
  static constexpr float TurnPerThin = 1.7f;
  static constexpr float SteepestTurn = 1.0f;

  /// The next part of each piece; what is left takes the place of what was there.
  template <class LookUp>
  HWY_NOINLINE void ColorParts(const LookUp& values, bool cuts, TileLitPieces& waiting, TileFragments& q) const
  {
    constexpr int lanes = static_cast<int>(hn::MaxLanes(ShadeFloat()));
    const int count = waiting.Count;
    waiting.Count = 0;
    for (int at = 0; at < count; at += lanes)
    {
      LitPieces p;
      LitPart part;
      LoadPieces(waiting, at, count, { false, false }, p);
      this->Cut(values, p, cuts, part);
      ShadeVector color[4];
      this->ColorPart(values, p, part, color);
      this->AddPart(p, part, color, std::min(lanes, count - at), waiting, q);
    }
  }

  HWY_INLINE void AddPart(const LitPieces& p, const LitPart& part, ShadeVector (&color)[4], int used,
    TileLitPieces& waiting, TileFragments& q) const
  {
    const ShadeFloat d;
    HWY_ALIGN int fragments[hn::MaxLanes(ShadeFloat())];
    hn::Store(p.Fragment, ShadeInt(), fragments);
    const auto through = hn::MulAdd(p.Through, color[3], p.Through);
    for (auto& component : color)
    {
      component = hn::Mul(component, p.Through);
    }
    AddColors(color, fragments, used, q);
    const auto open = hn::And(part.Open, hn::FirstN(d, static_cast<std::size_t>(used)));
    if (!hn::AllFalse(d, open))
    {
      AppendPieces(open, p, part, through, { false, false }, waiting);
    }
  }

  /// Cuts where the gradient has turned too far.
  template <class LookUp>
  HWY_INLINE void Cut(const LookUp& values, const LitPieces& p, bool cuts, LitPart& part) const
  {
    const ShadeFloat d;
    const auto half = hn::Set(d, 0.5f), one = hn::Set(d, 1.0f);
    const auto slope = values(this->Transfer.Slopes[3].data(), p.Piece);
    const auto rise = hn::Sub(p.Last, p.First);
    part.Front = hn::MulAdd(slope, p.First, values(this->Transfer.Offsets[3].data(), p.Piece));
    const auto middle = hn::MulAdd(hn::Mul(slope, half), rise, part.Front);
    const ShadeVector squares[3] = { Dot(p.Gradient, p.Gradient), Dot(p.Gradient, p.GradientRise),
      Dot(p.GradientRise, p.GradientRise) };
    const auto tangent = LimitTurn(hn::Mul(middle, p.Length), this->Turn, SteepestTurn);
    part.End = cuts ? TurnsUpTo(squares, tangent, one) : one;
    part.Open = hn::Lt(part.End, one);
    part.AtNode = hn::Lt(one, one);
    part.Length = hn::Mul(p.Length, part.End);
    part.LastScalar = hn::MulAdd(rise, part.End, p.First);
    part.Back = hn::MulAdd(slope, hn::Mul(rise, part.End), part.Front);
    const auto depth = hn::Mul(hn::Mul(half, part.Length), hn::Add(part.Front, part.Back));
    part.Depth = hn::Max(depth, hn::Zero(d));
  }

  template <class LookUp>
  HWY_INLINE void ColorPart(
    const LookUp& values, const LitPieces& p, const LitPart& part, ShadeVector (&color)[4]) const
  {
    const ShadeFloat d;
    SteepPlaces places;
    FindPlaces(p, part, places);
    ThinCourse course;
    course.Depth = part.Depth;
    this->Courses.FindEye(p.Pixel, course);
    SteepSums sums{ hn::Set(d, 1e-30f), { hn::Zero(d), hn::Zero(d), hn::Zero(d) } };
    for (int i = 0; i < FourNodes::Count; i += 2)
    {
      this->AddPlaces(p, part, course, places, i, sums);
    }
    const auto alpha = hn::Mul(part.Depth, ThinAlphaPerDepth(d, part.Depth));
    // Alpha is exact; twice, as of ThinNodes: lights shine half as bright.
    const auto scale = hn::Mul(hn::Add(alpha, alpha), Reciprocal(d, sums.Absorbed));
    const auto rise = hn::Sub(part.LastScalar, p.First);
    const GreySum grey{ hn::Mul(hn::Mul(sums.Grey.Scalar, scale), rise), hn::Mul(sums.Grey.Factor, scale),
      hn::Mul(sums.Grey.Highlight, scale) };
    ColorGrey(values, this->Transfer, p, grey, color);
    color[3] = hn::Neg(alpha);
  }

  static HWY_INLINE void FindPlaces(const LitPieces& p, const LitPart& part, SteepPlaces& places)
  {
    const ShadeFloat d;
    const auto side = p.Gradient[2], rise = hn::Mul(p.GradientRise[2], part.End);
    const auto passes = hn::Lt(hn::Mul(side, hn::Add(side, rise)), hn::Zero(d));
    const auto share = hn::Div(side, hn::IfThenElse(passes, hn::Neg(rise), hn::Set(d, 1.0f)));
    places.Find(passes, share);
  }

  /// Adds two places, from number `i` on.
  HWY_INLINE void AddPlaces(const LitPieces& p, const LitPart& part, const ThinCourse& course,
    const SteepPlaces& places, int i, SteepSums& sums) const
  {
    const ShadeFloat d;
    ThinGradients gradients;
    FindGradients(p, hn::Mul(places.Place[i], part.End), 0, gradients);
    FindGradients(p, hn::Mul(places.Place[i + 1], part.End), 1, gradients);
    ThinShine shine;
    this->Shining.Shine(course, gradients, shine);
    const auto front = hn::Mul(part.Front, part.Length);
    const auto rise = hn::MulSub(part.Back, part.Length, front);
    for (int k = 0; k < 2; ++k)
    {
      const auto place = places.Place[i + k];
      const auto before = hn::Mul(place, hn::MulAdd(hn::Mul(rise, place), hn::Set(d, 0.5f), front));
      const auto extinct = hn::Mul(places.Weight[i + k], hn::MulAdd(rise, place, front));
      const auto hidden = hn::Mul(before, ThinAlphaPerDepth(d, before));
      const auto absorbed = hn::NegMulAdd(extinct, hidden, extinct);
      const auto factor = hn::Mul(absorbed, shine.Factor[k]);
      sums.Absorbed = hn::Add(sums.Absorbed, absorbed);
      sums.Grey.Factor = hn::Add(sums.Grey.Factor, factor);
      sums.Grey.Scalar = hn::MulAdd(factor, place, sums.Grey.Scalar);
      sums.Grey.Highlight = hn::MulAdd(absorbed, shine.Highlight[k], sums.Grey.Highlight);
    }
  }

  /// Number `i`, at a share of a piece.
  static HWY_INLINE void FindGradients(const LitPieces& p, ShadeVector share, int i, ThinGradients& g)
  {
    for (int k = 0; k < 3; ++k)
    {
      g.At[i][k] = hn::MulAdd(share, p.GradientRise[k], p.Gradient[k]);
    }
    // Where there is none light is ambient.
    g.Square[i] = hn::Max(Dot(g.At[i], g.At[i]), hn::Set(ShadeFloat(), 1e-36f));
  }

  const TileTransfer& Transfer;
  const ThinCourses& Courses;
  const Light& Shining;
  const float Turn;
};
}
}
HWY_AFTER_NAMESPACE();

#endif
