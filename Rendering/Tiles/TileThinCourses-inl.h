/**
 * The courses of rays through their cells where light may be looked at in two fixed places: scalars,
 * lengths, optical depths, and gradients at both places.
 *
 * All is in view coordinates, where a ray's way to the eye is (x, y, 1) times a number.
 */
#if defined(TileThinCourses_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileThinCourses_inl_h
#undef TileThinCourses_inl_h
#else
#define TileThinCourses_inl_h
#endif

#include "TileLight-inl.h"
#include "TileLighting.h"
#include "TileMath-inl.h"
#include "TilePieces-inl.h"
#include "TilePixels-inl.h"
#include "TileScreenGradients-inl.h"
#include "TileTask.h"
#include "TileTransfer.h"
#include "TileView.h"
#include "TileWays-inl.h"

#include <hwy/highway.h>

#include <algorithm>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// A vector of fragments.
struct ThinCourse
{
  ShadeVector X, Y; // of the pixels
  ShadeVector Place[2]; // u at the two places
  ShadeVector First, Last, Length; // scalars at both ends; in the world
  ShadeVector EyeX, EyeY, PerEye; // 2 / length of (EyeX, EyeY, 1)
  ShadeIndex Piece;
  ShadeVector Depth; // optical
  ShadeVector Alpha, Before, Behind; // see ThinNodes
  ShadeMask Fits;
};

/// The gradients of a vector of fragments at the two places, each times a number.
struct ThinGradients
{
  ShadeVector At[2][3];
  ShadeVector Square[2], Product;
};

/// The two places along a fragment.
constexpr float ThinPlaces[2] = { 0.21132487f, 0.78867513f };

class ThinCourses
{
public:
  ThinCourses(const TileTask& task, const TileRectangle& tile)
    : Transfer(*task.Transfer)
    , Gradients(*task.Gradients, *task.Lighting, *task.View, tile)
    , WeightScale(Spread(task.View->WeightScale))
    , WeightOffset(Spread(task.View->WeightOffset))
    , HalfLengthPerWay(Spread(0.5 * task.Lighting->Rays.LengthPerWay))
    , HalfTurn(Spread(task.Lighting->GreatestTurn * 0.28867513))
    , TwiceTurn(Spread(task.Lighting->GreatestTurn * 1.15470054))
    , LeastDepth(Spread(FindLeastDepth(task.Lighting->GreatestTurn / GreatestTurn)))
  {
    const TileLighting::ViewRays& rays = task.Lighting->Rays;
    for (int k = 0; k < 2; ++k)
    {
      const double corner = k == 0 ? tile.Left : tile.Bottom;
      this->EyeStart[k] = Spread(rays.ToEye[k] + corner * rays.PerPixel[k]);
      this->EyePerPixel[k] = Spread(rays.PerPixel[k]);
    }
  }

  /// The pixels' places and the way from there to the eye; returns that way's square.
  HWY_INLINE ShadeVector FindEye(ShadeIndex pixel, ThinCourse& c) const
  {
    const ShadeFloat d;
    const PixelPlaces places(pixel);
    c.X = places.X;
    c.Y = places.Y;
    c.EyeX = hn::MulAdd(this->EyePerPixel[0], c.X, this->EyeStart[0]);
    c.EyeY = hn::MulAdd(this->EyePerPixel[1], c.Y, this->EyeStart[1]);
    const auto square =
      hn::MulAdd(c.EyeX, c.EyeX, hn::MulAdd(c.EyeY, c.EyeY, hn::Set(d, 1.0f)));
    c.PerEye = TwiceInverseRoot(d, square);
    return square;
  }

