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
#include "TileFirstPieces-inl.h"
#include "TileGradientOpacity-inl.h"
#include "TileLight-inl.h"
#include "TileLitPieces-inl.h"
#include "TilePartColors-inl.h"
#include "TileThinLight-inl.h"
#include "TileWays-inl.h"

#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// A vector of pieces on its way through the steps.
struct LitWork
{
  LitPieces Piece;
  LitCourse Light;
  TileGradientOpacity::Course Opacity;
  LitPart Part;
  LitNodes Nodes;
  ShadeMask Used;
};

/// Look-ups come with each call: what does not need them, and what is shaded in one piece, is compiled once for all.
template <bool General>
class TileLitShader
{
public:
  TileLitShader(const TileTask& task, const TileRectangle& tile)
    : Task(task)
    , Tile(tile)
    , Transfer(*task.Transfer)
    , Light(*task.Lighting, *task.View, tile)
    , Opacity(*task.Lighting)
    , Colors(*task.Lighting)
    , Kind{ *task.Lighting }
    , FirstPieces(task, tile, Kind, Light)
    , PartColors(*task.Transfer, Kind, Light, Opacity, Colors)
  {
  }

  template <class LookUp>
  TileShadeCount Shade(const LookUp& values, TileFragments& fragments, TileLitPieces (&remainders)[2]) const
  {
    TileShadeCount more;
    TileShadeCount sum = ShadeInPasses(
      fragments.Count, remainders,
      [&](TileLitPieces& rest) { more = this->ShadeFirstPieces(values, fragments, rest, remainders[1]); },
      [&](int pass, const TileLitPieces& now, TileLitPieces& next)
      { this->ShadeRemainders(values, fragments, pass, now, next); });
    sum.Pieces += more.Pieces;
    sum.Lanes += more.Lanes;
    return sum;
  }

private:
  static constexpr int Batch = 4;

  template <class Look>
  HWY_INLINE ShadeVector ExtinctionAt(const Look& values, ShadeIndex piece, ShadeVector scalar) const
  {
    const auto value = ValueOf(values, this->Transfer, 3, piece, scalar);
    return hn::Max(value, hn::Zero(ShadeFloat()));
  }

  /// Cuts at the transfer function's node.
  template <class Look>
  HWY_INLINE void CutAtNode(const Look& values, const LitPieces& p, ShadeMask used, LitPart& part) const
  {
    const NodeCut node =
      FindNode(values, this->Transfer, p.Piece, p.First, p.Last, used);
    part.AtNode = part.Open = node.IsCut;
    part.End = node.Share;
    part.LastScalar = hn::IfThenElse(node.IsCut, node.Bound, p.Last);
    part.Front = this->ExtinctionAt(values, p.Piece, p.First);
    part.Back = this->ExtinctionAt(values, p.Piece, part.LastScalar);
  }

  /// Cuts where light, opacity or colour bend.
  template <class Look>
  HWY_INLINE void CutAtBend(const Look& values, const LitPieces& p, const LitCourse& light,
    const TileGradientOpacity::Course& opacity, ShadeMask used, LitPart& part) const
  {
    const ShadeFloat d;
    const auto node = part.End;
    const auto length = hn::Mul(hn::Mul(p.Length, node), hn::Set(d, 0.5f));
    const auto depth = hn::Mul(length, hn::Add(part.Front, part.Back));
    part.End = this->Kind.IsLit() ? this->Light.FindBend(light, part.End, depth) : part.End;
    part.End = this->Kind.HasOpacity() ? this->Opacity.FindBend(opacity, part.End) : part.End;
    part.End = this->Kind.HasColors() ? this->Colors.FindBend(p, part.End) : part.End;
    const auto bent = hn::Lt(part.End, node);
    if (!hn::AllFalse(d, bent))
    {
      part.AtNode = hn::AndNot(bent, part.AtNode);
      part.Open = hn::Or(part.AtNode, hn::And(bent, used));
      const auto last = hn::MulAdd(part.End, hn::Sub(p.Last, p.First), p.First);
      part.LastScalar = hn::IfThenElse(bent, last, part.LastScalar);
      part.Back = this->ExtinctionAt(values, p.Piece, part.LastScalar);
    }
  }

