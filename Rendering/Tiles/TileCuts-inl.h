/**
 * Planes that cut transparent parts off cells: where the scalar is the lowest or the highest in the
 * cell that the transfer function lets be seen, it is a plane as the faces are.
 *
 * What is cut off is not queued, shaded or laid over anything, and is in nobody's way.
 */
#if defined(TileCuts_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileCuts_inl_h
#undef TileCuts_inl_h
#else
#define TileCuts_inl_h
#endif

#include "TileGroup.h"
#include "TilePieces-inl.h"
#include "TileTask.h"
#include "TileTransfer.h"
#include "TileView.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

static_assert(TileGroup::Batch <= 16, "cells are looked up a vector at a time");

/// Where the scalar is one value, in the lanes of a group.
struct CutPlane
{
  ShadeVector P, A, B;
  /// Whether the scalar rises towards the eye.
  ShadeMask Rises;

  HWY_INLINE CutPlane(const TileTask& task, const TileGroup& group, int lane, ShadeVector scalar)
  {
    const ShadeFloat d;
    const auto scale = hn::Set(d, static_cast<float>(task.View->WeightScale));
    const auto offset = hn::Set(d, static_cast<float>(task.View->WeightOffset));
    const auto perU = hn::NegMulAdd(scalar, scale, hn::Load(d, group.ScalarU + lane));
    this->Rises = hn::Lt(hn::Zero(d), perU);
    // Where rays run along the plane it is as good as edge-on, and finite.
    const auto least = hn::Set(d, 1e-25f);
    const auto size =
      hn::IfThenElse(this->Rises, hn::Max(perU, least), hn::Min(perU, hn::Neg(least)));
    const auto inverse = hn::Div(hn::Set(d, 1.0f), size);
    const auto at = hn::MulSub(scalar, offset, hn::Load(d, group.ScalarP + lane));
    this->P = hn::Mul(at, inverse);
    this->A = hn::Neg(hn::Mul(hn::Load(d, group.ScalarA + lane), inverse));
    this->B = hn::Neg(hn::Mul(hn::Load(d, group.ScalarB + lane), inverse));
  }
};

/// Stores the one of two planes that a mask takes, or one behind or before everything (`none`).
HWY_INLINE void StoreCut(const CutPlane& low, ShadeMask takesLow, const CutPlane& high,
  ShadeMask takesHigh, float none, int plane, int lane, TileGroup& group)
{
  const ShadeFloat d;
  auto pick = [&](ShadeVector ofLow, ShadeVector ofHigh, float ofNone)
  { return hn::IfThenElse(takesLow, ofLow, hn::IfThenElse(takesHigh, ofHigh, hn::Set(d, ofNone))); };
  hn::Store(pick(low.P, high.P, none), d, group.P[plane] + lane);
  hn::Store(pick(low.A, high.A, 0.0f), d, group.A[plane] + lane);
  hn::Store(pick(low.B, high.B, 0.0f), d, group.B[plane] + lane);
}

/// `least` and `greatest`: scalars in the lanes' cells, of which the lines of the group are set up.
template <class LookUp>
HWY_INLINE void SetUpCuts(const TileTask& task, ShadeVector least, ShadeVector greatest, int lane,
  TileGroup& group)
{
  const ShadeFloat d;
  const hn::RebindToSigned<ShadeFloat> di;
  const TileTransfer& transfer = *task.Transfer;
  const LookUp values;
  const auto from = values(transfer.SeenFrom.data(), PieceOf(values, transfer, least));
  const auto to = values(transfer.SeenTo.data(), PieceOf(values, transfer, greatest));
  const auto cutsLow = hn::Lt(least, from), cutsHigh = hn::Lt(to, greatest);
  const CutPlane low(task, group, lane, from), high(task, group, lane, to);
  const auto lowExit = hn::And(cutsLow, low.Rises), lowEntry = hn::AndNot(low.Rises, cutsLow);
  // Seen along a bend of the weights both may be on one side: one of them cuts enough.
  const auto highEntry = hn::AndNot(lowEntry, hn::And(cutsHigh, high.Rises));
  const auto highExit = hn::AndNot(lowExit, hn::AndNot(high.Rises, cutsHigh));
  StoreCut(low, lowEntry, high, highEntry, 1e30f, TileGroup::CutEntry, lane, group);
  StoreCut(low, lowExit, high, highExit, -1e30f, TileGroup::CutExit, lane, group);
  const auto cut = hn::RebindMask(di, hn::Or(cutsLow, cutsHigh));
  hn::Store(hn::IfThenElseZero(cut, hn::Set(di, 1)), di, group.Cut + lane);
}
}
}
HWY_AFTER_NAMESPACE();

#endif