  /// Of the vector of fragments from `at` on: all that goes before the optical depth.
  HWY_INLINE void Find(const TileFragments& q, int at, ThinCourse& c) const
  {
    const ShadeFloat d;
    const auto square = this->FindEye(hn::Load(ShadeInt(), q.Pixel + at), c);
    const auto way = hn::Mul(hn::Mul(square, c.PerEye), this->HalfLengthPerWay);
    const ThinEnds ends = this->FindEnds(q, at);
    c.Length = hn::Mul(hn::Mul(ends.Extent, ends.Inverse), way);
    c.First = hn::Mul(hn::Load(d, q.ScalarIn + at), hn::Mul(ends.WeightOut, ends.Inverse));
    c.Last = hn::Mul(hn::Load(d, q.ScalarOut + at), hn::Mul(ends.WeightIn, ends.Inverse));
    // Even in depth, not in u.
    const auto extent = hn::Mul(ends.Extent, ends.WeightIn);
    for (int i = 0; i < 2; ++i)
    {
      const auto ratio = hn::Set(d, ThinPlaces[1 - i] / ThinPlaces[i]);
      const auto whole = hn::MulAdd(ends.WeightOut, ratio, ends.WeightIn);
      c.Place[i] = hn::NegMulAdd(extent, hn::ApproximateReciprocal(whole), ends.Entry);
    }
  }

  /// Piece, optical depth and what is absorbed; which fragments are thin and lie in one piece.
  template <class LookUp>
  HWY_INLINE void FindDepth(const LookUp& values, ThinCourse& c) const
  {
    const ShadeFloat d;
    const TileTransfer& t = this->Transfer;
    c.Piece = PieceOf(values, t, c.First);
    const auto perScalar = hn::Mul(values(t.Slopes[3].data(), c.Piece), hn::Set(d, 0.5f));
    const auto middle = hn::MulAdd(
      perScalar, hn::Add(c.First, c.Last), values(t.Offsets[3].data(), c.Piece));
    const auto depth = hn::Mul(middle, c.Length);
    // The depth last: where a scalar is not a number neither is it.
    const auto beyond = hn::Sub(depth, hn::Set(d, DeepestThin));
    c.Fits = hn::Le(hn::Max(this->BeyondPiece(values, c), beyond), hn::Zero(d));
    c.Depth = hn::Max(depth, hn::Zero(d));
    const auto bend = hn::Mul(hn::Mul(perScalar, c.Length), hn::Sub(c.Last, c.First));
    const ThinNodes<ShadeVector> nodes(d, c.Depth, bend);
    c.Alpha = nodes.Alpha;
    c.Before = nodes.Before;
    c.Behind = nodes.Behind;
  }

  /// What gradients are made of in the vector of fragments from `at` on: see ScreenGradients::Load.
  HWY_INLINE const ShadeVector* LoadRows(
    const TileFragments& q, int at, ShadeVector (&mixed)[ScreenGradients::Terms])
  {
    const int used = std::min(static_cast<int>(hn::Lanes(ShadeFloat())), q.Count - at);
    return this->Gradients.Load(q.Cell + at, used, mixed);
  }

  static HWY_INLINE void FindGradients(const ShadeVector* rows, const ThinCourse& c, ThinGradients& g)
  {
    for (int k = 0; k < 3; ++k)
    {
      const ShadeVector* r = rows + 4 * k;
      const auto plane = hn::MulAdd(r[0], c.X, hn::MulAdd(r[1], c.Y, r[3]));
      g.At[0][k] = hn::MulAdd(r[2], c.Place[0], plane);
      g.At[1][k] = hn::MulAdd(r[2], c.Place[1], plane);
    }
    g.Square[0] = Dot(g.At[0], g.At[0]);
    g.Square[1] = Dot(g.At[1], g.At[1]);
    g.Product = Dot(g.At[0], g.At[1]);
  }