  /// Cuts where the optical depth would pass 1.
  template <class Look>
  HWY_INLINE void LimitDepth(const Look& values, const LitPieces& p, const TileGradientOpacity::Course& opacity,
    ShadeMask used, LitPart& part) const
  {
    const ShadeFloat d;
    part.Length = hn::Mul(p.Length, part.End);
    auto front = hn::Mul(part.Front, part.Length), back = hn::Mul(part.Back, part.Length);
    if (this->Kind.HasOpacity())
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
    part.Back = this->ExtinctionAt(values, p.Piece, part.LastScalar);
    const auto depth = hn::Mul(hn::Mul(half, part.Length), hn::Add(part.Front, part.Back));
    part.Depth = hn::Min(depth, hn::Set(d, 1.0f));
    part.AtNode = hn::AndNot(thick, part.AtNode);
    part.Open = hn::Or(part.Open, thick);
  }

  /// How light and opacity change along a piece, and its first part.
  template <class Look>
  HWY_INLINE void CutPiece(const Look& values, ShadeMask used, int pass, LitWork& w) const
  {
    if (this->Kind.IsLit())
    {
      this->Light.Begin(w.Piece, w.Light);
    }
    if (this->Kind.HasOpacity())
    {
      this->Opacity.Begin(w.Piece, w.Opacity);
    }
    this->CutAtNode(values, w.Piece, used, w.Part);
    if (pass < MostBends)
    {
      this->CutAtBend(values, w.Piece, w.Light, w.Opacity, used, w.Part);
    }
    this->LimitDepth(values, w.Piece, w.Opacity, used, w.Part);
  }

  /// Where in the part light is looked at.
  HWY_INLINE void FindNodes(LitWork& w) const
  {
    if (!this->Kind.HasOpacity())
    {
      w.Nodes.Find(w.Part);
    }
  }

  /// The part's colour; what is left behind it waits.
  template <class Look>
  HWY_INLINE void ColorPart(const Look& values, const LitWork& w, TileLitPieces& rest, ShadeVector (&color)[4]) const
  {
    const ShadeFloat d;
    if (this->Kind.HasOpacity())
    {
      this->PartColors.ShadeCurved(values, w.Piece, w.Light, w.Opacity, w.Part, color);
    }
    else
    {
      this->PartColors.ShadeLinear(values, w.Piece, w.Light, w.Part, w.Nodes, color);
    }
    if (!hn::AllFalse(d, w.Part.Open))
    {
      const auto through = hn::MulAdd(w.Piece.Through, color[3], w.Piece.Through);
      // What is nearly opaque hides the rest.
      const auto seen = hn::And(w.Part.Open, hn::Lt(hn::Set(d, 1e-7f), through));
      AppendPieces(seen, w.Piece, w.Part, through,
        { this->Light.HasPosition(), this->Kind.HasColors() }, rest);
    }
  }

  /// Where light allows it fragments are coloured at once but for those that wait as a whole, else by
  /// parts; returns how much more this shades than a piece of each fragment. `steep`: for those in between.
  template <class LookUp>
  TileShadeCount ShadeFirstPieces(
    const LookUp& values, TileFragments& q, TileLitPieces& rest, TileLitPieces& steep) const
  {
    const int lanes = static_cast<int>(hn::Lanes(ShadeFloat()));
    q.FillLastVector();
    if (!General && this->Task.Lighting->AllowsThin)
    {
      return ThinHeadlight::Suits(*this->Task.Lighting) ? this->ColorThin<ThinHeadlight>(values, q, rest, steep)
                                                        : this->ColorThin<ThinLights>(values, q, rest, steep);
    }
    for (int begin = 0; begin < q.Count; begin += Batch * lanes)
    {
      this->ShadeByParts(values, begin, std::min(Batch, (q.Count - begin + lanes - 1) / lanes), q, rest);
    }
    return {};
  }

  template <class Lights, class LookUp>
  HWY_NOINLINE TileShadeCount ColorThin(
    const LookUp& values, TileFragments& q, TileLitPieces& rest, TileLitPieces& steep) const
  {
    constexpr int lanes = static_cast<int>(hn::MaxLanes(ShadeFloat()));
    ThinLight<Lights> thin(this->Task, this->Tile);
    steep.Count = 0;
    for (int at = 0; at < q.Count; at += ThinLight<Lights>::Batch * lanes)
    {
      thin.Color(values, at, q, rest, steep);
    }
    TileShadeCount more;
    thin.ColorSteep(values, q, steep, more);
    // They were counted with all others.
    more.Pieces -= rest.Count;
    return more;
  }

