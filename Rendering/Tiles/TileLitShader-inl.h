/**
 * The shading of lit fragments: see TileLitShading.h.
 */
#if defined(TileLitShader_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileLitShader_inl_h
#undef TileLitShader_inl_h
#else
#define TileLitShader_inl_h
#endif

#include "TileColors-inl.h"
#include "TileGradientOpacity-inl.h"
#include "TileLight-inl.h"
#include "TileLitPieces-inl.h"
#include "TileWays-inl.h"

#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

// As many cuts of a fragment are for light and gradient opacity.
constexpr int MostBends = 256;

/// `General`: with gradient opacity, other components, or without light.
template <class LookUp, bool General>
class TileLitShader
{
public:
  TileLitShader(const TileTask& task, const TileRectangle& tile)
    : Task(task)
    , Transfer(*task.Transfer)
    , Lighting(*task.Lighting)
    , Lengths(*task.View, tile)
    , Rays(*task.View, task.Lighting->ScreenToMesh, tile)
    , Light(*task.Lighting, *task.View, tile)
    , Opacity(*task.Lighting)
    , Colors(*task.Lighting)
  {
  }

  long long Shade(TileFragments& fragments, TileLitPieces (&remainders)[2]) const
  {
    return ShadeInPasses(
      fragments.Count, remainders, [&](TileLitPieces& rest) { this->ShadeFirstPieces(fragments, rest); },
      [&](int pass, const TileLitPieces& now, TileLitPieces& next)
      { this->ShadeRemainders(fragments, pass, now, next); });
  }

private:
  bool HasOpacity() const { return General && this->Lighting.HasOpacity; }
  bool HasColors() const
  {
    return General && this->Lighting.ColorKind != TileLighting::OwnColor;
  }
  bool IsLit() const { return !General || this->Lighting.IsLit; }

  HWY_INLINE ShadeVector ExtinctionAt(ShadeIndex piece, ShadeVector scalar) const
  {
    const auto value = ValueOf(this->Values, this->Transfer, 3, piece, scalar);
    return hn::Max(value, hn::Zero(ShadeFloat()));
  }

  /// Cuts at the transfer function's node and where light, opacity or colour bend.
  HWY_INLINE void FindEnd(const LitPieces& p, const LitCourse& light,
    const TileGradientOpacity::Course& opacity, bool bends, ShadeMask used, LitPart& part) const
  {
    const ShadeFloat d;
    const ShadeInt di;
    const auto rise = hn::Sub(p.Last, p.First);
    const auto rising = hn::RebindMask(di, hn::Lt(hn::Zero(d), rise));
    const auto one = hn::IfThenElseZero(rising, hn::Set(di, 1));
    const auto bound = this->Values(this->Transfer.Bounds.data(), hn::Add(p.Piece, one));
    part.AtNode = hn::And(hn::Lt(hn::Mul(hn::Sub(bound, p.Last), rise), hn::Zero(d)), used);
    const auto whole = hn::Set(d, 1.0f);
    part.End = whole;
    if (!hn::AllFalse(d, part.AtNode))
    {
      const auto share = hn::Div(hn::Sub(bound, p.First), rise);
      part.End = hn::IfThenElse(part.AtNode, hn::Min(share, whole), whole);
    }
    const auto node = part.End;
    part.LastScalar = hn::IfThenElse(part.AtNode, bound, p.Last);
    part.Front = this->ExtinctionAt(p.Piece, p.First);
    part.Back = this->ExtinctionAt(p.Piece, part.LastScalar);
    if (bends)
    {
      const auto length = hn::Mul(hn::Mul(p.Length, part.End), hn::Set(d, 0.5f));
      const auto depth = hn::Mul(length, hn::Add(part.Front, part.Back));
      part.End = this->IsLit() ? this->Light.FindBend(light, part.End, depth) : part.End;
      part.End = this->HasOpacity() ? this->Opacity.FindBend(opacity, part.End) : part.End;
      part.End = this->HasColors() ? this->Colors.FindBend(p, part.End) : part.End;
    }
    const auto bent = hn::Lt(part.End, node);
    part.AtNode = hn::AndNot(bent, part.AtNode);
    part.Open = hn::Or(part.AtNode, hn::And(bent, used));
    if (!hn::AllFalse(d, bent))
    {
      const auto last = hn::MulAdd(part.End, rise, p.First);
      part.LastScalar = hn::IfThenElse(bent, last, part.LastScalar);
      part.Back = this->ExtinctionAt(p.Piece, part.LastScalar);
    }
  }

