/**
 * The gradient opacity along the ways of rays through their cells, and the colour of other
 * components than the opacity's: both piecewise linear, cut at their nodes.
 */
#if defined(TileGradientOpacity_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileGradientOpacity_inl_h
#undef TileGradientOpacity_inl_h
#else
#define TileGradientOpacity_inl_h
#endif

#include "TileLighting.h"
#include "TileLitPieces-inl.h"
#include "TileWays-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Opacity by the length of the gradient.
class TileGradientOpacity
{
public:
  explicit TileGradientOpacity(const TileLighting& lighting)
    : Function(lighting.Opacity)
    , Scale(lighting.GradientScale)
  {
  }

  /// What the square of the length is made of: a + 2 b share + c share^2.
  struct Course
  {
    ShadeVector Squares[3];
  };

  HWY_INLINE void Begin(const LitPieces& p, Course& c) const
  {
    const auto scale = hn::Set(ShadeFloat(), this->Scale * this->Scale);
    c.Squares[0] = hn::Mul(scale, Dot(p.Gradient, p.Gradient));
    c.Squares[1] = hn::Mul(scale, Dot(p.Gradient, p.GradientRise));
    c.Squares[2] = hn::Mul(scale, Dot(p.GradientRise, p.GradientRise));
  }

  HWY_INLINE ShadeVector At(const Course& c, ShadeVector share) const
  {
    const ShadeFloat d;
    const auto linear = hn::MulAdd(share, c.Squares[2], hn::Add(c.Squares[1], c.Squares[1]));
    const auto squared = hn::MulAdd(share, linear, c.Squares[0]);
    const auto length = hn::Sqrt(hn::Max(squared, hn::Zero(d)));
    const MemoryLookUp values;
    return ValueOf(values, this->Function, 3, PieceOf(values, this->Function, length), length);
  }

  /// The end of a piece up to which it is smooth: the length reaches a node, or its least.
  HWY_INLINE ShadeVector FindBend(const Course& c, ShadeVector end) const
  {
    const ShadeFloat d;
    const auto inverse = hn::Div(hn::Set(d, 1.0f), c.Squares[2]);
    const auto nearest = hn::Neg(hn::Mul(c.Squares[1], inverse));
    const auto least = hn::MulAdd(c.Squares[1], nearest, c.Squares[0]);
    auto bend = Sooner(end, nearest);
    for (int i = 1; i < this->Function.NumberOfPieces; ++i)
    {
      const float node = this->Function.Bounds[static_cast<std::size_t>(i)];
      const auto apart = hn::Mul(hn::Sub(hn::Set(d, node * node), least), inverse);
      const auto way = hn::Sqrt(hn::Max(apart, hn::Zero(d)));
      const auto some = hn::Lt(hn::Zero(d), apart);
      bend = hn::IfThenElse(some, Sooner(bend, hn::Sub(nearest, way)), bend);
      bend = hn::IfThenElse(some, Sooner(bend, hn::Add(nearest, way)), bend);
    }
    // Where the gradient does not change there is no such place.
    return hn::IfThenElse(hn::Lt(hn::Zero(d), c.Squares[2]), bend, end);
  }

private:
  const TileTransfer& Function;
  const float Scale;
};

/// Colour by one component through the colour function, or by three as they are.
class TileComponentColors
{
public:
  explicit TileComponentColors(const TileLighting& lighting)
    : Kind(lighting.ColorKind)
    , Function(lighting.ColorFunction)
  {
  }

  HWY_INLINE void At(const LitPieces& p, ShadeVector share, ShadeVector (&color)[3]) const
  {
    const MemoryLookUp values;
    for (int k = 0; k < 3; ++k)
    {
      color[k] = hn::MulAdd(share, p.ColorRise[k], p.Color[k]);
    }
    if (this->Kind == TileLighting::ScalarColor)
    {
      const auto scalar = color[0];
      const auto piece = PieceOf(values, this->Function, scalar);
      for (int k = 0; k < 3; ++k)
      {
        color[k] = ValueOf(values, this->Function, k, piece, scalar);
      }
    }
  }

  /// The end of a piece up to which it is linear: the component reaches a node.
  HWY_INLINE ShadeVector FindBend(const LitPieces& p, ShadeVector end) const
  {
    const ShadeFloat d;
    if (this->Kind != TileLighting::ScalarColor)
    {
      return end;
    }
    const auto inverse = hn::Div(hn::Set(d, 1.0f), p.ColorRise[0]);
    const auto start = hn::Mul(p.Color[0], inverse);
    auto bend = end;
    for (int i = 1; i < this->Function.NumberOfPieces; ++i)
    {
      const auto node = hn::Set(d, this->Function.Bounds[static_cast<std::size_t>(i)]);
      bend = Sooner(bend, hn::MulSub(node, inverse, start));
    }
    return bend;
  }

private:
  const TileLighting::ColorKinds Kind;
  const TileTransfer& Function;
};
}
}
HWY_AFTER_NAMESPACE();

#endif