  /// Shades the first parts of `count` vectors from `begin` on.
  template <class LookUp>
  void ShadeByParts(const LookUp& values, int begin, int count, TileFragments& q, TileLitPieces& rest) const
  {
    const ShadeFloat d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    LitWork work[Batch];
    for (int i = 0; i < count; ++i)
    {
      const int at = begin + i * lanes;
      this->FirstPieces.Find(q, at, work[i].Piece);
      work[i].Used = hn::FirstN(d, static_cast<std::size_t>(q.Count - at));
    }
    OnePieceLookUp one;
    this->FindOnePiece(work, count, one) ? this->ShadeFirstParts(one, begin, count, work, q, rest)
                                         : this->ShadeFirstParts(values, begin, count, work, q, rest);
  }

  template <class Look>
  HWY_NOINLINE void ShadeFirstParts(const Look& values, int begin, int count, LitWork (&work)[Batch],
    TileFragments& q, TileLitPieces& rest) const
  {
    const int lanes = static_cast<int>(hn::Lanes(ShadeFloat()));
    for (int i = 0; i < count; ++i)
    {
      work[i].Piece.Piece = PieceOf(values, this->Transfer, work[i].Piece.First);
    }
    this->ShadeInSteps(values, 0, count, work, rest,
      [&](int i, const ShadeVector(&color)[4]) { StoreColors(color, begin + i * lanes, q); });
  }

  /// The piece that all of `count` vectors lie in, if there is one.
  HWY_INLINE bool FindOnePiece(const LitWork* work, int count, OnePieceLookUp& one) const
  {
    auto least = work[0].Piece.First, greatest = least;
    for (int i = 0; i < count; ++i)
    {
      const LitPieces& p = work[i].Piece;
      least = hn::Min(least, hn::Min(p.First, p.Last));
      greatest = hn::Max(greatest, hn::Max(p.First, p.Last));
    }
    return one.Take(this->Transfer, least, greatest);
  }

  /// Step after step for all vectors: within one the steps wait for each other.
  template <class Look, class Store>
  HWY_INLINE void ShadeInSteps(const Look& values, int pass, int count, LitWork (&work)[Batch],
    TileLitPieces& rest, const Store& store) const
  {
    for (int i = 0; i < count; ++i)
    {
      this->CutPiece(values, work[i].Used, pass, work[i]);
    }
    for (int i = 0; i < count; ++i)
    {
      this->FindNodes(work[i]);
    }
    for (int i = 0; i < count; ++i)
    {
      ShadeVector color[4];
      this->ColorPart(values, work[i], rest, color);
      store(i, color);
    }
  }

  template <class LookUp>
  void ShadeRemainders(const LookUp& values, TileFragments& q, int pass, const TileLitPieces& now,
    TileLitPieces& next) const
  {
    const ShadeFloat d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    LitWork work[Batch];
    for (int begin = 0; begin < now.Count; begin += Batch * lanes)
    {
      const int count = std::min(Batch, (now.Count - begin + lanes - 1) / lanes);
      for (int i = 0; i < count; ++i)
      {
        const int at = begin + i * lanes;
        LitPieces& piece = work[i].Piece;
        LoadPieces(now, at, now.Count, { this->Light.HasPosition(), this->Kind.HasColors() }, piece);
        this->Light.FindToEye(piece.Pixel, piece.ToEye);
        work[i].Used = hn::FirstN(d, static_cast<std::size_t>(now.Count - at));
      }
      this->ShadeInSteps(values, pass, count, work, next,
        [&](int i, ShadeVector(&color)[4])
        {
          const int at = begin + i * lanes;
          for (auto& component : color)
          {
            component = hn::Mul(component, work[i].Piece.Through);
          }
          AddColors(color, now.Fragment + at, std::min(lanes, now.Count - at), q);
        });
    }
  }

  const TileTask& Task;
  const TileRectangle& Tile;
  const TileTransfer& Transfer;
  const TileLightSource Light;
  const TileGradientOpacity Opacity;
  const TileComponentColors Colors;
  const LitKind<General> Kind;
  const TileFirstPieces<General> FirstPieces;
  const TilePartColors<General> PartColors;
};
}
}
HWY_AFTER_NAMESPACE();

#endif
