/**
 * Light along the ways of rays through their cells: Phong's model, two-sided (class TileLighting).
 *
 * The gradient g is linear along the way, hence |g|^2 is quadratic and its product with a fixed
 * direction linear: what they are made of is found once per piece.
 */
#if defined(TileLight_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileLight_inl_h
#undef TileLight_inl_h
#else
#define TileLight_inl_h
#endif

#include "TileLighting.h"
#include "TileLitPieces-inl.h"
#include "TileWays-inl.h"

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Of the cosine of the angle to a light, times the optical depth: what may pass unseen.
constexpr float LeastKink = 2e-3f;
/// The tangent of the angle that the gradient turns by in a piece of any depth, at most.
constexpr float GreatestTurn = 0.8f;
/// As many cuts of a fragment are for light and gradient opacity.
constexpr int MostBends = 256;

/// The tangent of the angle that the gradient may turn by: what is wrong then is much the same for any optical depth.
HWY_INLINE ShadeVector LimitTurn(ShadeVector depth, float turn, float greatest)
{
  const ShadeFloat d;
  const auto root = hn::ApproximateReciprocalSqrt(hn::Max(depth, hn::Set(d, 1e-6f)));
  const auto fourth = hn::Mul(root, hn::ApproximateReciprocalSqrt(root));
  return hn::Min(hn::Mul(fourth, hn::Set(d, turn)), hn::Set(d, greatest));
}

/// The share of a piece, `end` at most, up to which a gradient turns by an angle of a tangent: it moves along a line
/// that passes zero at a distance. `squares`: as LitCourse has them.
HWY_INLINE ShadeVector TurnsUpTo(const ShadeVector (&squares)[3], ShadeVector tangent, ShadeVector end)
{
  const ShadeFloat d;
  const auto ahead = hn::MulAdd(end, squares[1], squares[0]);
  const auto room = hn::Mul(tangent, ahead);
  const auto crossed = hn::MulSub(squares[0], squares[2], hn::Mul(squares[1], squares[1]));
  const auto sideways = hn::Mul(hn::Mul(end, end), crossed);
  const auto small = hn::Le(sideways, hn::Mul(room, room));
  const auto straight = hn::And(hn::Lt(hn::Zero(d), ahead), small);
  const auto turns = hn::AndNot(straight, hn::Lt(hn::Zero(d), squares[2]));
  if (hn::AllFalse(d, turns))
  {
    return end;
  }
  const auto inverse = hn::Div(hn::Set(d, 1.0f), squares[2]);
  const auto from = hn::Mul(squares[1], inverse);
  const auto radius = hn::Mul(hn::Sqrt(hn::Max(crossed, hn::Zero(d))), inverse);
  const auto left = hn::NegMulAdd(from, tangent, radius);
  const auto reached = hn::Mul(radius, hn::MulAdd(radius, tangent, from));
  auto share = hn::Sub(hn::Div(reached, left), from);
  share = hn::IfThenElse(hn::Lt(hn::Zero(d), left), hn::Max(share, hn::Set(d, 1e-4f)), end);
  return hn::IfThenElse(turns, hn::Min(share, end), end);
}

/// base ^ power for a base of at least 0; whole powers, the usual ones, by squaring.
HWY_INLINE ShadeVector Power(ShadeVector base, float power)
{
  const ShadeFloat d;
  if (power == std::floor(power) && power >= 0.0f && power <= 1024.0f)
  {
    auto product = hn::Set(d, 1.0f);
    for (int left = static_cast<int>(power); left != 0; left >>= 1)
    {
      product = left & 1 ? hn::Mul(product, base) : product;
      base = hn::Mul(base, base);
    }
    return product;
  }
  const auto some = hn::Lt(hn::Set(d, 1e-30f), base);
  const auto logarithm = hn::Log(d, hn::Max(base, hn::Set(d, 1e-30f)));
  return hn::IfThenElseZero(some, hn::Exp(d, hn::Mul(hn::Set(d, power), logarithm)));
}

/// What a light's way makes of a piece: a + b share each.
struct LitSide
{
  /// Of gradient and way; of the way and that to the eye.
  ShadeVector Side, SideRise, Seen;
};

/// How light changes along a piece.
struct LitCourse
{
  /// |g|^2 = Squares[0] + 2 Squares[1] share + Squares[2] share^2.
  ShadeVector Squares[3];
  ShadeVector Seen, SeenRise;
  /// Where the piece begins, and where its ray goes.
  ShadeVector Point[3], Way[3];
  LitSide Sides[TileLighting::MaximumLights];
};

/// `Channels`: three, or one where all lights are grey.
template <int Channels>
struct LitColors
{
  ShadeVector Factor[Channels];
  ShadeVector Highlight[Channels];
};

class TileLightSource
{
public:
  TileLightSource(const TileLighting& lighting, const TileView& view, const TileRectangle& tile)
    : Lighting(lighting)
    , Rays(view, lighting.ScreenToLights, tile)
  {
    for (const TileLight& light : lighting.Lights)
    {
      this->WithPosition = this->WithPosition || light.IsPositional;
    }
  }

