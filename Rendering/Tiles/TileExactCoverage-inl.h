/**
 * Which pixels of a tile a cell covers for which floats do not serve: see class TileExactCell.
 */
#if defined(TileExactCoverage_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileExactCoverage_inl_h
#undef TileExactCoverage_inl_h
#else
#define TileExactCoverage_inl_h
#endif

#include "TileCells.h"
#include "TileExactCell.h"
#include "TileExactRows.h"
#include "TileFragments.h"
#include "TileMath-inl.h"
#include "TilePacking-inl.h"
#include "TileTask.h"
#include "TileView.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

using ExactFloat = hn::CappedTag<double, 8>;
using ExactVector = hn::Vec<ExactFloat>;

/// What planes seen edge-on leave of rays: those within a plane's tolerance count as moved off it.
inline void CutByEdgeOn(
  const TileExactCell& cell, ExactVector x, double y, ExactVector& entry, ExactVector& exit)
{
  const ExactFloat d;
  for (const TileExactCell::Plane& plane : cell.Planes)
  {
    if (plane.Tolerance <= 0.0)
    {
      continue;
    }
    const auto value = hn::MulAdd(hn::Set(d, plane.A), x, hn::Set(d, plane.B * y + plane.E));
    const auto within = hn::Le(hn::Abs(value), hn::Set(d, plane.Tolerance));
    const auto u =
      hn::Mul(hn::IfThenElse(within, hn::Set(d, plane.Nudge), value), hn::Set(d, plane.Inverse));
    entry = plane.IsEntry ? hn::Min(entry, u) : entry;
    exit = plane.IsEntry ? exit : hn::Max(exit, u);
  }
}

/// Entry and exit of pixels in a row in double, and the mask of those that are covered.
HWY_INLINE hn::Mask<ExactFloat> CoverExactLanes(const TileExactCell& cell, const TileExactRows& rows,
  ExactVector x, double y, ExactVector& entry, ExactVector& exit)
{
  const ExactFloat d;
  auto at = [&](const TileExactRows::Line& line)
  { return hn::MulAdd(hn::Set(d, line.A), x, hn::Set(d, line.B * y + line.E)); };
  entry = hn::Set(d, rows.Entries.Lines[0].E);
  exit = hn::Set(d, rows.Exits.Lines[0].E);
  for (int i = 1; i < rows.Entries.Count; ++i)
  {
    entry = hn::Min(entry, at(rows.Entries.Lines[i]));
  }
  for (int i = 1; i < rows.Exits.Count; ++i)
  {
    exit = hn::Max(exit, at(rows.Exits.Lines[i]));
  }
  if (HWY_UNLIKELY(rows.HasEdgeOn))
  {
    CutByEdgeOn(cell, x, y, entry, exit);
  }
  return hn::Lt(exit, entry);
}

/// Puts the lanes of `covered` at `at`; returns where the next ones go.
inline int AppendFragments(hn::Mask<ExactFloat> covered, ExactVector entry, ExactVector exit,
  ExactVector scalarIn, ExactVector scalarOut, hn::Vec<hn::Rebind<std::int32_t, ExactFloat>> pixel,
  int at, TileFragments& out)
{
  const ExactFloat d;
  const hn::Rebind<float, ExactFloat> df;
  const hn::Rebind<std::int32_t, ExactFloat> di;
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, covered, bits);
  const LanePacker<decltype(df)> pack(df, hn::LoadMaskBits(df, bits));
  auto store = [&](ExactVector value, float* to)
  { hn::StoreU(pack(hn::DemoteTo(df, value)), df, to + at); };
  store(entry, out.Entry);
  store(hn::Sub(entry, exit), out.Extent);
  store(scalarIn, out.ScalarIn);
  store(scalarOut, out.ScalarOut);
  hn::StoreU(pack(pixel), di, out.Pixel + at);
  return at + static_cast<int>(hn::CountTrue(d, covered));
}

/// Rays of a row of pixels from where they enter a tetrahedron to where they leave it.
struct ExactRays
{
  /// Scalar times weight rises by PerU for each u, from Scalar.
  ExactVector Entry, Exit, PerU, Scalar;
  hn::Vec<hn::Rebind<std::int32_t, ExactFloat>> Pixel;

  HWY_INLINE void Append(hn::Mask<ExactFloat> covered, TileFragments& out) const
  {
    out.Count = AppendFragments(covered, this->Entry, this->Exit, hn::MulAdd(this->PerU, this->Entry, this->Scalar),
      hn::MulAdd(this->PerU, this->Exit, this->Scalar), this->Pixel, out.Count, out);
  }
};

/// In parts over which the weight falls to a share of no less than LeastShare.
HWY_NOINLINE inline void AppendParts(
  const TileView& view, hn::Mask<ExactFloat> covered, const ExactRays& rays, TileFragments& out)
{
  const ExactFloat d;
  const auto scale = hn::Set(d, view.WeightScale), offset = hn::Set(d, view.WeightOffset);
  const auto last = hn::MulAdd(scale, rays.Exit, offset);
  // What is before that many parts is nothing beside them.
  const auto most = hn::Mul(last, hn::Set(d, TileExactCell::MostWeight));
  ExactRays part = rays;
  if (view.WeightScale > 0.0)
  {
    part.Entry = hn::Min(part.Entry, hn::Sub(most, offset));
  }
  while (!hn::AllFalse(d, covered))
  {
    const auto least = hn::Mul(hn::MulAdd(scale, part.Entry, offset), hn::Set(d, TileExactCell::LeastShare));
    const auto isLast = hn::Ge(last, least);
    part.Exit = hn::IfThenElse(isLast, rays.Exit, hn::Sub(least, offset));
    part.Append(covered, out);
    covered = hn::AndNot(isLast, covered);
    part.Entry = part.Exit;
  }
}

