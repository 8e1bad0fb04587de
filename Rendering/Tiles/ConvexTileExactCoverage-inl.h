/**
 * Which pixels of a tile a convex cell covers that floats do not serve: by planes on the screen in double
 * (class ScreenFaces), or where those do not serve either along rays in mesh coordinates (class
 * ConvexTileExactCell).
 */
#if defined(ConvexTileExactCoverage_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef ConvexTileExactCoverage_inl_h
#undef ConvexTileExactCoverage_inl_h
#else
#define ConvexTileExactCoverage_inl_h
#endif

#include "ConvexTileCells.h"
#include "ConvexTileEnds-inl.h"
#include "ConvexTileExactCell.h"
#include "ConvexTileLanes-inl.h"
#include "ConvexTileMesh.h"
#include "ConvexTileRays.h"
#include "ConvexTileScreenFaces-inl.h"
#include "ConvexTileSpans-inl.h"
#include "ConvexTileTask.h"
#include "TileExactCoverage-inl.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Appends a segment in parts over which the weight falls to a share of no less than LeastShare:
/// beside a great weight a float does not keep the digits of a small one.
inline void AppendSegment(const TileView& view, double reference,
  const ConvexTileExactCell::Segment& segment, int pixel, TileFragments& out)
{
  double entry = view.ScreenDepth(reference + segment.Entry);
  const double exit = view.ScreenDepth(reference + segment.Exit);
  auto weightAt = [&](double u) { return view.WeightScale * u + view.WeightOffset; };
  const double last = weightAt(exit), scalarOut = segment.ScalarOut * last;
  double weight = weightAt(entry), scalar = segment.ScalarIn * weight;
  for (int part = 0; part < ConvexTileCells::MostParts && entry > exit; ++part)
  {
    const bool isLast =
      last >= ConvexTileCells::LeastShare * weight || part + 1 == ConvexTileCells::MostParts;
    const double share =
      isLast ? 1.0 : (1.0 - ConvexTileCells::LeastShare) * weight / (weight - last);
    const int at = out.Count++;
    out.Entry[at] = static_cast<float>(entry);
    out.Extent[at] = static_cast<float>(share * (entry - exit));
    out.ScalarIn[at] = static_cast<float>(scalar);
    scalar += share * (scalarOut - scalar);
    out.ScalarOut[at] = static_cast<float>(scalar);
    out.Pixel[at] = pixel;
    entry = isLast ? exit : entry - share * (entry - exit);
    weight = weightAt(entry);
  }
}

/// u of depths before the eye.
HWY_INLINE LaneVector ScreenDepthOf(const TileView::DepthToScreen& map, LaneVector depth)
{
  const LaneDouble d;
  const auto linear = hn::MulAdd(hn::Set(d, map.Terms[1]), depth, hn::Set(d, map.Terms[0]));
  const auto one = hn::Set(d, 1.0);
  return map.InPerspective ? hn::Add(hn::Div(one, linear), hn::Set(d, map.Terms[2])) : linear;
}

/// The segments of `which` lanes in one part each; `pixel` is that of the first lane. Returns the
/// lanes that need more parts.
inline LaneMask AppendLanes(const ConvexTileTask& task, const LanePassage& rays, LaneMask which,
  int pixel, TileFragments& out)
{
  const LaneDouble d;
  const TileView& view = *task.Common.View;
  const TileView::DepthToScreen map = view.GetDepthToScreen();
  const auto reference = hn::Set(d, task.Rays->Reference);
  const auto entry = ScreenDepthOf(map, hn::Add(reference, rays.Entry));
  const auto exit = ScreenDepthOf(map, hn::Add(reference, rays.Exit));
  const auto scale = hn::Set(d, view.WeightScale), offset = hn::Set(d, view.WeightOffset);
  const auto first = hn::MulAdd(scale, entry, offset), last = hn::MulAdd(scale, exit, offset);
  const auto isOne = hn::Ge(last, hn::Mul(hn::Set(d, ConvexTileCells::LeastShare), first));
  const auto kept = hn::And(which, hn::And(isOne, hn::Lt(exit, entry)));
  out.Count = AppendFragments(kept, entry, exit, hn::Mul(rays.ScalarIn, first),
    hn::Mul(rays.ScalarOut, last), Ramp(hn::Rebind<std::int32_t, LaneDouble>(), pixel), out.Count, out);
  return hn::AndNot(isOne, which);
}

/// The rays of a row from column `left` on, `count` of them at most.
inline void CoverLanes(const ConvexTileTask& task, const TileRectangle& tile,
  const ConvexTileExactCell& cell, int left, int y, int count, TileFragments& out)
{
  const LaneDouble d;
  const LanePassage rays(cell, *task.Rays, Ramp(d, static_cast<double>(left)), y);
  const auto used = hn::FirstN(d, static_cast<std::size_t>(count));
  const int pixel = (y - tile.Bottom) * TileSize::Pixels + left - tile.Left;
  const auto tidy = hn::And(used, hn::AndNot(rays.Odd, rays.Covered));
  auto others = hn::And(used, rays.Odd);
  if (!hn::AllFalse(d, tidy))
  {
    others = hn::Or(others, AppendLanes(task, rays, tidy, pixel, out));
  }
  if (hn::AllFalse(d, others))
  {
    return;
  }
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, others, bits);
  for (int k = 0; k < static_cast<int>(hn::Lanes(d)); ++k)
  {
    ConvexTileExactCell::Segment segment;
    if ((bits[0] >> k & 1) != 0 && cell.Cross(*task.Rays, left + k, y, segment))
    {
      AppendSegment(*task.Common.View, task.Rays->Reference, segment, pixel + k, out);
    }
  }
}

/// A cell by planes on the screen; false where they do not serve.
inline bool CoverOnScreen(const ConvexTileTask& task, const TileRectangle& tile, int id,
  const CellBox& box, TileFragments& out)
{
  ScreenFaces faces;
  if (!faces.SetUp(task, id))
  {
    return false;
  }
  const int begin = task.Mesh->Faces.Offsets[id];
  const auto faceAt = [&](int at) -> const ScreenFaces::Face& { return faces[at - begin]; };
  const CellEnds<LaneDouble> ends(task, id, box, faceAt);
  if (ends.AreBoth())
  {
    const RowSpans spans(EdgeList(task, id, box, faceAt), box, true);
    CoverSpans(ends, spans, box.GetHeight(), CornerPixel(box, tile), out);
  }
  return true;
}

/// A cell in double; hands on the queue whenever it is full.
template <class Flush>
void CoverExactConvexCell(const ConvexTileTask& task, const TileRectangle& tile, int id,
  const CellBox& box, ConvexTileExactCell& cell, TileFragments& out, const Flush& flush)
{
  const bool isOnScreen = task.Cells->Exact[id] == ConvexTileCells::OnScreen;
  if (isOnScreen && CoverOnScreen(task, tile, id, box, out))
  {
    return;
  }
  cell.SetUp(*task.Mesh, id);
  const int lanes = static_cast<int>(hn::Lanes(LaneDouble()));
  for (int y = box.FirstY; y <= box.LastY; ++y)
  {
    for (int x = box.FirstX; x <= box.LastX; x += lanes)
    {
      CoverLanes(task, tile, cell, x, y, std::min(lanes, box.LastX - x + 1), out);
    }
    if (out.Count >= out.Full)
    {
      flush();
    }
  }
}

}
}
HWY_AFTER_NAMESPACE();

#endif