  /// Cuts where the optical depth would pass 1.
  HWY_INLINE void LimitDepth(const LitPieces& p, const TileGradientOpacity::Course& opacity,
    ShadeMask used, LitPart& part) const
  {
    const ShadeFloat d;
    part.Length = hn::Mul(p.Length, part.End);
    auto front = hn::Mul(part.Front, part.Length), back = hn::Mul(part.Back, part.Length);
    if (this->HasOpacity())
    {
      // Beside the ends: at a step of the gradient opacity they are on either side.
      const auto begin = hn::Mul(part.End, hn::Set(d, 0.02f));
      front = hn::Mul(front, this->Opacity.At(opacity, begin));
      back = hn::Mul(back, this->Opacity.At(opacity, hn::Sub(part.End, begin)));
    }
    const auto half = hn::Set(d, 0.5f);
    part.Depth = hn::Mul(half, hn::Add(front, back));
    const auto thick = hn::And(hn::Lt(hn::Set(d, 1.0f), part.Depth), used);
    if (hn::AllFalse(d, thick))
    {
      return;
    }
    const auto rise = hn::Sub(back, front);
    const auto inner = hn::Max(hn::MulAdd(front, front, hn::Add(rise, rise)), hn::Zero(d));
    auto share = hn::Div(hn::Set(d, 2.0f), hn::Add(front, hn::Sqrt(inner)));
    share = hn::Min(share, hn::Set(d, 1.0f));
    share = hn::IfThenElse(thick, share, hn::Set(d, 1.0f));
    part.LastScalar = hn::IfThenElse(
      thick, hn::MulAdd(share, hn::Sub(part.LastScalar, p.First), p.First), part.LastScalar);
    part.End = hn::Mul(part.End, share);
    part.Length = hn::Mul(part.Length, share);
    part.Back = this->ExtinctionAt(p.Piece, part.LastScalar);
    const auto depth = hn::Mul(hn::Mul(half, part.Length), hn::Add(part.Front, part.Back));
    part.Depth = hn::Min(depth, hn::Set(d, 1.0f));
    part.AtNode = hn::AndNot(thick, part.AtNode);
    part.Open = hn::Or(part.Open, thick);
  }

  /// The colour at a share of a piece, times `weight`, added to a sum.
  HWY_INLINE void AddColor(const LitPieces& p, const LitCourse& light, const LitPart& part,
    ShadeVector at, ShadeVector weight, ShadeVector (&sum)[4]) const
  {
    const auto share = hn::Mul(part.End, at);
    ShadeVector color[3];
    if (this->HasColors())
    {
      this->Colors.At(p, share, color);
    }
    else
    {
      const auto scalar = hn::MulAdd(at, hn::Sub(part.LastScalar, p.First), p.First);
      for (int k = 0; k < 3; ++k)
      {
        color[k] = ValueOf(this->Values, this->Transfer, k, p.Piece, scalar);
      }
    }
    LitColors lit;
    if (this->IsLit())
    {
      this->Light.Shine(p, light, share, lit);
    }
    for (int k = 0; k < 3; ++k)
    {
      const auto shaded =
        this->IsLit() ? hn::MulAdd(color[k], lit.Factor[k], lit.Highlight[k]) : color[k];
      sum[k] = hn::MulAdd(weight, shaded, sum[k]);
    }
  }

  /// Of extinction that is linear: alpha is exact, and the two nodes are Gauss nodes of the light
  /// absorbed: sum, mean, mean square and nearly mean cube of its places, from -1 to 1.
  HWY_INLINE void ShadeLinear(const LitPieces& p, const LitCourse& light, const LitPart& part,
    ShadeVector (&color)[4]) const
  {
    const ShadeFloat d;
    const auto alpha = Absorption(d, part.Depth);
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
    const auto behind =
      hn::Mul(hn::Mul(alpha, half), hn::MulAdd(hn::Sub(mean, middle), inverse, one));
    const auto center = hn::MulAdd(middle, half, half);
    color[0] = color[1] = color[2] = hn::Zero(d);
    this->AddColor(p, light, part, hn::Sub(center, apart), hn::Sub(alpha, behind), color);
    this->AddColor(p, light, part, hn::Add(center, apart), behind, color);
    color[3] = hn::Neg(alpha);
  }