  /// The way from the rays of pixels to the eye, of length 1.
  HWY_INLINE void FindToEye(ShadeIndex pixel, ShadeVector (&out)[3]) const
  {
    this->Rays.FindToEye(pixel, out);
    const auto inverse = InverseRoot(Dot(out, out));
    for (auto& component : out)
    {
      component = hn::Mul(component, inverse);
    }
  }

  HWY_INLINE void Begin(const LitPieces& p, LitCourse& c) const
  {
    c.Squares[0] = Dot(p.Gradient, p.Gradient);
    c.Squares[1] = Dot(p.Gradient, p.GradientRise);
    c.Squares[2] = Dot(p.GradientRise, p.GradientRise);
    c.Seen = Dot(p.Gradient, p.ToEye);
    c.SeenRise = Dot(p.GradientRise, p.ToEye);
    if (this->WithPosition)
    {
      ShadeVector toEye[3];
      this->Rays.FindToEye(p.Pixel, toEye);
      this->Rays.FindOrigin(p.Pixel, c.Point);
      for (int k = 0; k < 3; ++k)
      {
        c.Point[k] = hn::NegMulAdd(p.Depth, toEye[k], c.Point[k]);
        c.Way[k] = hn::Neg(hn::Mul(p.DepthRise, toEye[k]));
      }
    }
    for (std::size_t i = 0; i < this->Lighting.Lights.size(); ++i)
    {
      this->BeginLight(this->Lighting.Lights[i], p, c, c.Sides[i]);
    }
  }

  /// The end of a piece up to which light is smooth enough for two Gauss nodes; `end` at most. Of a
  /// small optical `depth` little is seen.
  HWY_INLINE ShadeVector FindBend(const LitCourse& c, ShadeVector end, ShadeVector depth) const
  {
    const ShadeFloat d;
    const auto least = hn::Mul(hn::Set(d, LeastKink * LeastKink), c.Squares[0]);
    auto bend = this->FindTurn(c, end, depth);
    for (std::size_t i = 0; i < this->Lighting.Lights.size(); ++i)
    {
      // From one side of the gradient to the other.
      const LitSide& s = c.Sides[i];
      const auto last = hn::MulAdd(end, s.SideRise, s.Side);
      const auto kink = hn::Mul(hn::Sub(last, s.Side), depth);
      const auto changes = hn::And(hn::Lt(hn::Mul(s.Side, last), hn::Zero(d)),
        hn::Lt(least, hn::Mul(kink, kink)));
      if (!hn::AllFalse(d, changes))
      {
        const auto share = hn::Div(hn::Neg(s.Side), s.SideRise);
        bend = hn::IfThenElse(changes, Sooner(bend, share), bend);
      }
      bend = this->Lighting.HasGlance ? FindGlance(c, s, bend) : bend;
    }
    return bend;
  }

  template <int Channels>
  HWY_INLINE void Shine(
    const LitPieces& p, const LitCourse& c, ShadeVector share, LitColors<Channels>& out) const
  {
    const ShadeFloat d;
    const auto linear = hn::MulAdd(share, c.Squares[2], hn::Add(c.Squares[1], c.Squares[1]));
    const auto inverse = InverseRoot(hn::MulAdd(share, linear, c.Squares[0]));
    const auto seen = hn::Mul(hn::MulAdd(share, c.SeenRise, c.Seen), inverse);
    for (int k = 0; k < Channels; ++k)
    {
      out.Factor[k] = hn::Set(d, this->Lighting.Ambient[k]);
      out.Highlight[k] = hn::Zero(d);
    }
    for (std::size_t i = 0; i < this->Lighting.Lights.size(); ++i)
    {
      const TileLight& light = this->Lighting.Lights[i];
      const LitSide& s = c.Sides[i];
      if (light.IsPositional)
      {
        this->AddPosition(light, p, c, share, inverse, seen, out);
        continue;
      }
      const auto cosine = hn::Mul(hn::MulAdd(share, s.SideRise, s.Side), inverse);
      this->AddLight(light, cosine, seen, s.Seen, hn::Set(d, 1.0f), out);
    }
  }

  /// Whether it matters where a piece is.
  bool HasPosition() const { return this->WithPosition; }

private:
  HWY_INLINE void BeginLight(
    const TileLight& light, const LitPieces& p, const LitCourse& c, LitSide& s) const
  {
    const ShadeFloat d;
    ShadeVector way[3];
    for (int k = 0; k < 3; ++k)
    {
      way[k] = hn::Set(d, light.Place[k]);
    }
    if (light.IsPositional)
    {
      for (int k = 0; k < 3; ++k)
      {
        way[k] = hn::Sub(way[k], hn::MulAdd(hn::Set(d, 0.5f), c.Way[k], c.Point[k]));
      }
      const auto inverse = InverseRoot(Dot(way, way));
      for (auto& component : way)
      {
        component = hn::Mul(component, inverse);
      }
    }
    s.Side = Dot(p.Gradient, way);
    s.SideRise = Dot(p.GradientRise, way);
    s.Seen = Dot(p.ToEye, way);
  }