/// The same of a tetrahedron: beside a great weight a float does not keep the digits of a small one, so rays along which
/// it falls far are cut.
HWY_INLINE void AppendExact(const TileExactCell& cell, const TileView& view, hn::Mask<ExactFloat> covered,
  ExactVector x, double y, ExactVector entry, ExactVector exit, int pixel, TileFragments& out)
{
  const ExactFloat d;
  const auto scalar = hn::MulAdd(
    hn::Set(d, cell.ScalarA), x, hn::Set(d, cell.ScalarB * y + cell.ScalarE));
  const ExactRays rays{ entry, exit, hn::Set(d, cell.ScalarC), scalar,
    Ramp(hn::Rebind<std::int32_t, ExactFloat>(), pixel) };
  const auto scale = hn::Set(d, view.WeightScale), offset = hn::Set(d, view.WeightOffset);
  const auto least = hn::Mul(hn::MulAdd(scale, entry, offset), hn::Set(d, TileExactCell::LeastShare));
  const auto isCut = hn::And(covered, hn::Lt(hn::MulAdd(scale, exit, offset), least));
  if (HWY_LIKELY(hn::AllFalse(d, isCut)))
  {
    rays.Append(covered, out);
    return;
  }
  AppendParts(view, covered, rays, out);
}

/// Where in rows of pixels a cell may be, of a vector of rows at a time; first > last where it is not.
struct ExactBounds
{
  HWY_ALIGN std::int32_t First[8];
  HWY_ALIGN std::int32_t Last[8];

  /// Of the rows from y on, between `first` and `last`.
  HWY_INLINE void Find(const TileExactRows& rows, int y, int first, int last)
  {
    const ExactFloat d;
    const hn::Rebind<std::int32_t, ExactFloat> di;
    const auto row = Ramp(d, static_cast<double>(y));
    auto begin = hn::Set(d, static_cast<double>(first)), end = hn::Set(d, static_cast<double>(last));
    auto at = [&](const TileExactRows::Edge& edge)
    { return hn::MulAdd(hn::Set(d, edge.Slope), row, hn::Set(d, edge.Offset)); };
    for (int i = 0; i < rows.Left.Count; ++i)
    {
      begin = hn::Max(begin, at(rows.Left.Edges[i]));
    }
    for (int i = 0; i < rows.Right.Count; ++i)
    {
      end = hn::Min(end, at(rows.Right.Edges[i]));
    }
    // Back to whole pixels of the row.
    begin = hn::Ceil(hn::Min(begin, hn::Set(d, last + 1.0)));
    end = hn::Floor(hn::Max(end, hn::Sub(begin, hn::Set(d, 1.0))));
    hn::Store(hn::DemoteTo(di, begin), di, this->First);
    hn::Store(hn::DemoteTo(di, end), di, this->Last);
  }
};

/// The pixels of a cell's row from `begin` to `end`.
HWY_INLINE void CoverExactRow(const TileTask& task, const TileRectangle& tile, const TileExactCell& cell,
  const TileExactRows& rows, int y, int begin, int end, TileFragments& out)
{
  const ExactFloat d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  out.CountLanes(end - begin + 1, 1, lanes, 1);
  for (int left = begin; left <= end; left += lanes)
  {
    const auto x = Ramp(d, static_cast<double>(left));
    ExactVector entry, exit;
    const auto inRow = hn::FirstN(d, static_cast<std::size_t>(end - left + 1));
    const auto covered =
      hn::And(inRow, CoverExactLanes(cell, rows, x, y, entry, exit));
    if (!hn::AllFalse(d, covered))
    {
      const int pixel = (y - tile.Bottom) * TileSize::Pixels + left - tile.Left;
      AppendExact(cell, *task.View, covered, x, y, entry, exit, pixel, out);
    }
  }
}

/// A cell in double: see class TileExactCell; `flush` empties the queue where its rows fill it.
template <class Flush>
void CoverExactCell(
  const TileTask& task, const TileRectangle& tile, int id, TileFragments& out, const Flush& flush)
{
  const TileExactCell cell(*task.Mesh, *task.View, id);
  const int lanes = static_cast<int>(hn::Lanes(ExactFloat()));
  const int firstX = std::max(cell.Box[0], tile.FirstX), lastX = std::min(cell.Box[2], tile.LastX);
  const int firstY = std::max(cell.Box[1], tile.FirstY), lastY = std::min(cell.Box[3], tile.LastY);
  const TileExactRows rows(cell, *task.View);
  ExactBounds bounds;
  for (int first = firstY; first <= lastY; first += lanes)
  {
    bounds.Find(rows, first, firstX, lastX);
    for (int y = first; y <= std::min(first + lanes - 1, lastY); ++y)
    {
      CoverExactRow(task, tile, cell, rows, y, bounds.First[y - first], bounds.Last[y - first], out);
      if (HWY_UNLIKELY(out.Count > TileFragments::Capacity - 64 - TileSize::Pixels * TileExactCell::MostParts))
      {
        flush();
        out.BeginCell(id);
      }
    }
  }
}
}
}
HWY_AFTER_NAMESPACE();

#endif
