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
#include <cmath>
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
  ShadeVector Entry, Extent, WeightIn, WeightOut;
  ShadeVector Inverse; // of both weights' product
  ShadeVector First, Last, Length; // scalars at both ends; in the world
  ShadeVector EyeX, EyeY, PerEye; // 2 / length of (EyeX, EyeY, 1)
  ShadeIndex Piece;
  ShadeVector Depth, Bend; // optical depth, see ThinAbsorption
  ShadeVector Gradient[2][3]; // at the two places, times a number
  ShadeVector Square[2]; // of the gradient
  ShadeMask Fits;
};

/// Of the two places from the middle, as a share of half the way.
constexpr float ThinApart = 0.57735027f;

HWY_INLINE ShadeVector SideOf(const TileLight& light, const ShadeVector (&gradient)[3])
{
  return light.IsAlongView ? gradient[2] : Dot(gradient, light.Towards);
}

class ThinCourses
{
public:
  ThinCourses(const TileTask& task, const TileRectangle& tile)
    : Transfer(*task.Transfer)
    , Lighting(*task.Lighting)
    , Gradients(*task.Gradients, *task.Lighting, *task.View, tile)
    , WeightScale(Spread(task.View->WeightScale))
    , WeightOffset(Spread(task.View->WeightOffset))
    , HalfLengthPerWay(Spread(0.5 * task.Lighting->Rays.LengthPerWay))
    , SquaredTurn(Spread(task.Lighting->GreatestTurn * task.Lighting->GreatestTurn))
    , LeastDepth(Spread(std::pow(task.Lighting->GreatestTurn / GreatestTurn, 8.0f)))
    , ApartScale(Spread(ThinApart * task.View->WeightScale))
    , ApartOffset(Spread(ThinApart * task.View->WeightOffset))
  {
    const TileLighting::ViewRays& rays = task.Lighting->Rays;
    for (int k = 0; k < 2; ++k)
    {
      const double corner = k == 0 ? tile.Left : tile.Bottom;
      this->EyeStart[k] = Spread(rays.ToEye[k] + corner * rays.PerPixel[k]);
      this->EyePerPixel[k] = Spread(rays.PerPixel[k]);
    }
  }

  /// Of the vector of fragments from `at` on: all that goes before the optical depth.
  HWY_INLINE void Find(const TileFragments& q, int at, ThinCourse& c) const
  {
    const ShadeFloat d;
    const PixelPlaces places(hn::Load(ShadeInt(), q.Pixel + at));
    c.X = places.X;
    c.Y = places.Y;
    c.Entry = hn::Load(d, q.Entry + at);
    c.Extent = hn::Load(d, q.Extent + at);
    c.WeightIn = hn::MulAdd(this->WeightScale, c.Entry, this->WeightOffset);
    c.WeightOut = hn::NegMulAdd(this->WeightScale, c.Extent, c.WeightIn);
    c.Inverse = Reciprocal(d, hn::Mul(c.WeightIn, c.WeightOut));
    c.First = hn::Mul(hn::Mul(hn::Load(d, q.ScalarIn + at), c.WeightOut), c.Inverse);
    c.Last = hn::Mul(hn::Mul(hn::Load(d, q.ScalarOut + at), c.WeightIn), c.Inverse);
    c.EyeX = hn::MulAdd(this->EyePerPixel[0], c.X, this->EyeStart[0]);
    c.EyeY = hn::MulAdd(this->EyePerPixel[1], c.Y, this->EyeStart[1]);
    const auto square =
      hn::MulAdd(c.EyeX, c.EyeX, hn::MulAdd(c.EyeY, c.EyeY, hn::Set(d, 1.0f)));
    c.PerEye = TwiceInverseRoot(d, square);
    const auto way = hn::Mul(hn::Mul(square, c.PerEye), this->HalfLengthPerWay);
    c.Length = hn::Mul(hn::Mul(c.Extent, c.Inverse), way);
  }

  /// Piece and optical depth; which fragments are thin and lie in one piece.
  template <class LookUp>
  HWY_INLINE void FindDepth(const LookUp& values, ThinCourse& c) const
  {
    const ShadeFloat d;
    const TileTransfer& t = this->Transfer;
    const auto half = hn::Set(d, 0.5f);
    c.Piece = PieceOf(values, t, c.First);
    const auto perScalar = hn::Mul(values(t.Slopes[3].data(), c.Piece), half);
    const auto middle = hn::MulAdd(
      perScalar, hn::Add(c.First, c.Last), values(t.Offsets[3].data(), c.Piece));
    const auto depth = hn::Mul(middle, c.Length);
    c.Bend = hn::Mul(hn::Mul(perScalar, c.Length), hn::Sub(c.Last, c.First));
    c.Depth = hn::Max(depth, hn::Zero(d));
    // The depth last: where a scalar is not a number neither is it.
    const auto beyond = hn::Sub(depth, hn::Set(d, DeepestThin));
    c.Fits = hn::Le(hn::Max(this->BeyondPiece(values, c), beyond), hn::Zero(d));
  }

