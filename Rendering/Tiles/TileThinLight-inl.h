/**
 * The colours of thin, lit fragments that lie in one piece of the transfer function and along which
 * light changes little: most of them, where the function is smooth.
 *
 * Then nothing is looked up or cut, and light is looked at in two fixed places (ThinNodes). All is
 * in view coordinates, where a ray's way to the eye is (x, y, 1) times a number. Only of grey
 * directional light in scenes with TileLighting::AllowsThin.
 */
#if defined(TileThinLight_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileThinLight_inl_h
#undef TileThinLight_inl_h
#else
#define TileThinLight_inl_h
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

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// A vector of fragments: scalars and weights at both ends, and the way to the eye.
struct ThinCourse
{
  PixelPlaces Places;
  ShadeVector First, Last, WeightIn, WeightOut;
  ShadeVector Length; // in the world, twice, over ViewRays::LengthPerWay
  ShadeVector EyeX, EyeY, PerEye; // 2 / length of (EyeX, EyeY, 1)
  ShadeVector Depth, Bend; // optical depth, see ThinAbsorption
};

/// The gradient along a vector of fragments, times a number: from Middle - Half to Middle + Half.
struct ThinGradients
{
  ShadeVector Middle[3], Half[3];
  ShadeVector MiddleSquare, HalfSquare, Product;
};

/// Sums over the lights at the two nodes.
struct ThinShine
{
  ShadeVector Factor[2], Highlight[2];
};

class ThinLight
{
public:
  ThinLight(const TileTask& task, const TileRectangle& tile)
    : Transfer(*task.Transfer)
    , Lighting(*task.Lighting)
    , Gradients(*task.Gradients, *task.Lighting, *task.View, tile)
    , WeightScale(static_cast<float>(task.View->WeightScale))
    , WeightOffset(static_cast<float>(task.View->WeightOffset))
    , SquaredTurn(task.Lighting->GreatestTurn * task.Lighting->GreatestTurn)
    , LeastDepth(std::pow(task.Lighting->GreatestTurn / GreatestTurn, 8.0f))
    , Power(static_cast<int>(task.Lighting->Power))
  {
    const TileLighting::ViewRays& rays = task.Lighting->Rays;
    for (int k = 0; k < 2; ++k)
    {
      const double corner = k == 0 ? tile.Left : tile.Bottom;
      this->EyeStart[k] = static_cast<float>(rays.ToEye[k] + corner * rays.PerPixel[k]);
      this->EyePerPixel[k] = static_cast<float>(rays.PerPixel[k]);
    }
    this->Take(0);
  }

  /// Colours a vector of fragments, unless one of them is not thin, leaves the piece, or light
  /// changes too much along it.
  HWY_INLINE bool Color(const TileFragments& q, int at, ShadeVector (&color)[4])
  {
    ThinCourse course{ PixelPlaces(hn::Load(ShadeInt(), q.Pixel + at)) };
    this->FindCourse(q, at, course);
    if (!this->IsThin(course) && !(this->TakePieceOf(course.First) && this->IsThin(course)))
    {
      return false;
    }
    ThinGradients g;
    this->FindGradients(q, at, course, g);
    if (!this->IsSmooth(course, g))
    {
      return false;
    }
    ThinShine shine;
    this->Shine(course, g, shine);
    this->Mix(course, shine, color);
    return true;
  }

private:
  /// Of the two nodes from the middle, as a share of half the way.
  static constexpr float Apart = 0.57735027f;

