/**
 * Colour and opacity of fragments, a full vector of any cells at a time.
 *
 * A fragment is cut where the transfer function bends and where the optical depth of a piece would
 * pass 1. In a piece extinction and colour are linear in the scalar, so alpha = 1 - exp(-depth) is
 * exact, and so is colour = alpha * (colour at the mean place of the absorbed light). Fragments of
 * one thin piece or two are shaded straight through, else the first piece is; what is left waits in
 * a second queue and is shaded the same way.
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
#include "TilePacking-inl.h"
#include "TilePieces-inl.h"
#include "TilePixels-inl.h"
#include "TileTask.h"
#include "TileThinPieces-inl.h"
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

/// World length of a ray per depth at the pixels of a tile.
class RayLengths
{
public:
  RayLengths(const TileView& view, const TileRectangle& tile)
  {
    const glm::dvec3 first =
      view.Ray[0] + double(tile.Left) * view.Ray[1] + double(tile.Bottom) * view.Ray[2];
    const double terms[6] = { glm::dot(first, first), 2.0 * glm::dot(first, view.Ray[1]),
      2.0 * glm::dot(first, view.Ray[2]), glm::dot(view.Ray[1], view.Ray[1]),
      2.0 * glm::dot(view.Ray[1], view.Ray[2]), glm::dot(view.Ray[2], view.Ray[2]) };
    for (int i = 0; i < 6; ++i)
    {
      this->Terms[i] = hn::Set(ShadeFloat(), static_cast<float>(terms[i]));
    }
  }

  HWY_INLINE ShadeVector At(ShadeIndex pixel) const
  {
    const ShadeVector(&t)[6] = this->Terms;
    const PixelPlaces places(pixel);
    const auto x = places.X, y = places.Y;
    const auto perX = hn::MulAdd(t[3], x, hn::MulAdd(t[4], y, t[1]));
    const auto perY = hn::MulAdd(t[5], y, t[2]);
    return hn::Sqrt(hn::MulAdd(perX, x, hn::MulAdd(perY, y, t[0])));
  }

private:
  // Vectors: to spread a number takes an instruction each time where registers are few.
  ShadeVector Terms[6];
};

/// Pieces about to be shaded, one per lane, and the first part of each.
struct ShadePieces
{
  ShadeVector First, Last, Length, Through;
  ShadeIndex Piece, Fragment;
  // The part: where it ends, extinction at both ends, optical depth; whether a node or the depth
  // cuts it.
  ShadeVector End, Part, Front, Back, Depth;
  ShadeMask Cut, Thick;
};

template <class LookUp>
class TileShader
{
public:
  TileShader(const TileTask& task, const TileRectangle& tile)
    : Transfer(*task.Transfer)
    , Lengths(*task.View, tile)
    , WeightScale(hn::Set(ShadeFloat(), static_cast<float>(task.View->WeightScale)))
    , WeightOffset(hn::Set(ShadeFloat(), static_cast<float>(task.View->WeightOffset)))
  {
  }

  /// Fills the colours.
  TileShadeCount Shade(TileFragments& fragments, TileRemainders (&remainders)[2]) const
  {
    TileShadeCount more;
    TileShadeCount sum = ShadeInPasses(
      fragments.Count, remainders,
      [&](TileRemainders& rest) { more = this->ShadeFirstPieces(fragments, rest); },
      [&](int, const TileRemainders& now, TileRemainders& next)
      { this->ShadeRemainders(fragments, now, next); });
    sum.Pieces += more.Pieces;
    sum.Lanes += more.Lanes;
    return sum;
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

  /// Cuts at the transfer function's node.
  HWY_INLINE void CutAtNode(ShadeMask used, ShadePieces& p) const
  {
    const NodeCut node =
      FindNode(this->Values, this->Transfer, p.Piece, p.First, p.Last, used);
    p.Cut = node.IsCut;
    p.End = p.Last;
    p.Part = p.Length;
    if (node.IsAny)
    {
      p.End = hn::IfThenElse(p.Cut, node.Bound, p.End);
      p.Part = hn::Mul(p.Part, node.Share);
    }
  }

  /// The optical depth; cuts where it would pass 1.
  HWY_INLINE void LimitDepth(ShadeMask used, ShadePieces& p) const
  {
    const ShadeFloat d;
    const auto slope = this->Values(this->Transfer.Slopes[3].data(), p.Piece);
    const auto offset = this->Values(this->Transfer.Offsets[3].data(), p.Piece);
    p.Front = hn::Max(hn::MulAdd(slope, p.First, offset), hn::Zero(d));
    p.Back = hn::Max(hn::MulAdd(slope, p.End, offset), hn::Zero(d));
    const auto half = hn::Set(d, 0.5f);
    p.Depth = hn::Mul(hn::Mul(p.Part, half), hn::Add(p.Front, p.Back));
    p.Thick = hn::And(hn::Lt(hn::Set(d, 1.0f), p.Depth), used);
    if (!hn::AllFalse(d, p.Thick))
    {
      const auto share = this->ShareOfDepthOne(p.Front, p.Back, p.Part);
      p.End = hn::IfThenElse(p.Thick, hn::MulAdd(share, hn::Sub(p.End, p.First), p.First), p.End);
      p.Part = hn::IfThenElse(p.Thick, hn::Mul(p.Part, share), p.Part);
      p.Back = hn::Max(hn::MulAdd(slope, p.End, offset), hn::Zero(d));
      const auto depth = hn::Mul(hn::Mul(p.Part, half), hn::Add(p.Front, p.Back));
      p.Depth = hn::Min(depth, hn::Set(d, 1.0f));
    }
  }

  /// The part's colour; what is left behind it waits.
  HWY_INLINE void ColorPart(
    const ShadePieces& p, TileRemainders& rest, ShadeVector (&color)[4]) const
  {
    const ShadeFloat d;
    const TileTransfer& t = this->Transfer;
    const auto alpha = Absorption(d, p.Depth);
    const auto open = hn::Or(p.Cut, p.Thick);
    if (!hn::AllFalse(d, open))
    {
      this->AppendRest(p, open, alpha, rest);
    }
    const auto total = hn::Add(hn::Add(p.Front, p.Back), hn::Set(d, 1e-30f));
    const auto lean = hn::Mul(hn::Sub(p.Back, p.Front), Reciprocal(d, total));
    const auto mean = hn::MulAdd(AbsorptionMean(d, p.Depth, lean), hn::Sub(p.End, p.First), p.First);
    for (int k = 0; k < 3; ++k)
    {
      const auto value = hn::MulAdd(this->Values(t.Slopes[k].data(), p.Piece), mean,
        this->Values(t.Offsets[k].data(), p.Piece));
      color[k] = hn::Mul(alpha, value);
    }
    color[3] = hn::Neg(alpha);
  }

  HWY_INLINE void AppendRest(
    const ShadePieces& p, ShadeMask open, ShadeVector alpha, TileRemainders& rest) const
  {
    const ShadeFloat d;
    const ShadeInt di;
    ShadePieces left = p;
    left.First = p.End;
    left.Length = hn::Sub(p.Length, p.Part);
    left.Through = hn::NegMulAdd(p.Through, alpha, p.Through);
    left.Piece = hn::IfThenElse(
      hn::RebindMask(di, p.Thick), p.Piece, PieceBeyond(p.Piece, p.First, p.Last));
    // What is nearly opaque hides the rest.
    this->Append(hn::And(open, hn::Lt(hn::Set(d, 1e-7f), left.Through)), left, rest);
  }

  HWY_INLINE void Append(ShadeMask which, const ShadePieces& p, TileRemainders& rest) const
  {
    const ShadeFloat d;
    const ShadeInt di;
    const LanePacker<ShadeFloat> pack(d, which);
    const int at = rest.Count;
    hn::StoreU(pack(p.First), d, rest.First + at);
    hn::StoreU(pack(p.Last), d, rest.Last + at);
    hn::StoreU(pack(p.Length), d, rest.Length + at);
    hn::StoreU(pack(p.Through), d, rest.Through + at);
    hn::StoreU(pack(p.Piece), di, rest.Piece + at);
    hn::StoreU(pack(p.Fragment), di, rest.Fragment + at);
    rest.Count = at + static_cast<int>(hn::CountTrue(d, which));
  }

  HWY_INLINE void FindCourse(const TileFragments& q, int at, ShadeCourse& course) const
  {
    const ShadeInt di;
    const FragmentEnds ends(q, at, this->WeightScale, this->WeightOffset);
    course.Length = hn::Mul(ends.Depth(), this->Lengths.At(hn::Load(di, q.Pixel + at)));
    course.First = ends.First(q.ScalarIn + at);
    course.Last = ends.Last(q.ScalarOut + at);
  }

  /// So many batches are shaded by parts unseen after one of which few vectors are thin.
  static constexpr int MostSkipped = 3;

  /// Vectors of thin fragments in one piece are coloured at once, the others by parts; returns how much more
  /// this shades than a piece of each fragment.
  TileShadeCount ShadeFirstPieces(TileFragments& q, TileRemainders& rest) const
  {
    constexpr int lanes = static_cast<int>(hn::MaxLanes(ShadeFloat()));
    q.FillLastVector();
    ThinBatch batch;
    ThinLine line{ this->Transfer.Lines.data() };
    int skipped = MostSkipped;
    TileShadeCount more;
    for (int at = 0; at < q.Count; at += ThinBatch::Size * lanes)
    {
      batch.Count = std::min(ThinBatch::Size, (q.Count - at + lanes - 1) / lanes);
      for (int i = 0; i < batch.Count; ++i)
      {
        this->FindCourse(q, at + i * lanes, batch.Courses[i]);
      }
      if (skipped == MostSkipped && batch.FindDepths(this->Values, this->Transfer, line))
      {
        this->ColorThinOnes(batch, at, q, rest, more);
        continue;
      }
      // Where few are thin, the next ones are not tried.
      skipped = skipped == MostSkipped ? 0 : skipped + 1;
      this->ShadeByParts(batch, at, q, rest);
    }
    return more;
  }

  /// The same of a batch from `at` on.
  HWY_INLINE void ColorThinOnes(
    const ThinBatch& batch, int at, TileFragments& q, TileRemainders& rest, TileShadeCount& more) const
  {
    constexpr int lanes = static_cast<int>(hn::MaxLanes(ShadeFloat()));
    // All of them: those that are mixed come over it.
    for (int i = 0; i < batch.Count; ++i)
    {
      ShadeVector color[4];
      ColorThin(batch.Lines[i], batch.Courses[i], batch.Depths[i], color);
      StoreColors(color, at + i * lanes, q);
    }
    for (unsigned int mixed = batch.Mixed; mixed != 0; mixed &= mixed - 1)
    {
      const int i = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(mixed));
      this->ColorMixed(batch.Courses[i], at + i * lanes, q, rest, more);
    }
  }

  /// Of fragments in several pieces; those that ThinParts leaves wait, each alone.
  HWY_NOINLINE void ColorMixed(
    const ShadeCourse& course, int at, TileFragments& q, TileRemainders& rest, TileShadeCount& more) const
  {
    const ShadeFloat d;
    const auto used = hn::FirstN(d, static_cast<std::size_t>(q.Count - at));
    const ThinParts<LookUp> parts(this->Values, this->Transfer);
    ShadeVector color[4];
    ShadeMask isCut;
    const auto fits = parts.Color(course, used, color, isCut);
    const auto open = hn::AndNot(fits, used);
    const int count = static_cast<int>(hn::CountTrue(d, open));
    if (count > 0)
    {
      for (auto& component : color)
      {
        component = hn::IfThenElseZero(fits, component);
      }
      this->Leave(course, open, at, rest);
    }
    StoreColors(color, at, q);
    more.Pieces += static_cast<int>(hn::CountTrue(d, hn::And(fits, isCut))) - count;
    // Coloured as thin, by look-ups and behind the node.
    more.Lanes += static_cast<int>(hn::Lanes(d)) * (hn::AllFalse(d, isCut) ? 1 : 2);
  }

  HWY_INLINE void Leave(
    const ShadeCourse& course, ShadeMask which, int at, TileRemainders& rest) const
  {
    ShadePieces p;
    this->Begin(course, at, p);
    this->Append(which, p, rest);
  }

  /// The whole fragments from `at` on.
  HWY_INLINE void Begin(const ShadeCourse& course, int at, ShadePieces& p) const
  {
    p.First = course.First;
    p.Last = course.Last;
    p.Length = course.Length;
    p.Through = hn::Set(ShadeFloat(), 1.0f);
    p.Piece = PieceOf(this->Values, this->Transfer, p.First);
    p.Fragment = Ramp(ShadeInt(), at);
  }

  /// Shades the first parts of a batch from `begin` on, step after step.
  HWY_NOINLINE void ShadeByParts(
    const ThinBatch& batch, int begin, TileFragments& q, TileRemainders& rest) const
  {
    constexpr int lanes = static_cast<int>(hn::MaxLanes(ShadeFloat()));
    ShadePieces work[ThinBatch::Size];
    for (int i = 0; i < batch.Count; ++i)
    {
      const int at = begin + i * lanes;
      this->Begin(batch.Courses[i], at, work[i]);
      this->CutFirstPart(hn::FirstN(ShadeFloat(), static_cast<std::size_t>(q.Count - at)), work[i]);
    }
    for (int i = 0; i < batch.Count; ++i)
    {
      ShadeVector color[4];
      this->ColorPart(work[i], rest, color);
      StoreColors(color, begin + i * lanes, q);
    }
  }

  HWY_INLINE void CutFirstPart(ShadeMask used, ShadePieces& p) const
  {
    this->CutAtNode(used, p);
    this->LimitDepth(used, p);
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
      this->CutFirstPart(used, p);
      this->ColorPart(p, next, color);
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
  const ShadeVector WeightScale, WeightOffset;
};

inline TileShadeCount ShadeFragments(const TileTask& task, const TileRectangle& tile,
  TileFragments& fragments, TileRemainders (&remainders)[2])
{
  return WithLookUp(*task.Transfer,
    [&](auto values) { return TileShader<decltype(values)>(task, tile).Shade(fragments, remainders); });
}
}
}
HWY_AFTER_NAMESPACE();

#endif