  /// Gradients. Fragments do not fit along which they turn too much for the optical depth, as TileLightSource
  /// has it, are zero, or turn away from a light.
  HWY_INLINE void FindGradients(const TileFragments& q, int at, ThinCourse& c)
  {
    this->FindNodes(q, at, c);
    c.Square[0] = Dot(c.Gradient[0], c.Gradient[0]);
    c.Square[1] = Dot(c.Gradient[1], c.Gradient[1]);
    const auto product = Dot(c.Gradient[0], c.Gradient[1]);
    this->LeaveTurning(product, c);
  }

private:
  static ShadeVector Spread(double value) { return hn::Set(ShadeFloat(), static_cast<float>(value)); }

  HWY_INLINE void LeaveTurning(ShadeVector product, ThinCourse& c) const
  {
    const ShadeFloat d;
    const auto crossed =
      hn::MulSub(c.Square[0], c.Square[1], hn::Mul(product, product));
    const auto squares = hn::Add(c.Square[0], c.Square[1]), twice = hn::Add(product, product);
    // At both ends: the gradients' product; their cross product is the nodes' times the root of 3.
    const auto ahead = hn::NegMulAdd(squares, hn::Set(d, 0.5f), twice);
    const auto deep = hn::Max(c.Depth, this->LeastDepth);
    const auto root = hn::ApproximateReciprocalSqrt(hn::ApproximateReciprocalSqrt(deep));
    const auto turn = hn::Mul(hn::MulAdd(crossed, hn::Set(d, 3.0f), hn::Set(d, 1e-30f)), root);
    const auto room = hn::Mul(hn::Mul(ahead, ahead), this->SquaredTurn);
    // Less, not at most: near the eye both may be infinite.
    const auto smooth = hn::And(hn::Lt(turn, room), hn::Lt(hn::Zero(d), ahead));
    c.Fits = hn::And(c.Fits, smooth);
    const auto least = hn::Mul(hn::Add(squares, twice), hn::Set(d, 0.25f * LeastKink * LeastKink));
    for (const TileLight& light : this->Lighting.Lights)
    {
      c.Fits = hn::And(c.Fits, StaysBefore(light, c, least));
    }
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

  /// What is linear on the screen, at the two places: times the weights of both ends.
  HWY_INLINE void FindNodes(const TileFragments& q, int at, ThinCourse& c)
  {
    const int used = std::min(static_cast<int>(hn::Lanes(ShadeFloat())), q.Count - at);
    ShadeVector mixed[ScreenGradients::Terms];
    const ShadeVector* rows = this->Gradients.Load(q.Cell + at, used, mixed);
    const auto exit = hn::Sub(c.Entry, c.Extent);
    const auto even = hn::Add(c.WeightIn, c.WeightOut);
    const auto along = hn::MulAdd(c.Entry, c.WeightOut, hn::Mul(exit, c.WeightIn));
    const ShadeVector across[2] = { hn::NegMulAdd(this->ApartScale, c.Extent, even),
      hn::MulAdd(this->ApartScale, c.Extent, even) };
    const ShadeVector depths[2] = { hn::MulAdd(this->ApartOffset, c.Extent, along),
      hn::NegMulAdd(this->ApartOffset, c.Extent, along) };
    for (int k = 0; k < 3; ++k)
    {
      const ShadeVector* r = rows + 4 * k;
      const auto plane = hn::MulAdd(r[0], c.X, hn::MulAdd(r[1], c.Y, r[3]));
      for (int i = 0; i < 2; ++i)
      {
        c.Gradient[i][k] = hn::MulAdd(plane, across[i], hn::Mul(r[2], depths[i]));
      }
    }
  }

  /// Whether both ends are on the same side, or what turns away is too little to be seen.
  static HWY_INLINE ShadeMask StaysBefore(
    const TileLight& light, const ThinCourse& c, ShadeVector least)
  {
    const ShadeFloat d;
    const auto first = SideOf(light, c.Gradient[0]), second = SideOf(light, c.Gradient[1]);
    const auto turned = hn::Mul(hn::Sub(second, first), c.Depth);
    const auto kept = hn::Mul(hn::Add(second, first), c.Depth);
    const auto allowed = hn::Max(hn::Mul(kept, kept), least);
    return hn::Le(hn::Mul(hn::Mul(turned, turned), hn::Set(d, 3.0f)), allowed);
  }

  const TileTransfer& Transfer;
  const TileLighting& Lighting;
  ScreenGradients Gradients;
  // Vectors: to spread a number takes an instruction each time where registers are few.
  const ShadeVector WeightScale, WeightOffset, HalfLengthPerWay;
  // The tangent of the greatest turn, squared; the depth from which on it counts.
  const ShadeVector SquaredTurn, LeastDepth;
  const ShadeVector ApartScale, ApartOffset;
  ShadeVector EyeStart[2], EyePerPixel[2];
};
}
}
HWY_AFTER_NAMESPACE();

#endif
