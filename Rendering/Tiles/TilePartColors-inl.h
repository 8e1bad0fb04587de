/**
 * The colours of parts of lit pieces: see TileLitShading.h.
 */
#if defined(TilePartColors_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TilePartColors_inl_h
#undef TilePartColors_inl_h
#else
#define TilePartColors_inl_h
#endif

#include "TileGradientOpacity-inl.h"
#include "TileLight-inl.h"
#include "TileLitPieces-inl.h"
#include "TileWays-inl.h"

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// What there is to shade. `General`: with gradient opacity, other components, or without light.
template <bool General>
struct LitKind
{
  const TileLighting& Lighting;

  bool HasOpacity() const { return General && this->Lighting.HasOpacity; }
  bool HasColors() const
  {
    return General && this->Lighting.ColorKind != TileLighting::OwnColor;
  }
  bool IsLit() const { return !General || this->Lighting.IsLit; }
  /// Whether one channel of light stands for all, and the scalar has the colour.
  bool IsGrey() const { return !General && this->Lighting.IsGrey; }
};

/// Sums over a part of grey light's weights: times the scalar's rise, alone, and of highlights.
struct GreySum
{
  ShadeVector Scalar, Factor, Highlight;
};

/// The colours of a piece's part: they are linear in the scalar, and follow from the sums.
template <class LookUp>
HWY_INLINE void ColorGrey(const LookUp& values, const TileTransfer& transfer, const LitPieces& p, const GreySum& sum,
  ShadeVector (&color)[4])
{
  for (int k = 0; k < 3; ++k)
  {
    const auto slope = values(transfer.Slopes[k].data(), p.Piece);
    const auto first = hn::MulAdd(slope, p.First, values(transfer.Offsets[k].data(), p.Piece));
    color[k] = hn::MulAdd(slope, sum.Scalar, hn::MulAdd(first, sum.Factor, sum.Highlight));
  }
}

/// Two places along a part of a piece, and the shares of its alpha that stand for them.
struct LitNodes
{
  ShadeVector Alpha, First, Second, Before, Behind;

  /// Of extinction that is linear: alpha is exact, and the two nodes are Gauss nodes of the light
  /// absorbed: sum, mean, mean square and nearly mean cube of its places, from -1 to 1.
  HWY_INLINE void Find(const LitPart& part)
  {
    const ShadeFloat d;
    this->Alpha = Absorption(d, part.Depth);
    const auto total = hn::Add(hn::Add(part.Front, part.Back), hn::Set(d, 1e-30f));
    const auto lean = hn::Mul(hn::Sub(part.Back, part.Front), Reciprocal(d, total));
    const auto one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
    const auto place = AbsorptionMean(d, part.Depth, lean);
    const auto mean = hn::Sub(hn::Add(place, place), one);
    // To second order in the optical depth.
    const auto bend = hn::MulAdd(
      lean, hn::Set(d, -1.0f / 15.0f), hn::Mul(part.Depth, hn::Set(d, 1.0f / 90.0f)));
    const auto square = hn::MulAdd(part.Depth, bend, hn::Set(d, 1.0f / 3.0f));
    // Exact where extinction is constant or rises from zero, and nothing is hidden.
    const auto shift = hn::MulAdd(hn::Mul(mean, mean), hn::Set(d, 1.8f), hn::Set(d, 0.4f));
    const auto middle = hn::Mul(mean, shift);
    const auto variance = hn::MulAdd(middle, hn::Sub(middle, hn::Add(mean, mean)), square);
    const auto inverse = InverseRoot(variance);
    const auto apart = hn::Mul(hn::Mul(variance, inverse), half);
    this->Behind =
      hn::Mul(hn::Mul(this->Alpha, half), hn::MulAdd(hn::Sub(mean, middle), inverse, one));
    this->Before = hn::Sub(this->Alpha, this->Behind);
    const auto center = hn::MulAdd(middle, half, half);
    this->First = hn::Sub(center, apart);
    this->Second = hn::Add(center, apart);
  }
};

template <bool General>
class TilePartColors
{
public:
  TilePartColors(const TileTransfer& transfer, const LitKind<General>& kind,
    const TileLightSource& light, const TileGradientOpacity& opacity,
    const TileComponentColors& colors)
    : Transfer(transfer)
    , Kind(kind)
    , Light(light)
    , Opacity(opacity)
    , Colors(colors)
  {
  }

  /// The colour of a part whose extinction is linear.
  template <class LookUp>
  HWY_INLINE void ShadeLinear(const LookUp& values, const LitPieces& p, const LitCourse& light, const LitPart& part,
    const LitNodes& nodes, ShadeVector (&color)[4]) const
  {
    const ShadeFloat d;
    if (this->Kind.IsGrey())
    {
      GreySum sum{ hn::Zero(d), hn::Zero(d), hn::Zero(d) };
      this->AddGrey(p, light, part, nodes.First, nodes.Before, sum);
      this->AddGrey(p, light, part, nodes.Second, nodes.Behind, sum);
      ColorGrey(values, this->Transfer, p, sum, color);
    }
    else
    {
      color[0] = color[1] = color[2] = hn::Zero(d);
      this->AddColor(values, p, light, part, nodes.First, nodes.Before, color);
      this->AddColor(values, p, light, part, nodes.Second, nodes.Behind, color);
    }
    color[3] = hn::Neg(nodes.Alpha);
  }