  HWY_INLINE void FindCourse(const TileFragments& q, int at, ThinCourse& c) const
  {
    const ShadeFloat d;
    const auto extent = hn::Load(d, q.Extent + at);
    const auto scale = hn::Set(d, this->WeightScale);
    c.WeightIn = hn::MulAdd(scale, hn::Load(d, q.Entry + at), hn::Set(d, this->WeightOffset));
    c.WeightOut = hn::NegMulAdd(scale, extent, c.WeightIn);
    const auto inverse = Reciprocal(d, hn::Mul(c.WeightIn, c.WeightOut));
    c.First = hn::Mul(hn::Mul(hn::Load(d, q.ScalarIn + at), c.WeightOut), inverse);
    c.Last = hn::Mul(hn::Mul(hn::Load(d, q.ScalarOut + at), c.WeightIn), inverse);
    c.EyeX = hn::MulAdd(hn::Set(d, this->EyePerPixel[0]), c.Places.X, hn::Set(d, this->EyeStart[0]));
    c.EyeY = hn::MulAdd(hn::Set(d, this->EyePerPixel[1]), c.Places.Y, hn::Set(d, this->EyeStart[1]));
    const auto square =
      hn::MulAdd(c.EyeX, c.EyeX, hn::MulAdd(c.EyeY, c.EyeY, hn::Set(d, 1.0f)));
    c.PerEye = TwiceInverseRoot(d, square);
    c.Length = hn::Mul(hn::Mul(extent, inverse), hn::Mul(square, c.PerEye));
  }

  /// Whether all lie in the piece and have a small optical depth, which it finds.
  HWY_INLINE bool IsThin(ThinCourse& c) const
  {
    const ShadeFloat d;
    const auto perScalar = hn::Set(d, this->HalfSlope);
    const auto middle =
      hn::MulAdd(perScalar, hn::Add(c.First, c.Last), hn::Set(d, this->Offset));
    const auto depth = hn::Mul(middle, c.Length);
    c.Depth = hn::Max(depth, hn::Zero(d));
    c.Bend = hn::Mul(hn::Mul(perScalar, c.Length), hn::Sub(c.Last, c.First));
    const auto below = hn::Sub(hn::Set(d, this->Low), hn::Min(c.First, c.Last));
    const auto above = hn::Sub(hn::Max(c.First, c.Last), hn::Set(d, this->High));
    // The depth last: where a scalar is not a number neither is it.
    const auto beyond =
      hn::Max(hn::Max(below, above), hn::Sub(depth, hn::Set(d, DeepestThin)));
    return hn::AllTrue(d, hn::Le(beyond, hn::Zero(d)));
  }

  /// Both ends times the product of their weights.
  HWY_INLINE void FindGradients(
    const TileFragments& q, int at, const ThinCourse& c, ThinGradients& g)
  {
    const ShadeFloat d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    ShadeVector in[3], out[3];
    this->Gradients.Find(q, at, std::min(lanes, q.Count - at), c.Places, in, out);
    for (int k = 0; k < 3; ++k)
    {
      const auto begin = hn::Mul(in[k], c.WeightOut);
      const auto end = hn::Mul(out[k], c.WeightIn);
      g.Middle[k] = hn::Add(end, begin);
      g.Half[k] = hn::Sub(end, begin);
    }
    g.MiddleSquare = Dot(g.Middle, g.Middle);
    g.HalfSquare = Dot(g.Half, g.Half);
    g.Product = Dot(g.Middle, g.Half);
  }

  /// Whether the gradient turns little, for the optical depth as TileLightSource has it, is not zero,
  /// and does not turn away from a light.
  HWY_INLINE bool IsSmooth(const ThinCourse& c, const ThinGradients& g) const
  {
    const ShadeFloat d;
    const auto crossed =
      hn::MulSub(g.MiddleSquare, g.HalfSquare, hn::Mul(g.Product, g.Product));
    const auto ahead = hn::Sub(g.MiddleSquare, g.HalfSquare);
    const auto deep = hn::Max(c.Depth, hn::Set(d, this->LeastDepth));
    const auto root = hn::ApproximateReciprocalSqrt(hn::ApproximateReciprocalSqrt(deep));
    const auto turn = hn::Mul(hn::MulAdd(crossed, hn::Set(d, 4.0f), hn::Set(d, 1e-30f)), root);
    const auto room = hn::Mul(hn::Mul(ahead, ahead), hn::Set(d, this->SquaredTurn));
    // Less, not at most: near the eye both may be infinite.
    auto smooth = hn::And(hn::Lt(turn, room), hn::Lt(hn::Zero(d), ahead));
    const auto least = hn::Mul(g.MiddleSquare, hn::Set(d, 0.25f * LeastKink * LeastKink));
    for (const TileLight& light : this->Lighting.Lights)
    {
      const auto middle = SideOf(light, g.Middle), half = SideOf(light, g.Half);
      const auto kink = hn::Mul(half, c.Depth);
      const auto kept = hn::Le(hn::Abs(half), hn::Abs(middle));
      smooth = hn::And(smooth, hn::Or(kept, hn::Le(hn::Mul(kink, kink), least)));
    }
    return hn::AllTrue(d, smooth);
  }

