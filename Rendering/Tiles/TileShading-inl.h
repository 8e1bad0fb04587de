/**
 * Colour and opacity of fragments, a full vector of any cells at a time.
 *
 * A fragment is cut where the transfer function bends and where the optical depth of a piece would
 * pass 1. In a piece extinction and colour are linear in the scalar, so alpha = 1 - exp(-depth) is
 * exact, and so is colour = alpha * (colour at the mean place of the absorbed light). The first
 * piece of every fragment is shaded straight through; what is left of those that are cut waits in a
 * second queue and is shaded the same way.
 */
#if defined(TileShading_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileShading_inl_h
#undef TileShading_inl_h
#else
#define TileShading_inl_h
#endif

#include "TileColors-inl.h"
#include "TileFragments.h"
#include "TileMath-inl.h"
#include "TilePieces-inl.h"
#include "TileTask.h"
#include "TileTransfer.h"
#include "TileView.h"

#include <glm/geometric.hpp>
#include <hwy/highway.h>

#include <algorithm>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Table look-ups in registers, for a function of no more pieces than a vector has lanes.
struct RegisterLookUp
{
  HWY_INLINE ShadeVector operator()(const float* table, ShadeIndex index) const
  {
    const ShadeFloat d;
    return hn::TableLookupLanes(hn::LoadU(d, table), hn::IndicesFromVec(d, index));
  }
};

/// The same in memory, for any function.
struct MemoryLookUp
{
  HWY_INLINE ShadeVector operator()(const float* table, ShadeIndex index) const
  {
    return hn::GatherIndex(ShadeFloat(), table, index);
  }
};

/// World length of a ray per depth at the pixels of a tile.
class RayLengths
{
public:
  RayLengths(const TileView& view, const TileRectangle& tile)
  {
    const glm::dvec3 first =
      view.Ray[0] + double(tile.Left) * view.Ray[1] + double(tile.Bottom) * view.Ray[2];
    this->Terms[0] = static_cast<float>(glm::dot(first, first));
    this->Terms[1] = static_cast<float>(2.0 * glm::dot(first, view.Ray[1]));
    this->Terms[2] = static_cast<float>(2.0 * glm::dot(first, view.Ray[2]));
    this->Terms[3] = static_cast<float>(glm::dot(view.Ray[1], view.Ray[1]));
    this->Terms[4] = static_cast<float>(2.0 * glm::dot(view.Ray[1], view.Ray[2]));
    this->Terms[5] = static_cast<float>(glm::dot(view.Ray[2], view.Ray[2]));
  }

  HWY_INLINE ShadeVector At(ShadeIndex pixel) const
  {
    const ShadeFloat d;
    const ShadeInt di;
    const auto y = hn::ConvertTo(d, hn::ShiftRight<TileSize::Shift>(pixel));
    const auto x = hn::ConvertTo(d, hn::And(pixel, hn::Set(di, TileSize::Pixels - 1)));
    const auto perX = hn::MulAdd(this->Term(3), x, hn::MulAdd(this->Term(4), y, this->Term(1)));
    const auto perY = hn::MulAdd(this->Term(5), y, this->Term(2));
    return hn::Sqrt(hn::MulAdd(perX, x, hn::MulAdd(perY, y, this->Term(0))));
  }

private:
  HWY_INLINE ShadeVector Term(int i) const { return hn::Set(ShadeFloat(), this->Terms[i]); }
  float Terms[6];
};

/// Pieces about to be shaded, one per lane.
struct ShadePieces
{
  ShadeVector First, Last, Length, Through;
  ShadeIndex Piece, Fragment;
};

template <class LookUp>
class TileShader
{
public:
  TileShader(const TileTask& task, const TileRectangle& tile)
    : Transfer(*task.Transfer)
    , Lengths(*task.View, tile)
    , WeightScale(static_cast<float>(task.View->WeightScale))
    , WeightOffset(static_cast<float>(task.View->WeightOffset))
  {
  }