  /// Of any extinction: three nodes for the optical depth, too.
  template <class LookUp>
  HWY_INLINE void ShadeCurved(const LookUp& values, const LitPieces& p, const LitCourse& light,
    const TileGradientOpacity::Course& opacity, const LitPart& part, ShadeVector (&color)[4]) const
  {
    const ShadeFloat d;
    ShadeVector depth[3], absorbed[3];
    auto whole = hn::Zero(d), total = hn::Set(d, 1e-30f);
    for (int i = 0; i < 3; ++i)
    {
      const auto at = hn::Set(d, GaussNodes::Places[i]);
      const auto extinction = hn::MulAdd(at, hn::Sub(part.Back, part.Front), part.Front);
      const auto opened = this->Opacity.At(opacity, hn::Mul(part.End, at));
      depth[i] = hn::Mul(hn::Mul(extinction, part.Length), opened);
      whole = hn::MulAdd(hn::Set(d, GaussNodes::Weights[i]), depth[i], whole);
    }
    for (int i = 0; i < 3; ++i)
    {
      const auto before = hn::MulAdd(hn::Set(d, GaussNodes::Running[i][0]), depth[0],
        hn::MulAdd(hn::Set(d, GaussNodes::Running[i][1]), depth[1],
          hn::Mul(hn::Set(d, GaussNodes::Running[i][2]), depth[2])));
      const auto weight = hn::Mul(hn::Set(d, GaussNodes::Weights[i]), depth[i]);
      absorbed[i] = hn::Mul(weight, hn::Exp(d, hn::Neg(before)));
      total = hn::Add(total, absorbed[i]);
    }
    const auto one = hn::Set(d, 1.0f);
    const auto deep = hn::Sub(one, hn::Exp(d, hn::Neg(whole)));
    const auto alpha = hn::IfThenElse(hn::Lt(whole, one), Absorption(d, whole), deep);
    const auto scale = hn::Div(alpha, total);
    color[0] = color[1] = color[2] = hn::Zero(d);
    for (int i = 0; i < 3; ++i)
    {
      this->AddColor(values,
        p, light, part, hn::Set(d, GaussNodes::Places[i]), hn::Mul(absorbed[i], scale), color);
    }
    color[3] = hn::Neg(alpha);
  }

private:
  /// The colour at a share of a piece, times `weight`, added to a sum.
  template <class LookUp>
  HWY_INLINE void AddColor(const LookUp& values, const LitPieces& p, const LitCourse& light, const LitPart& part,
    ShadeVector at, ShadeVector weight, ShadeVector (&sum)[4]) const
  {
    const auto share = hn::Mul(part.End, at);
    ShadeVector color[3];
    if (this->Kind.HasColors())
    {
      this->Colors.At(p, share, color);
    }
    else
    {
      const auto scalar = hn::MulAdd(at, hn::Sub(part.LastScalar, p.First), p.First);
      for (int k = 0; k < 3; ++k)
      {
        color[k] = ValueOf(values, this->Transfer, k, p.Piece, scalar);
      }
    }
    LitColors<3> lit;
    if (this->Kind.IsLit())
    {
      this->Light.Shine(p, light, share, lit);
    }
    for (int k = 0; k < 3; ++k)
    {
      const auto shaded =
        this->Kind.IsLit() ? hn::MulAdd(color[k], lit.Factor[k], lit.Highlight[k]) : color[k];
      sum[k] = hn::MulAdd(weight, shaded, sum[k]);
    }
  }

  /// The same of grey light: colours are linear in the scalar, and follow from the sums.
  HWY_INLINE void AddGrey(const LitPieces& p, const LitCourse& light, const LitPart& part,
    ShadeVector at, ShadeVector weight, GreySum& sum) const
  {
    // From the first one: of a steep function the offset alone would leave little of a float.
    const auto scalar = hn::Mul(at, hn::Sub(part.LastScalar, p.First));
    LitColors<1> lit;
    this->Light.Shine(p, light, hn::Mul(part.End, at), lit);
    const auto factor = hn::Mul(weight, lit.Factor[0]);
    sum.Scalar = hn::MulAdd(factor, scalar, sum.Scalar);
    sum.Factor = hn::Add(sum.Factor, factor);
    sum.Highlight = hn::MulAdd(weight, lit.Highlight[0], sum.Highlight);
  }

  const TileTransfer& Transfer;
  const LitKind<General>& Kind;
  const TileLightSource& Light;
  const TileGradientOpacity& Opacity;
  const TileComponentColors& Colors;
};
}
}
HWY_AFTER_NAMESPACE();

#endif
