/**
 * Spans: the pixels of a row that a cell covers, of sixteen cells one per lane, row after row.
 *
 * A ray is inside between its last entry and its first exit; u of both is linear over the screen. What an entry
 * plane and an exit plane have in common is an edge of the cell's outline, a line that a row crosses at one x.
 */
#if defined(TileSpans_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileSpans_inl_h
#undef TileSpans_inl_h
#else
#define TileSpans_inl_h
#endif

#include "TileCells.h"
#include "TileGroup.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

using SpanFloat = hn::CappedTag<float, TileGroup::Batch>;
using SpanInt = hn::RebindToSigned<SpanFloat>;
using SpanVector = hn::Vec<SpanFloat>;
using SpanMask = hn::Mask<SpanFloat>;

/// The planes of a group's lanes from `lane` on.
struct SpanPlane
{
  SpanVector A, B, P;

  /// The first where the mask takes it, else the second.
  HWY_INLINE SpanPlane(SpanMask takesFirst, const SpanPlane& first, const SpanPlane& second)
    : A(hn::IfThenElse(takesFirst, first.A, second.A))
    , B(hn::IfThenElse(takesFirst, first.B, second.B))
    , P(hn::IfThenElse(takesFirst, first.P, second.P))
  {
  }
  HWY_INLINE SpanPlane(const TileGroup& group, int face, int lane)
    : A(hn::Load(SpanFloat(), group.A[face] + lane))
    , B(hn::Load(SpanFloat(), group.B[face] + lane))
    , P(hn::Load(SpanFloat(), group.P[face] + lane))
  {
  }
};

/// A line over the rows: pixels from a side of the box.
struct SpanLine
{
  SpanVector Slope, Offset;

  HWY_INLINE SpanVector At(SpanVector row) const { return hn::MulAdd(this->Slope, row, this->Offset); }
};

/// The first line where the mask takes it, else the second.
HWY_INLINE SpanLine Pick(SpanMask takesFirst, const SpanLine& first, const SpanLine& second)
{
  return { hn::IfThenElse(takesFirst, first.Slope, second.Slope),
    hn::IfThenElse(takesFirst, first.Offset, second.Offset) };
}

/// The line where the mask takes it, else the side of the box itself.
HWY_INLINE SpanLine PickOrSide(SpanMask takes, const SpanLine& line)
{
  return { hn::IfThenElseZero(takes, line.Slope), hn::IfThenElseZero(takes, line.Offset) };
}

/// An edge of the outline, and which side of the lanes' cells it bounds, if any.
struct SpanEdge
{
  SpanLine FromLeft, FromRight;
  SpanMask IsEdge, IsLeft, IsRight;

  /// `isEdge`: where one of the planes is an entry and the other an exit; `entersFirst`: where the first is the entry.
  HWY_INLINE SpanEdge(
    const SpanPlane& first, const SpanPlane& second, SpanMask isEdge, SpanMask entersFirst, SpanVector last)
  {
    const SpanFloat d;
    const auto a = hn::Sub(first.A, second.A), b = hn::Sub(first.B, second.B), p = hn::Sub(first.P, second.P);
    // Along a row as good as level: the crossing stays finite, and far from the box.
    const auto least = hn::MulAdd(hn::Set(d, 1e-9f), hn::Add(hn::Abs(b), hn::Abs(p)), hn::Set(d, 1e-30f));
    const auto size = hn::CopySign(hn::Max(hn::Abs(a), least), a);
    const auto inverse = hn::Div(hn::Set(d, 1.0f), size);
    this->FromRight.Slope = hn::Mul(b, inverse);
    this->FromRight.Offset = hn::MulAdd(p, inverse, last);
    this->FromLeft.Slope = hn::Neg(this->FromRight.Slope);
    this->FromLeft.Offset = hn::Neg(hn::Mul(p, inverse));
    const auto beginsAt = hn::Xor(hn::Lt(size, hn::Zero(d)), entersFirst);
    this->IsEdge = isEdge;
    this->IsLeft = hn::And(isEdge, beginsAt);
    this->IsRight = hn::AndNot(beginsAt, isEdge);
  }
};

/// The outline of the lanes' cells.
template <int Lines>
struct SpanOutline
{
  SpanLine Left[Lines], Right[Lines];
  /// Of four sides: a second edge of a couple on one side; which couples have none.
  SpanLine SpareLeft, SpareRight;
  SpanMask HasNone[3];
  /// The width of the box, and what lets rows below it end before they begin.
  SpanVector End;
  SpanLine Below;

  /// The place of two edges that have no corner in common. Three sides have one of every couple, four have two of two
  /// couples, of which three at most are on one side: of a second on one side there is one at most, it goes to the place
  /// of the couple that has none.
  HWY_INLINE void TakeCouple(const SpanEdge& one, const SpanEdge& other, int at)
  {
    this->Left[at] = Pick(one.IsLeft, one.FromLeft, PickOrSide(other.IsLeft, other.FromLeft));
    this->Right[at] = Pick(one.IsRight, one.FromRight, PickOrSide(other.IsRight, other.FromRight));
    const auto areLeft = hn::And(one.IsLeft, other.IsLeft), areRight = hn::And(one.IsRight, other.IsRight);
    this->SpareLeft = Pick(areLeft, other.FromLeft, this->SpareLeft);
    this->SpareRight = Pick(areRight, other.FromRight, this->SpareRight);
    this->HasNone[at] = hn::Not(hn::Or(one.IsEdge, other.IsEdge));
  }
  HWY_INLINE void TakeSpare()
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Left[i] = Pick(this->HasNone[i], this->SpareLeft, this->Left[i]);
      this->Right[i] = Pick(this->HasNone[i], this->SpareRight, this->Right[i]);
    }
  }
  HWY_INLINE void Take(const SpanEdge& edge, int at)
  {
    this->Left[at] = PickOrSide(edge.IsLeft, edge.FromLeft);
    this->Right[at] = PickOrSide(edge.IsRight, edge.FromRight);
  }

  /// What a row has: where it begins in the box, and how many pixels, 0 or less where none.
  HWY_INLINE void FindSpan(SpanVector row, SpanVector& first, SpanVector& count) const
  {
    const SpanFloat d;
    auto left = hn::Zero(d), right = hn::Max(this->Below.At(row), hn::Zero(d));
    for (int i = 0; i < Lines; ++i)
    {
      left = hn::Max(left, this->Left[i].At(row));
      right = hn::Max(right, this->Right[i].At(row));
    }
    first = hn::Ceil(left);
    count = hn::Sub(hn::Floor(hn::Sub(this->End, right)), first);
  }
};