  /// Fills the colours; returns how many pieces there were.
  long long Shade(TileFragments& fragments, TileRemainders (&remainders)[2]) const
  {
    return ShadeInPasses(
      fragments.Count, remainders,
      [&](TileRemainders& rest)
      {
        this->FindFirstPieces(fragments, remainders[1]);
        this->ShadeFirstPieces(remainders[1], fragments, rest);
      },
      [&](int, const TileRemainders& now, TileRemainders& next)
      { this->ShadeRemainders(fragments, now, next); });
  }

private:
  /// The share of a piece after which its optical depth reaches 1.
  HWY_INLINE ShadeVector ShareOfDepthOne(
    ShadeVector front, ShadeVector back, ShadeVector length) const
  {
    const ShadeFloat d;
    const auto depth = hn::Mul(front, length);
    const auto rise = hn::Mul(hn::Sub(back, front), length);
    const auto root = hn::MulAdd(depth, depth, hn::Add(rise, rise));
    const auto sum = hn::Add(depth, hn::Sqrt(hn::Max(root, hn::Zero(d))));
    return hn::Min(hn::Div(hn::Set(d, 2.0f), sum), hn::Set(d, 1.0f));
  }

  HWY_INLINE void ShadePiece(
    const ShadePieces& p, ShadeMask used, TileRemainders& rest, ShadeVector (&color)[4]) const
  {
    const ShadeFloat d;
    const ShadeInt di;
    const TileTransfer& t = this->Transfer;
    const auto rise = hn::Sub(p.Last, p.First);
    const auto slope = this->Values(t.Slopes[3].data(), p.Piece);
    const auto offset = this->Values(t.Offsets[3].data(), p.Piece);
    const auto rising = hn::Lt(hn::Zero(d), rise);
    const auto one = hn::IfThenElseZero(hn::RebindMask(di, rising), hn::Set(di, 1));
    const auto bound = this->Values(t.Bounds.data(), hn::Add(p.Piece, one));
    const auto cut = hn::And(hn::Lt(hn::Mul(hn::Sub(bound, p.Last), rise), hn::Zero(d)), used);
    auto end = p.Last, part = p.Length;
    if (!hn::AllFalse(d, cut))
    {
      const auto share = hn::Div(hn::Sub(bound, p.First), rise);
      end = hn::IfThenElse(cut, bound, end);
      part = hn::IfThenElse(cut, hn::Min(hn::Mul(part, share), part), part);
    }
    const auto front = hn::Max(hn::MulAdd(slope, p.First, offset), hn::Zero(d));
    auto back = hn::Max(hn::MulAdd(slope, end, offset), hn::Zero(d));
    const auto half = hn::Set(d, 0.5f);
    auto depth = hn::Mul(hn::Mul(part, half), hn::Add(front, back));
    const auto thick = hn::And(hn::Lt(hn::Set(d, 1.0f), depth), used);
    if (!hn::AllFalse(d, thick))
    {
      const auto share = this->ShareOfDepthOne(front, back, part);
      end = hn::IfThenElse(thick, hn::MulAdd(share, hn::Sub(end, p.First), p.First), end);
      part = hn::IfThenElse(thick, hn::Mul(part, share), part);
      back = hn::Max(hn::MulAdd(slope, end, offset), hn::Zero(d));
      depth = hn::Mul(hn::Mul(part, half), hn::Add(front, back));
      depth = hn::Min(depth, hn::Set(d, 1.0f));
    }
    const auto alpha = Absorption(d, depth);
    const auto open = hn::Or(cut, thick);
    if (!hn::AllFalse(d, open))
    {
      ShadePieces left = p;
      left.First = end;
      left.Length = hn::Sub(p.Length, part);
      left.Through = hn::NegMulAdd(p.Through, alpha, p.Through);
      const auto beside = hn::Sub(hn::Add(p.Piece, hn::Add(one, one)), hn::Set(di, 1));
      left.Piece = hn::IfThenElse(hn::RebindMask(di, thick), p.Piece, beside);
      // What is nearly opaque hides the rest.
      this->Append(hn::And(open, hn::Lt(hn::Set(d, 1e-7f), left.Through)), left, rest);
    }
    const auto total = hn::Add(hn::Add(front, back), hn::Set(d, 1e-30f));
    const auto lean = hn::Mul(hn::Sub(back, front), Reciprocal(d, total));
    const auto mean = hn::MulAdd(AbsorptionMean(d, depth, lean), hn::Sub(end, p.First), p.First);
    for (int k = 0; k < 3; ++k)
    {
      const auto value = hn::MulAdd(this->Values(t.Slopes[k].data(), p.Piece), mean,
        this->Values(t.Offsets[k].data(), p.Piece));
      color[k] = hn::Mul(alpha, value);
    }
    color[3] = hn::Neg(alpha);
  }