  /// Of any extinction: three nodes for the optical depth, too.
  HWY_INLINE void ShadeCurved(const LitPieces& p, const LitCourse& light,
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
      this->AddColor(
        p, light, part, hn::Set(d, GaussNodes::Places[i]), hn::Mul(absorbed[i], scale), color);
    }
    color[3] = hn::Neg(alpha);
  }

  HWY_INLINE void ShadePiece(const LitPieces& p, ShadeMask used, int pass, TileLitPieces& rest,
    ShadeVector (&color)[4]) const
  {
    const ShadeFloat d;
    LitCourse light;
    TileGradientOpacity::Course opacity;
    if (this->IsLit())
    {
      this->Light.Begin(p, light);
    }
    if (this->HasOpacity())
    {
      this->Opacity.Begin(p, opacity);
    }
    LitPart part;
    this->FindEnd(p, light, opacity, pass < MostBends, used, part);
    this->LimitDepth(p, opacity, used, part);
    if (this->HasOpacity())
    {
      this->ShadeCurved(p, light, opacity, part, color);
    }
    else
    {
      this->ShadeLinear(p, light, part, color);
    }
    if (!hn::AllFalse(d, part.Open))
    {
      const auto through = hn::MulAdd(p.Through, color[3], p.Through);
      // What is nearly opaque hides the rest.
      const auto seen = hn::And(part.Open, hn::Lt(hn::Set(d, 1e-7f), through));
      AppendPieces(
        seen, p, part, through, { this->Light.HasPosition(), this->HasColors() }, rest);
    }
  }

  /// Gradient and components at the beginning, and their rise.
  HWY_INLINE void SetFields(const int* cells, int used, LitPieces& p) const
  {
    const ShadeFloat d;
    ShadeVector point[3], way[3], toEye[3];
    this->Rays.FindOrigin(p.Pixel, point);
    this->Rays.FindToEye(p.Pixel, toEye);
    for (int k = 0; k < 3; ++k)
    {
      point[k] = hn::NegMulAdd(p.Depth, toEye[k], point[k]);
      way[k] = hn::Neg(hn::Mul(p.DepthRise, toEye[k]));
      p.Gradient[k] = p.GradientRise[k] = p.Color[k] = p.ColorRise[k] = hn::Zero(d);
    }
    FieldRows rows;
    if (this->IsLit() || this->HasOpacity())
    {
      rows.Load(*this->Task.Gradients, cells, used);
      rows.At(point, way, p.Gradient, p.GradientRise);
    }
    if (this->Lighting.IsInView)
    {
      Turn(this->Lighting.GradientToView, p.Gradient);
      Turn(this->Lighting.GradientToView, p.GradientRise);
    }
    if (this->HasColors())
    {
      rows.Load(*this->Task.Colors, cells, used);
      rows.At(point, way, p.Color, p.ColorRise);
    }
  }

  void ShadeFirstPieces(TileFragments& q, TileLitPieces& rest) const
  {
    const ShadeFloat d;
    const ShadeInt di;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const auto scale = hn::Set(d, static_cast<float>(this->Task.View->WeightScale));
    const auto offset = hn::Set(d, static_cast<float>(this->Task.View->WeightOffset));
    const auto perWeight = hn::Set(d, static_cast<float>(-1.0 / this->Task.View->WeightOffset));
    for (int at = 0; at < q.Count; at += lanes)
    {
      const FragmentEnds ends(q, at, scale, offset);
      LitPieces p;
      p.Pixel = hn::Load(di, q.Pixel + at);
      p.DepthRise = ends.Depth;
      p.Depth =
        hn::Mul(hn::Mul(ends.Entry, perWeight), hn::Mul(ends.WeightOut, ends.Inverse));
      p.Length = hn::Mul(p.DepthRise, this->Lengths.At(p.Pixel));
      p.First = ends.First;
      p.Last = ends.Last;
      p.Through = hn::Set(d, 1.0f);
      p.Piece = PieceOf(this->Values, this->Transfer, p.First);
      p.Fragment = Ramp(di, at);
      this->SetFields(q.Cell + at, std::min(lanes, q.Count - at), p);
      ShadeVector color[4];
      const auto used = hn::FirstN(d, static_cast<std::size_t>(q.Count - at));
      this->ShadePiece(p, used, 0, rest, color);
      StoreColors(color, at, q);
    }
  }

  void ShadeRemainders(
    TileFragments& q, int pass, const TileLitPieces& now, TileLitPieces& next) const
  {
    const ShadeFloat d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (int at = 0; at < now.Count; at += lanes)
    {
      const int count = std::min(lanes, now.Count - at);
      LitPieces p;
      LoadPieces(now, at, { this->Light.HasPosition(), this->HasColors() }, p);
      ShadeVector color[4];
      this->ShadePiece(p, hn::FirstN(d, static_cast<std::size_t>(count)), pass, next, color);
      for (auto& component : color)
      {
        component = hn::Mul(component, p.Through);
      }
      AddColors(color, now.Fragment + at, count, q);
    }
  }

  const LookUp Values{};
  const TileTask& Task;
  const TileTransfer& Transfer;
  const TileLighting& Lighting;
  const RayLengths Lengths;
  const TileRays Rays;
  const TileLightSource Light;
  const TileGradientOpacity Opacity;
  const TileComponentColors Colors;
};
}
}
HWY_AFTER_NAMESPACE();

#endif