  static HWY_INLINE ShadeVector SideOf(const TileLight& light, const ShadeVector (&gradient)[3])
  {
    return light.IsAlongView ? gradient[2] : Dot(gradient, light.Towards);
  }

  /// Twice 1 / the length of the gradient at both nodes.
  static HWY_INLINE void InvertLengths(const ThinGradients& g, ShadeVector (&inverse)[2])
  {
    const ShadeFloat d;
    const auto squares = hn::MulAdd(g.HalfSquare, hn::Set(d, Apart * Apart), g.MiddleSquare);
    const auto product = hn::Mul(g.Product, hn::Set(d, 2.0f * Apart));
    inverse[0] = TwiceInverseRoot(d, hn::Sub(squares, product));
    inverse[1] = TwiceInverseRoot(d, hn::Add(squares, product));
  }

  /// Light at both nodes; roots are taken twice as great, see TwiceInverseRoot.
  HWY_INLINE void Shine(const ThinCourse& c, const ThinGradients& g, ThinShine& shine) const
  {
    const ShadeFloat d;
    const auto apart = hn::Set(d, Apart);
    ShadeVector inverse[2];
    InvertLengths(g, inverse);
    const auto seenMiddle = this->TowardsEye(c, g.Middle);
    const auto seenHalf = hn::Mul(this->TowardsEye(c, g.Half), apart);
    const ShadeVector seen[2] = { hn::Mul(hn::Sub(seenMiddle, seenHalf), inverse[0]),
      hn::Mul(hn::Add(seenMiddle, seenHalf), inverse[1]) };
    for (int i = 0; i < 2; ++i)
    {
      shine.Factor[i] = hn::Set(d, 0.5f * this->Lighting.Ambient[0]);
      shine.Highlight[i] = hn::Zero(d);
    }
    const auto perEye = hn::Mul(c.PerEye, hn::Set(d, 0.25f));
    for (const TileLight& light : this->Lighting.Lights)
    {
      const auto middle = SideOf(light, g.Middle);
      const auto half = hn::Mul(SideOf(light, g.Half), apart);
      const ShadeVector cosine[2] = { hn::Mul(hn::Sub(middle, half), inverse[0]),
        hn::Mul(hn::Add(middle, half), inverse[1]) };
      for (int i = 0; i < 2; ++i)
      {
        const auto diffuse = hn::Set(d, 0.25f * light.Diffuse[0]);
        shine.Factor[i] = hn::MulAdd(hn::Abs(cosine[i]), diffuse, shine.Factor[i]);
      }
      if (this->Lighting.HasHighlight)
      {
        this->AddHighlight(c, light, cosine, seen, perEye, shine);
      }
    }
  }

  HWY_INLINE void AddHighlight(const ThinCourse& c, const TileLight& light,
    const ShadeVector (&cosine)[2], const ShadeVector (&seen)[2], ShadeVector perEye,
    ThinShine& shine) const
  {
    const ShadeFloat d;
    auto toLight = hn::Set(d, 2.0f * light.Towards[2]);
    if (!light.IsAlongView)
    {
      toLight = hn::MulAdd(c.EyeX, hn::Set(d, 2.0f * light.Towards[0]), toLight);
      toLight = hn::MulAdd(c.EyeY, hn::Set(d, 2.0f * light.Towards[1]), toLight);
    }
    ShadeVector mirrored[2];
    for (int i = 0; i < 2; ++i)
    {
      const auto above = hn::Max(hn::MulSub(cosine[i], seen[i], toLight), hn::Zero(d));
      mirrored[i] = hn::Mul(above, perEye);
    }
    this->Raise(mirrored);
    const auto specular = hn::Set(d, 0.5f * light.Specular[0]);
    for (int i = 0; i < 2; ++i)
    {
      shine.Highlight[i] = hn::MulAdd(mirrored[i], specular, shine.Highlight[i]);
    }
  }

