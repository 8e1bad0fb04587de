/**
 * What every shading of fragments by pieces shares: the first piece of a fragment is shaded
 * straight through, or more; what is left of it, or all, waits in a queue, pass after pass.
 */
#if defined(TilePieces_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TilePieces_inl_h
#undef TilePieces_inl_h
#else
#define TilePieces_inl_h
#endif

#include "TileColors-inl.h"
#include "TileFragments.h"
#include "TileMath-inl.h"

#include <hwy/highway.h>

#include <algorithm>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

using ShadeFloat = ColorFloat;
using ShadeInt = hn::RebindToSigned<ShadeFloat>;
using ShadeVector = hn::Vec<ShadeFloat>;
using ShadeIndex = hn::Vec<ShadeInt>;
using ShadeMask = hn::Mask<ShadeFloat>;

/// Table look-ups in registers, for a function of fewer pieces than a vector has lanes.
struct RegisterLookUp
{
  HWY_INLINE ShadeVector operator()(const float* table, ShadeIndex index) const
  {
    const ShadeFloat d;
    return hn::TableLookupLanes(hn::LoadU(d, table), hn::IndicesFromVec(d, index));
  }
};

/// The same for a function of fewer pieces than two vectors have lanes.
struct TwoRegistersLookUp
{
  HWY_INLINE ShadeVector operator()(const float* table, ShadeIndex index) const
  {
    const ShadeFloat d;
    const ShadeInt di;
    constexpr int lanes = static_cast<int>(hn::MaxLanes(ShadeFloat()));
    const auto last = hn::Set(di, lanes - 1);
    const auto lane = hn::IndicesFromVec(d, hn::And(index, last));
    const auto low = hn::TableLookupLanes(hn::LoadU(d, table), lane);
    const auto high = hn::TableLookupLanes(hn::LoadU(d, table + lanes), lane);
    return hn::IfThenElse(hn::RebindMask(d, hn::Gt(index, last)), high, low);
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

/// The piece of one scalar.
template <class Table>
int FindPiece(const Table& table, float scalar)
{
  const auto begin = table.Bounds.begin() + 1;
  const auto end = table.Bounds.begin() + table.NumberOfPieces;
  return static_cast<int>(std::upper_bound(begin, end, scalar) - begin);
}

/// Of fragments that all lie in one piece.
struct OnePieceLookUp
{
  int Piece = 0;
  HWY_INLINE ShadeVector operator()(const float* table, ShadeIndex) const
  {
    return hn::Set(ShadeFloat(), table[this->Piece]);
  }

  /// Goes over to the piece that the scalars from `least` to `greatest` lie in, if there is one.
  template <class Table>
  HWY_INLINE bool Take(const Table& table, ShadeVector least, ShadeVector greatest)
  {
    const ShadeFloat d;
    this->Piece = FindPiece(table, hn::GetLane(least));
    const auto above = hn::Le(hn::Set(d, table.Bounds[this->Piece]), least);
    const auto below = hn::Le(greatest, hn::Set(d, table.Bounds[this->Piece + 1]));
    return hn::AllTrue(d, hn::And(above, below));
  }
};

template <class Table>
HWY_INLINE bool FitsRegisters(const Table& table)
{
  // One bound more than pieces is looked up.
  return table.NumberOfPieces < static_cast<int>(hn::Lanes(ShadeFloat()));
}

/// Calls a function with the look-ups that suit a table.
template <class Table, class Function>
HWY_INLINE auto WithLookUp(const Table& table, const Function& function)
{
  // A register of one lane holds no table.
  if constexpr (hn::MaxLanes(ShadeFloat()) > 1)
  {
    if (FitsRegisters(table))
    {
      return function(RegisterLookUp());
    }
    // Gathering is slow.
    if (table.NumberOfPieces < 2 * static_cast<int>(hn::Lanes(ShadeFloat())))
    {
      return function(TwoRegistersLookUp());
    }
  }
  return function(MemoryLookUp());
}

/// Up to as many pieces a count takes fewer operations than a search.
constexpr int FewPieces = hn::MaxLanes(ShadeFloat()) < 16 ? 14 : 6;

/// One more where the mask is set.
HWY_INLINE ShadeIndex IncrementWhere(hn::Mask<ShadeInt> mask, ShadeIndex number)
{
  const ShadeInt di;
#if HWY_TARGET <= HWY_AVX3
  return hn::IfThenElse(mask, hn::Add(number, hn::Set(di, 1)), number);
#else
  // There a mask is -1 in a vector.
  return hn::Sub(number, hn::VecFromMask(di, mask));
#endif
}

/// The piece of a table (TileTransfer, EmissionTable) that a scalar lies in.
template <class LookUp, class Table>
HWY_INLINE ShadeIndex PieceOf(const LookUp& values, const Table& table, ShadeVector scalar)
{
  const ShadeInt di;
  auto piece = hn::Zero(di);
  if (table.NumberOfPieces <= FewPieces)
  {
    // Counted: the steps of a search wait for each other.
    for (int i = 1; i < table.NumberOfPieces; ++i)
    {
      const auto reached = hn::Le(hn::Set(ShadeFloat(), table.Bounds[i]), scalar);
      piece = IncrementWhere(hn::RebindMask(di, reached), piece);
    }
    return piece;
  }
  for (int bit = 1 << table.SearchSteps >> 1; bit != 0; bit >>= 1)
  {
    const auto higher = hn::Or(piece, hn::Set(di, bit));
    const auto reached = hn::Le(values(table.Bounds.data(), higher), scalar);
    piece = hn::IfThenElse(hn::RebindMask(di, reached), higher, piece);
  }
  return piece;
}

template <class Table>
HWY_INLINE ShadeIndex PieceOf(const OnePieceLookUp& one, const Table&, ShadeVector)
{
  return hn::Set(ShadeInt(), one.Piece);
}

/// One where the scalar rises, else zero.
HWY_INLINE ShadeIndex Rises(ShadeVector first, ShadeVector last)
{
  const ShadeInt di;
  return hn::IfThenElseZero(hn::RebindMask(di, hn::Lt(first, last)), hn::Set(di, 1));
}

/// The piece on the other side of the node that a scalar comes to.
HWY_INLINE ShadeIndex PieceBeyond(ShadeIndex piece, ShadeVector first, ShadeVector last)
{
  const auto rises = Rises(first, last);
  return hn::Sub(hn::Add(piece, hn::Add(rises, rises)), hn::Set(ShadeInt(), 1));
}

/// Where a piece of a ray passes the next node of a table.
struct NodeCut
{
  ShadeMask IsCut;
  bool IsAny;
  /// Where any is cut: the node, and the share of the piece before it; 1 where none is.
  ShadeVector Bound, Share;
};

template <class LookUp, class Table>
HWY_INLINE NodeCut FindNode(const LookUp& values, const Table& table, ShadeIndex piece,
  ShadeVector first, ShadeVector last, ShadeMask used)
{
  const ShadeFloat d;
  NodeCut node;
  const auto rise = hn::Sub(last, first);
  node.Bound = values(table.Bounds.data(), hn::Add(piece, Rises(first, last)));
  node.IsCut = hn::And(hn::Lt(hn::Mul(hn::Sub(node.Bound, last), rise), hn::Zero(d)), used);
  node.IsAny = !hn::AllFalse(d, node.IsCut);
  node.Share = hn::Set(d, 1.0f);
  if (node.IsAny)
  {
    const auto share = hn::Div(hn::Sub(node.Bound, first), rise);
    node.Share = hn::IfThenElse(node.IsCut, hn::Min(share, node.Share), node.Share);
  }
  return node;
}

/// No piece of a ray passes a node there.
template <class Table>
HWY_INLINE NodeCut FindNode(const OnePieceLookUp&, const Table&, ShadeIndex, ShadeVector,
  ShadeVector last, ShadeMask)
{
  const ShadeFloat d;
  return { hn::Lt(hn::Zero(d), hn::Zero(d)), false, last, hn::Set(d, 1.0f) };
}

/// A vector of fragments in depth and scalar, which are not linear on the screen.
struct FragmentEnds
{
  ShadeVector Entry, Extent, WeightIn, WeightOut;
  ShadeVector Inverse; // of both weights' product

  HWY_INLINE FragmentEnds(const TileFragments& q, int at, ShadeVector scale, ShadeVector offset)
  {
    const ShadeFloat d;
    this->Entry = hn::Load(d, q.Entry + at);
    this->Extent = hn::Load(d, q.Extent + at);
    this->WeightIn = hn::MulAdd(scale, this->Entry, offset);
    this->WeightOut = hn::NegMulAdd(scale, this->Extent, this->WeightIn);
    this->Inverse = hn::Div(hn::Set(d, 1.0f), hn::Mul(this->WeightIn, this->WeightOut));
  }

  /// From entry to exit.
  HWY_INLINE ShadeVector Depth() const { return hn::Mul(this->Extent, this->Inverse); }
  HWY_INLINE ShadeVector First(const float* scalarIn) const
  {
    const auto weighted = hn::Load(ShadeFloat(), scalarIn);
    return hn::Mul(hn::Mul(weighted, this->WeightOut), this->Inverse);
  }
  HWY_INLINE ShadeVector Last(const float* scalarOut) const
  {
    const auto weighted = hn::Load(ShadeFloat(), scalarOut);
    return hn::Mul(hn::Mul(weighted, this->WeightIn), this->Inverse);
  }
};

/// Adds the colours of `count` pieces to those of the fragments that they are left of.
HWY_INLINE void AddColors(
  const ShadeVector (&color)[4], const int* fragments, int count, TileFragments& q)
{
  const hn::CappedTag<float, 4> record;
  HWY_ALIGN float colors[16][4];
  hn::StoreInterleaved4(color[0], color[1], color[2], color[3], ShadeFloat(), colors[0]);
  for (int k = 0; k < count; ++k)
  {
    float* target = q.Slots[ColorSlot(fragments[k])];
    for (std::size_t i = 0; i < 4; i += hn::Lanes(record))
    {
      const auto sum = hn::Add(hn::Load(record, target + i), hn::Load(record, colors[k] + i));
      hn::Store(sum, record, target + i);
    }
  }
}

/// `first(rest)` shades the first pieces of `count` fragments, `others(pass, now, next)` those that
/// wait.
template <class Queue, class First, class Others>
TileShadeCount ShadeInPasses(int count, Queue (&queues)[2], const First& first, const Others& others)
{
  constexpr int lanes = static_cast<int>(hn::MaxLanes(ShadeFloat()));
  TileShadeCount sum;
  auto add = [&sum](int pieces)
  {
    sum.Pieces += pieces;
    sum.Lanes += (pieces + lanes - 1) / lanes * lanes;
  };
  add(count);
  Queue* now = &queues[0];
  Queue* next = &queues[1];
  now->Count = 0;
  first(*now);
  for (int pass = 1; now->Count > 0; ++pass, std::swap(now, next))
  {
    add(now->Count);
    next->Count = 0;
    others(pass, *now, *next);
  }
  return sum;
}
}
}
HWY_AFTER_NAMESPACE();

#endif
