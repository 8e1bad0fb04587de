/**
 * The emission of fragments, a full vector of any cells at a time.
 *
 * A fragment is cut where the transfer function bends; in a piece the emission is a quadratic
 * function of the scalar, whose mean is exact. The first piece of every fragment is shaded straight
 * through; what is left of those that are cut waits in a second queue and is shaded the same way.
 * Vectors that lie in one piece, most of them where the function is smooth, look nothing up.
 */
#if defined(EmissionShading_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef EmissionShading_inl_h
#undef EmissionShading_inl_h
#else
#define EmissionShading_inl_h
#endif

#include "EmissionTable.h"
#include "TileColors-inl.h"
#include "TileFragments.h"
#include "TilePacking-inl.h"
#include "TilePieces-inl.h"
#include "TileShading-inl.h"
#include "TileView.h"

#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Pieces about to be shaded, one per lane.
struct EmissionPieces
{
  ShadeVector First, Last, Length;
  ShadeIndex Piece, Fragment;
};

template <class LookUp>
class EmissionShader
{
public:
  EmissionShader(const EmissionTable& table, const TileView& view, const TileRectangle& tile)
    : Table(table)
    , Lengths(view, tile)
    , WeightScale(static_cast<float>(view.WeightScale))
    , WeightOffset(static_cast<float>(view.WeightOffset))
  {
  }

  /// Fills the colours; returns how many pieces there were.
  TileShadeCount Shade(TileFragments& fragments, TileRemainders (&remainders)[2]) const
  {
    return ShadeInPasses(
      fragments.Count, remainders, [&](TileRemainders& rest) { this->ShadeFirstPieces(fragments, rest); },
      [&](int, const TileRemainders& now, TileRemainders& next)
      { this->ShadeRemainders(fragments, now, next); });
  }

private:
  /// Goes over to the piece that a vector of courses lies in, if there is one.
  HWY_INLINE bool FindOnePiece(ShadeVector first, ShadeVector last, OnePieceLookUp& one) const
  {
    const ShadeFloat d;
    const auto least = hn::Min(first, last), greatest = hn::Max(first, last);
    const auto lies = [&]
    {
      // Not up to its end: at a step that is the next piece's.
      const float* const bounds = &this->Table.Bounds[static_cast<std::size_t>(one.Piece)];
      const auto above = hn::Le(hn::Set(d, bounds[0]), least);
      return hn::AllTrue(d, hn::And(above, hn::Lt(greatest, hn::Set(d, bounds[1]))));
    };
    if (lies())
    {
      return true;
    }
    one.Piece = FindPiece(this->Table, hn::GetLane(first));
    return lies();
  }

  template <class Values>
  HWY_INLINE void ShadePiece(const Values& values, const EmissionPieces& p, ShadeMask used,
    TileRemainders& rest, ShadeVector (&color)[4]) const
  {
    const ShadeFloat d;
    const EmissionTable& t = this->Table;
    const NodeCut node = FindNode(values, t, p.Piece, p.First, p.Last, used);
    auto end = p.Last, part = p.Length;
    if (node.IsAny)
    {
      end = hn::IfThenElse(node.IsCut, node.Bound, end);
      part = hn::Mul(part, node.Share);
      const auto beyond = PieceBeyond(p.Piece, p.First, p.Last);
      this->Append(
        node.IsCut, { end, p.Last, hn::Sub(p.Length, part), beyond, p.Fragment }, rest);
    }
    const auto origin = values(t.Origins.data(), p.Piece);
    const auto a = hn::Sub(p.First, origin), b = hn::Sub(end, origin);
    // Means of x and of x x between a and b.
    const auto mean = hn::Mul(hn::Set(d, 0.5f), hn::Add(a, b));
    const auto square =
      hn::Mul(hn::Set(d, 1.0f / 3.0f), hn::MulAdd(a, hn::Add(a, b), hn::Mul(b, b)));
    for (int k = 0; k < 3; ++k)
    {
      const auto value = hn::MulAdd(values(t.C2[k].data(), p.Piece), square,
        hn::MulAdd(values(t.C1[k].data(), p.Piece), mean, values(t.C0[k].data(), p.Piece)));
      color[k] = hn::Mul(part, value);
    }
    color[3] = hn::Zero(d);
  }