  HWY_INLINE void Append(ShadeMask which, const ShadePieces& p, TileRemainders& rest) const
  {
    const ShadeFloat d;
    const ShadeInt di;
    const auto whichInt = hn::RebindMask(di, which);
    const int at = rest.Count;
    hn::StoreU(hn::Compress(p.First, which), d, rest.First + at);
    hn::StoreU(hn::Compress(p.Last, which), d, rest.Last + at);
    hn::StoreU(hn::Compress(p.Length, which), d, rest.Length + at);
    hn::StoreU(hn::Compress(p.Through, which), d, rest.Through + at);
    hn::StoreU(hn::Compress(p.Piece, whichInt), di, rest.Piece + at);
    hn::StoreU(hn::Compress(p.Fragment, whichInt), di, rest.Fragment + at);
    rest.Count = at + static_cast<int>(hn::CountTrue(d, which));
  }

  /// Apart from the shading: two short chains of steps that wait for each other run side by side
  /// over more vectors than a long one.
  void FindFirstPieces(const TileFragments& q, TileRemainders& out) const
  {
    const ShadeFloat d;
    const ShadeInt di;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const auto scale = hn::Set(d, this->WeightScale), offset = hn::Set(d, this->WeightOffset);
    for (int at = 0; at < q.Count; at += lanes)
    {
      const FragmentEnds ends(q, at, scale, offset);
      const auto length = hn::Mul(ends.Depth, this->Lengths.At(hn::Load(di, q.Pixel + at)));
      hn::Store(length, d, out.Length + at);
      hn::Store(ends.First, d, out.First + at);
      hn::Store(ends.Last, d, out.Last + at);
      hn::Store(PieceOf(this->Values, this->Transfer, ends.First), di, out.Piece + at);
    }
  }

  void ShadeFirstPieces(const TileRemainders& first, TileFragments& q, TileRemainders& rest) const
  {
    const ShadeFloat d;
    const ShadeInt di;
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (int at = 0; at < q.Count; at += lanes)
    {
      ShadePieces p;
      p.First = hn::Load(d, first.First + at);
      p.Last = hn::Load(d, first.Last + at);
      p.Length = hn::Load(d, first.Length + at);
      p.Through = hn::Set(d, 1.0f);
      p.Piece = hn::Load(di, first.Piece + at);
      p.Fragment = Ramp(di, at);
      ShadeVector color[4];
      const auto used = hn::FirstN(d, static_cast<std::size_t>(q.Count - at));
      this->ShadePiece(p, used, rest, color);
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
      ShadePieces p;
      p.First = hn::Load(d, now.First + at);
      p.Last = hn::Load(d, now.Last + at);
      p.Length = hn::Load(d, now.Length + at);
      p.Through = hn::Load(d, now.Through + at);
      // Beyond the count there is what was there before.
      const auto usedInt = hn::FirstN(di, static_cast<std::size_t>(count));
      p.Piece = hn::IfThenElseZero(usedInt, hn::Load(di, now.Piece + at));
      p.Fragment = hn::Load(di, now.Fragment + at);
      ShadeVector color[4];
      this->ShadePiece(p, used, next, color);
      for (int k = 0; k < 4; ++k)
      {
        color[k] = hn::Mul(color[k], p.Through);
      }
      AddColors(color, now.Fragment + at, count, q);
    }
  }

  const LookUp Values{};
  const TileTransfer& Transfer;
  const RayLengths Lengths;
  const float WeightScale, WeightOffset;
};

inline long long ShadeFragments(const TileTask& task, const TileRectangle& tile,
  TileFragments& fragments, TileRemainders (&remainders)[2])
{
  // One bound more than pieces is looked up.
  if (task.Transfer->NumberOfPieces < static_cast<int>(hn::Lanes(ShadeFloat())))
  {
    return TileShader<RegisterLookUp>(task, tile).Shade(fragments, remainders);
  }
  return TileShader<MemoryLookUp>(task, tile).Shade(fragments, remainders);
}
}
}
HWY_AFTER_NAMESPACE();

#endif