  /// Along which fragments gradients turn little for the optical depth, as TileLightSource has it, and are not zero.
  HWY_INLINE ShadeMask TurnsLittle(const ThinGradients& g, ShadeVector depth) const
  {
    const ShadeFloat d;
    const auto crossed = hn::MulSub(g.Square[0], g.Square[1], hn::Mul(g.Product, g.Product));
    // At both ends: the gradients' product; their cross product is the nodes' times the root of 3.
    const auto squares = hn::Add(g.Square[0], g.Square[1]);
    const auto ahead = hn::NegMulAdd(squares, this->HalfTurn, hn::Mul(g.Product, this->TwiceTurn));
    const auto deep = hn::Max(depth, this->LeastDepth);
    const auto root = hn::Mul(deep, hn::ApproximateReciprocalSqrt(deep));
    // Less, not at most: near the eye both may be infinite.
    return hn::Lt(hn::Mul(crossed, root), hn::Mul(ahead, hn::Abs(ahead)));
  }

  /// The gradients where fragments begin, and what they change by up to their ends.
  HWY_INLINE void FindRises(const TileFragments& q, int at, const ShadeVector* rows, const ThinCourse& c,
    ShadeVector (&begin)[3], ShadeVector (&rise)[3]) const
  {
    const ThinEnds ends = this->FindEnds(q, at);
    const auto inverse = hn::Mul(ends.Inverse, this->WeightOffset);
    const auto in = hn::Mul(ends.WeightOut, inverse), out = hn::Mul(ends.WeightIn, inverse);
    const auto exit = hn::Sub(ends.Entry, ends.Extent);
    for (int k = 0; k < 3; ++k)
    {
      const ShadeVector* r = rows + 4 * k;
      const auto plane = hn::MulAdd(r[0], c.X, hn::MulAdd(r[1], c.Y, r[3]));
      begin[k] = hn::Mul(hn::MulAdd(r[2], ends.Entry, plane), in);
      rise[k] = hn::MulSub(hn::MulAdd(r[2], exit, plane), out, begin[k]);
    }
  }

private:
  /// A vector of fragments in u; the inverse of both weights' product.
  struct ThinEnds
  {
    ShadeVector Entry, Extent, WeightIn, WeightOut, Inverse;
  };

  static ShadeVector Spread(double value) { return hn::Set(ShadeFloat(), static_cast<float>(value)); }

  static float FindLeastDepth(float share)
  {
    return share * share * share * share;
  }

  HWY_INLINE ThinEnds FindEnds(const TileFragments& q, int at) const
  {
    const ShadeFloat d;
    ThinEnds ends;
    ends.Entry = hn::Load(d, q.Entry + at);
    ends.Extent = hn::Load(d, q.Extent + at);
    ends.WeightIn = hn::MulAdd(this->WeightScale, ends.Entry, this->WeightOffset);
    ends.WeightOut = hn::NegMulAdd(this->WeightScale, ends.Extent, ends.WeightIn);
    ends.Inverse = Reciprocal(d, hn::Mul(ends.WeightIn, ends.WeightOut));
    return ends;
  }

  template <class LookUp>
  HWY_INLINE ShadeVector BeyondPiece(const LookUp& values, const ThinCourse& c) const
  {
    if constexpr (std::is_same_v<LookUp, OnePieceLookUp>)
    {
      return hn::Zero(ShadeFloat());
    }
    const float* bounds = this->Transfer.Bounds.data();
    const auto below = hn::Sub(values(bounds, c.Piece), hn::Min(c.First, c.Last));
    const auto above = hn::Sub(hn::Max(c.First, c.Last), values(bounds + 1, c.Piece));
    return hn::Max(below, above);
  }

  const TileTransfer& Transfer;
  ScreenGradients Gradients;
  // Vectors: to spread a number takes an instruction each time where registers are few.
  const ShadeVector WeightScale, WeightOffset, HalfLengthPerWay;
  // Half and twice the tangent of the greatest turn over the root of 3; the depth from which on it counts.
  const ShadeVector HalfTurn, TwiceTurn, LeastDepth;
  ShadeVector EyeStart[2], EyePerPixel[2];
};
}
}
HWY_AFTER_NAMESPACE();

#endif