  HWY_INLINE void Append(ShadeMask which, const EmissionPieces& p, TileRemainders& rest) const
  {
    const ShadeFloat d;
    const ShadeInt di;
    const LanePacker<ShadeFloat> pack(d, which);
    const int at = rest.Count;
    hn::StoreU(pack(p.First), d, rest.First + at);
    hn::StoreU(pack(p.Last), d, rest.Last + at);
    hn::StoreU(pack(p.Length), d, rest.Length + at);
    hn::StoreU(pack(p.Piece), di, rest.Piece + at);
    hn::StoreU(pack(p.Fragment), di, rest.Fragment + at);
    rest.Count = at + static_cast<int>(hn::CountTrue(d, which));
  }

  void ShadeFirstPieces(TileFragments& q, TileRemainders& rest) const
  {
    const ShadeFloat d;
    const ShadeInt di;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const auto scale = hn::Set(d, this->WeightScale), offset = hn::Set(d, this->WeightOffset);
    q.FillLastVector();
    OnePieceLookUp one;
    for (int at = 0; at < q.Count; at += lanes)
    {
      const FragmentEnds ends(q, at, scale, offset);
      EmissionPieces p;
      p.Length = hn::Mul(ends.Depth(), this->Lengths.At(hn::Load(di, q.Pixel + at)));
      p.First = ends.First(q.ScalarIn + at);
      p.Last = ends.Last(q.ScalarOut + at);
      p.Fragment = Ramp(di, at);
      ShadeVector color[4];
      const auto used = hn::FirstN(d, static_cast<std::size_t>(q.Count - at));
      if (this->FindOnePiece(p.First, p.Last, one))
      {
        p.Piece = hn::Set(di, one.Piece);
        this->ShadePiece(one, p, used, rest, color);
      }
      else
      {
        p.Piece = PieceOf(this->Values, this->Table, p.First);
        this->ShadePiece(this->Values, p, used, rest, color);
      }
      StoreColors(color, at, q);
    }
  }

  void ShadeRemainders(TileFragments& q, const TileRemainders& now, TileRemainders& next) const
  {
    const ShadeFloat d;
    const ShadeInt di;
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (int at = 0; at < now.Count; at += lanes)
    {
      const int count = std::min(lanes, now.Count - at);
      const auto used = hn::FirstN(d, static_cast<std::size_t>(count));
      EmissionPieces p;
      p.First = hn::Load(d, now.First + at);
      p.Last = hn::Load(d, now.Last + at);
      p.Length = hn::Load(d, now.Length + at);
      // Beyond the count there is what was there before.
      const auto usedInt = hn::FirstN(di, static_cast<std::size_t>(count));
      p.Piece = hn::IfThenElseZero(usedInt, hn::Load(di, now.Piece + at));
      p.Fragment = hn::Load(di, now.Fragment + at);
      ShadeVector color[4];
      this->ShadePiece(this->Values, p, used, next, color);
      AddColors(color, now.Fragment + at, count, q);
    }
  }

  const LookUp Values{};
  const EmissionTable& Table;
  const RayLengths Lengths;
  const float WeightScale, WeightOffset;
};

/// Fills the colours of the queue; returns the number of pieces.
inline TileShadeCount ShadeEmission(const EmissionTable& table, const TileView& view,
  const TileRectangle& tile, TileFragments& fragments, TileRemainders (&remainders)[2])
{
  return WithLookUp(table, [&](auto values)
    { return EmissionShader<decltype(values)>(table, view, tile).Shade(fragments, remainders); });
}
}
}
HWY_AFTER_NAMESPACE();

#endif