  /// Where the gradient has turned by the greatest angle.
  HWY_INLINE ShadeVector FindTurn(const LitCourse& c, ShadeVector end, ShadeVector depth) const
  {
    const auto greatest = LimitTurn(depth, this->Lighting.GreatestTurn, GreatestTurn);
    return TurnsUpTo(c.Squares, greatest, end);
  }

  /// Where the mirror image of a light passes from behind the eye before it.
  static HWY_INLINE ShadeVector FindGlance(const LitCourse& c, const LitSide& s, ShadeVector end)
  {
    const ShadeFloat d;
    const auto two = hn::Set(d, 2.0f);
    const auto constant =
      hn::MulSub(hn::Mul(two, s.Side), c.Seen, hn::Mul(s.Seen, c.Squares[0]));
    const auto product = hn::MulAdd(s.Side, c.SeenRise, hn::Mul(s.SideRise, c.Seen));
    const auto half = hn::NegMulAdd(s.Seen, c.Squares[1], product);
    const auto square =
      hn::MulSub(hn::Mul(two, s.SideRise), c.SeenRise, hn::Mul(s.Seen, c.Squares[2]));
    const auto inner = hn::MulSub(half, half, hn::Mul(constant, square));
    const auto some = hn::Le(hn::Zero(d), inner);
    const auto root = hn::CopySign(hn::Sqrt(hn::Max(inner, hn::Zero(d))), half);
    const auto q = hn::Neg(hn::Add(half, root));
    end = hn::IfThenElse(some, Sooner(end, hn::Div(q, square)), end);
    return hn::IfThenElse(some, Sooner(end, hn::Div(constant, q)), end);
  }

  template <int Channels>
  HWY_INLINE void AddPosition(const TileLight& light, const LitPieces& p, const LitCourse& c,
    ShadeVector share, ShadeVector inverse, ShadeVector seen, LitColors<Channels>& out) const
  {
    const ShadeFloat d;
    ShadeVector way[3], gradient[3];
    for (int k = 0; k < 3; ++k)
    {
      way[k] = hn::Sub(hn::Set(d, light.Place[k]), hn::MulAdd(share, c.Way[k], c.Point[k]));
      gradient[k] = hn::MulAdd(share, p.GradientRise[k], p.Gradient[k]);
    }
    const auto squared = Dot(way, way);
    const auto near = InverseRoot(squared);
    const auto cosine = hn::Mul(hn::Mul(Dot(gradient, way), near), inverse);
    const auto mirrored = hn::Mul(Dot(p.ToEye, way), near);
    const auto far = hn::Mul(squared, near);
    const auto faded = hn::MulAdd(hn::Set(d, light.Attenuation[2]), squared,
      hn::MulAdd(hn::Set(d, light.Attenuation[1]), far, hn::Set(d, light.Attenuation[0])));
    auto arriving = hn::Div(hn::Set(d, 1.0f), faded);
    if (light.HasCone)
    {
      const auto axis = hn::Neg(hn::Mul(Dot(way, light.Axis), near));
      const auto inside = hn::Le(hn::Set(d, light.ConeCosine), axis);
      const auto fall = Power(hn::Max(axis, hn::Zero(d)), light.Exponent);
      arriving = hn::IfThenElseZero(inside, hn::Mul(arriving, fall));
    }
    for (int k = 0; k < Channels; ++k)
    {
      out.Factor[k] = hn::MulAdd(arriving, hn::Set(d, light.Ambient[k]), out.Factor[k]);
    }
    this->AddLight(light, cosine, seen, mirrored, arriving, out);
  }

  /// `seen`, `toLight`: cosines of the angles to the eye of the gradient and of the light.
  template <int Channels>
  HWY_INLINE void AddLight(const TileLight& light, ShadeVector cosine, ShadeVector seen,
    ShadeVector toLight, ShadeVector arriving, LitColors<Channels>& out) const
  {
    const ShadeFloat d;
    const auto diffuse = hn::Mul(arriving, hn::Abs(cosine));
    for (int k = 0; k < Channels; ++k)
    {
      out.Factor[k] = hn::MulAdd(diffuse, hn::Set(d, light.Diffuse[k]), out.Factor[k]);
    }
    if (this->Lighting.HasHighlight)
    {
      const auto mirrored = hn::MulSub(hn::Add(cosine, cosine), seen, toLight);
      // Without a gradient nothing is mirrored.
      const auto some = hn::AndNot(hn::Eq(cosine, hn::Zero(d)), hn::Lt(hn::Zero(d), mirrored));
      const auto shine = Power(hn::IfThenElseZero(some, mirrored), this->Lighting.Power);
      const auto arrives = hn::IfThenElseZero(some, hn::Mul(arriving, shine));
      for (int k = 0; k < Channels; ++k)
      {
        out.Highlight[k] = hn::MulAdd(arrives, hn::Set(d, light.Specular[k]), out.Highlight[k]);
      }
    }
  }

  const TileLighting& Lighting;
  const TileRays Rays;
  bool WithPosition = false;
};
}
}
HWY_AFTER_NAMESPACE();

#endif