HWY_INLINE SpanMask EntersThrough(const TileGroup& group, int face, int lane)
{
  const SpanInt di;
  const auto bit = hn::Set(di, 1 << face);
  const auto entries = hn::Load(di, group.Entries + lane);
  return hn::RebindMask(SpanFloat(), hn::Eq(hn::And(entries, bit), bit));
}

/// Between faces, then, of more than three lines, between faces and cuts.
template <int Lines>
HWY_INLINE void BuildOutline(const TileGroup& group, int lane, SpanOutline<Lines>& outline)
{
  const SpanFloat d;
  const SpanInt di;
  outline.End = hn::ConvertTo(d, hn::Load(di, group.Width + lane));
  const auto last = hn::Sub(outline.End, hn::Set(d, 1.0f));
  const auto lastRow = hn::ConvertTo(d, hn::Sub(hn::Load(di, group.Height + lane), hn::Set(di, 1)));
  outline.Below.Slope = hn::Set(d, 2.0f * TileSize::Pixels);
  outline.Below.Offset = hn::Neg(hn::Mul(outline.Below.Slope, lastRow));
  outline.SpareLeft = outline.SpareRight = { hn::Zero(d), hn::Zero(d) };
  auto edge = [&](int i, int j)
  {
    const auto enters = EntersThrough(group, i, lane);
    return SpanEdge(SpanPlane(group, i, lane), SpanPlane(group, j, lane),
      hn::Xor(enters, EntersThrough(group, j, lane)), enters, last);
  };
  outline.TakeCouple(edge(0, 1), edge(2, 3), 0);
  outline.TakeCouple(edge(0, 2), edge(1, 3), 1);
  outline.TakeCouple(edge(0, 3), edge(1, 2), 2);
  outline.TakeSpare();
  if constexpr (Lines > 3)
  {
    const auto isCut = hn::RebindMask(d, hn::Ne(hn::Load(di, group.Cut + lane), hn::Zero(di)));
    const SpanPlane cutEntry(group, TileGroup::CutEntry, lane), cutExit(group, TileGroup::CutExit, lane);
    for (int i = 0; i < 4; ++i)
    {
      const auto enters = EntersThrough(group, i, lane);
      const SpanPlane cut(enters, cutExit, cutEntry);
      outline.Take(SpanEdge(SpanPlane(group, i, lane), cut, isCut, enters, last), 3 + i);
    }
  }
}

/// A whole number of up to 23 bits: as a float's last bits, and how far those are above it.
constexpr float WholeBits = 8388608.0f;
constexpr std::int32_t AboveWhole = 0x4B000000;

/// As in TileGroup, from the corner on.
HWY_INLINE hn::Vec<SpanInt> PackSpan(SpanVector first, SpanVector count, hn::Vec<SpanInt> corner)
{
  const SpanFloat d;
  // An empty row may begin anywhere.
  const auto start = hn::Min(first, hn::Set(d, static_cast<float>(TileSize::Pixels)));
  const auto upper = hn::MulAdd(
    hn::Max(count, hn::Zero(d)), hn::Set(d, 65536.0f), hn::Set(d, WholeBits));
  return hn::Add(hn::BitCast(SpanInt(), hn::Add(start, upper)), corner);
}

/// The spans of a group's lanes from `lane` on; of cells that are not drawn so they mean nothing. Rows behind a cell's
/// last one are empty, empty rows may begin anywhere.
template <int Lines>
HWY_INLINE void FindSpans(TileGroup& group, int lane)
{
  const SpanFloat d;
  const SpanInt di;
  SpanOutline<Lines> outline;
  BuildOutline(group, lane, outline);
  const int rows = hn::GetLane(hn::MaxOfLanes(di, hn::Load(di, group.Height + lane)));
  auto corner = hn::Add(hn::Sub(hn::Load(di, group.Left + lane), hn::Set(di, AboveWhole)),
    hn::ShiftLeft<TileSize::Shift>(hn::Load(di, group.Bottom + lane)));
  // As many as are read.
  const int end =
    std::max((rows + TileGroup::RowStep - 1) / TileGroup::RowStep * TileGroup::RowStep, TileGroup::FirstRows);
  for (int row = 0; row < end; ++row)
  {
    SpanVector first, count;
    outline.FindSpan(hn::Set(d, static_cast<float>(row)), first, count);
    hn::Store(PackSpan(first, count, corner), di, group.Spans[row] + lane);
    corner = hn::Add(corner, hn::Set(di, TileSize::Pixels));
  }
}
}
}
HWY_AFTER_NAMESPACE();

#endif