  /// To the power, which is whole and at least 2.
  HWY_INLINE void Raise(ShadeVector (&bases)[2]) const
  {
    int left = this->Power;
    auto square = [&]
    {
      bases[0] = hn::Mul(bases[0], bases[0]);
      bases[1] = hn::Mul(bases[1], bases[1]);
      left >>= 1;
    };
    while ((left & 1) == 0)
    {
      square();
    }
    ShadeVector product[2] = { bases[0], bases[1] };
    while (left > 1)
    {
      square();
      if (left & 1)
      {
        product[0] = hn::Mul(product[0], bases[0]);
        product[1] = hn::Mul(product[1], bases[1]);
      }
    }
    bases[0] = product[0];
    bases[1] = product[1];
  }

  static HWY_INLINE ShadeVector TowardsEye(const ThinCourse& c, const ShadeVector (&gradient)[3])
  {
    return hn::MulAdd(c.EyeX, gradient[0], hn::MulAdd(c.EyeY, gradient[1], gradient[2]));
  }

  /// What both nodes make of the transfer function's colours.
  HWY_INLINE void Mix(
    const ThinCourse& c, const ThinShine& shine, ShadeVector (&color)[4]) const
  {
    const ShadeFloat d;
    const ThinNodes<ShadeVector> nodes(d, c.Depth, c.Bend);
    const auto before = hn::Mul(nodes.Before, shine.Factor[0]);
    const auto behind = hn::Mul(nodes.Behind, shine.Factor[1]);
    const auto factor = hn::Add(before, behind);
    const auto rise = hn::Mul(hn::Sub(c.Last, c.First), hn::Set(d, Apart));
    const auto moment = hn::Mul(rise, hn::Sub(behind, before));
    const auto highlight = hn::MulAdd(
      nodes.Before, shine.Highlight[0], hn::Mul(nodes.Behind, shine.Highlight[1]));
    const auto sum = hn::Add(c.First, c.Last);
    for (int k = 0; k < 3; ++k)
    {
      const auto slope = hn::Set(d, this->HalfColorSlopes[k]);
      const auto middle = hn::MulAdd(slope, sum, hn::Set(d, this->ColorOffsets[k]));
      color[k] = hn::MulAdd(slope, moment, hn::MulAdd(middle, factor, highlight));
    }
    color[3] = hn::Neg(nodes.Alpha);
  }

  /// Goes over to the piece of the first scalar; says whether it is another one.
  HWY_INLINE bool TakePieceOf(ShadeVector scalars)
  {
    const int piece = FindPiece(this->Transfer, hn::GetLane(scalars));
    const bool isOther = piece != this->Piece;
    this->Take(piece);
    return isOther;
  }

  void Take(int piece)
  {
    const TileTransfer& t = this->Transfer;
    const auto perLength = static_cast<float>(0.5 * this->Lighting.Rays.LengthPerWay);
    this->Piece = piece;
    this->Low = t.Bounds[piece];
    this->High = t.Bounds[piece + 1];
    this->HalfSlope = 0.5f * perLength * t.Slopes[3][piece];
    this->Offset = perLength * t.Offsets[3][piece];
    for (int k = 0; k < 3; ++k)
    {
      this->HalfColorSlopes[k] = 0.5f * t.Slopes[k][piece];
      this->ColorOffsets[k] = t.Offsets[k][piece];
    }
  }

  const TileTransfer& Transfer;
  const TileLighting& Lighting;
  ScreenGradients Gradients;
  const float WeightScale, WeightOffset;
  // The tangent of the greatest turn, squared; the depth from which on it counts.
  const float SquaredTurn, LeastDepth;
  const int Power;
  float EyeStart[2], EyePerPixel[2];
  int Piece = 0;
  float Low, High;
  // Of extinction over the scalar, for half of ThinCourse::Length.
  float HalfSlope, Offset;
  float HalfColorSlopes[3], ColorOffsets[3];
};
}
}
HWY_AFTER_NAMESPACE();

#endif
