/**
 * Which pixels of a tile a convex cell covers, where their rays enter and leave it, and the scalar
 * there.
 *
 * A ray is inside between its last entry (the least u of the faces towards the eye) and its first
 * exit; the scalar at either is that of the face which decides.
 */
#if defined(ConvexTileCoverage_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef ConvexTileCoverage_inl_h
#undef ConvexTileCoverage_inl_h
#else
#define ConvexTileCoverage_inl_h
#endif

#include "ConvexTileCells.h"
#include "ConvexTileEnds-inl.h"
#include "ConvexTileExactCell.h"
#include "ConvexTileLanes-inl.h"
#include "ConvexTileMesh.h"
#include "ConvexTileRays.h"
#include "ConvexTileSpans-inl.h"
#include "ConvexTileTask.h"
#include "TileCoverage-inl.h"
#include "TileLimits.h"
#include "TilePixels-inl.h"

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Has what the cells after the one at `at` need brought into the caches: it lies apart. Inlined, or
/// compilers take it for a function without effect and leave out its calls.
HWY_INLINE void FetchAhead(const ConvexTileTask& task, const int* cells, int at, int count)
{
  constexpr int Near = 4, Far = 8;
  const ConvexTileMesh& mesh = *task.Mesh;
  if (at + Far < count)
  {
    const int cell = cells[at + Far];
    hwy::Prefetch(mesh.Faces.GetRow(cell));
    hwy::Prefetch(mesh.Corners.GetRow(cell));
    hwy::Prefetch(mesh.Edges.Ends.data() + mesh.Edges.Offsets[cell]);
  }
  if (at + Near < count)
  {
    const int cell = cells[at + Near];
    for (int i = mesh.Faces.Offsets[cell]; i < mesh.Faces.Offsets[cell + 1]; ++i)
    {
      hwy::Prefetch(&task.Faces->Values[mesh.Faces.Values[i]]);
    }
    for (int i = mesh.Corners.Offsets[cell]; i < mesh.Corners.Offsets[cell + 1]; ++i)
    {
      hwy::Prefetch(&task.Common.Vertices->Values[4 * static_cast<std::size_t>(mesh.Corners.Values[i])]);
    }
  }
}

/// Whether opaque geometry and clipping planes leave nothing of a cell in a box.
inline bool IsCutOff(const ConvexTileTask& task, int cell, const CellBox& box)
{
  const ConvexTileCells::Depths& depths = task.Cells->Ranges[cell];
  const int first[2] = { box.FirstX, box.FirstY }, last[2] = { box.LastX, box.LastY };
  return task.LeavesOut &&
         task.Common.Limits->CutsOff(first, last, depths.Farthest, depths.Nearest);
}

/// A cell that floats serve, over the pixels of its box.
struct CellBlocks
{
  const CellFaces Faces;
  const BlockShapes::Shape& Shape;
  const int Width, Height;
  /// The pixel of the tile's where the box begins.
  const int Corner;
  const bool HasCellScalar;
  float ScalarScale = 0.0f, ScalarOffset = 0.0f;

  CellBlocks(const ConvexTileTask& task, const TileRectangle& tile, int cell, const CellBox& box,
    const BlockShapes& shapes)
    : Faces(task, cell, box)
    , Shape(shapes.Choose(box.GetWidth(), box.GetHeight()))
    , Width(box.GetWidth())
    , Height(box.GetHeight())
    , Corner((box.FirstY - tile.Bottom) * TileSize::Pixels + box.FirstX - tile.Left)
    , HasCellScalar(!task.Mesh->CellScalars.empty())
  {
    if (this->HasCellScalar)
    {
      const float scalar = task.Mesh->CellScalars[cell];
      this->ScalarScale = scalar * static_cast<float>(task.Common.View->WeightScale);
      this->ScalarOffset = scalar * static_cast<float>(task.Common.View->WeightOffset);
    }
  }

  /// Where the rays at x, y from the box's corner enter and leave.
  HWY_INLINE void FindEnds(CoverVector x, CoverVector y, BlockEnd& entry, BlockEnd& exit) const
  {
    const CellFaces& f = this->Faces;
    for (int i = 0; i < f.Counts[0]; ++i)
    {
      entry.Add<true>(f.Ends[0][i], x, y, i == 0);
    }
    for (int i = 0; i < f.Counts[1]; ++i)
    {
      exit.Add<false>(f.Ends[1][i], x, y, i == 0);
    }
    // Twice: an end that a later face moves may come to lie in the gap of an earlier one.
    for (int i = 0; i < 2 * f.Pairs; ++i)
    {
      CutAtValley(f.Valleys[i % f.Pairs], x, y, entry, exit);
    }
    if (this->HasCellScalar)
    {
      const CoverFloat d;
      const auto scale = hn::Set(d, this->ScalarScale), offset = hn::Set(d, this->ScalarOffset);
      entry.S = hn::MulAdd(scale, entry.U, offset);
      exit.S = hn::MulAdd(scale, exit.U, offset);
    }
  }

  /// Calls `each` with the covered lanes of every block, where their rays enter and leave, and their pixels.
  template <class Each>
  HWY_INLINE void Walk(const Each& each) const
  {
    const CoverFloat d;
    const CoverInt di;
    const BlockBox box(this->Shape, this->Width, this->Height);
    const auto columns = hn::Load(d, this->Shape.X), rows = hn::Load(d, this->Shape.Y);
    const auto pixels = hn::Load(di, this->Shape.Pixel);
    for (int top = 0; top < this->Height; top += this->Shape.Height)
    {
      const auto y = hn::Add(rows, hn::Set(d, static_cast<float>(top)));
      const auto inRows = box.InRows(top);
      for (int left = 0; left < this->Width; left += this->Shape.Width)
      {
        BlockEnd entry, exit;
        this->FindEnds(
          hn::Add(columns, hn::Set(d, static_cast<float>(left))), y, entry, exit);
        const auto within = left < box.LastLeft ? inRows : hn::And(inRows, box.InLast);
        const int corner = this->Corner + top * TileSize::Pixels + left;
        each(hn::And(within, hn::Lt(exit.U, entry.U)), entry, exit,
          hn::Add(pixels, hn::Set(di, corner)));
      }
    }
  }
};

/// All of a fragment at once.
inline void CoverConvexAtOnce(const CellBlocks& cell, TileFragments& out)
{
  int count = out.Count;
  cell.Walk(
    [&](hn::Mask<CoverFloat> covered, const BlockEnd& entry, const BlockEnd& exit, hn::Vec<CoverInt> pixel)
    { count = AppendFragments(covered, entry.U, exit.U, entry.S, exit.S, pixel, count, out); });
  out.Count = count;
}

/// Puts the pixels of all rows at the end of the queue; returns how many it has then.
inline int AppendSpans(const RowSpans& spans, const CellBlocks& cell, TileFragments& out)
{
  const CoverInt di;
  int count = out.Count;
  for (int row = 0; row < cell.Height; ++row)
  {
    const int first = spans.First[row], size = spans.Last[row] - first + 1;
    const int pixel = cell.Corner + row * TileSize::Pixels + first;
    for (int k = 0; k < size; k += static_cast<int>(hn::Lanes(di)))
    {
      hn::StoreU(Ramp(di, pixel + k), di, out.Pixel + count + k);
    }
    count += std::max(size, 0);
  }
  return count;
}

/// A full vector of them.
HWY_INLINE void StoreFragments(
  const BlockEnd& entry, const BlockEnd& exit, hn::Vec<CoverInt> pixel, int at, TileFragments& out)
{
  const CoverFloat d;
  hn::StoreU(entry.U, d, out.Entry + at);
  hn::StoreU(hn::Sub(entry.U, exit.U), d, out.Extent + at);
  hn::StoreU(entry.S, d, out.ScalarIn + at);
  hn::StoreU(exit.S, d, out.ScalarOut + at);
  hn::StoreU(pixel, CoverInt(), out.Pixel + at);
}

/// The pixels between its edges first, then the rest of their fragments in full vectors.
inline void CoverConvexInSpans(const ConvexTileTask& task, int id, const CellBlocks& cell,
  const CellBox& box, TileFragments& out)
{
  const EdgeList edges(task, id, box);
  const int end = AppendSpans(RowSpans(edges, box), cell, out);
  const CoverFloat d;
  int count = out.Count;
  for (int at = count; at < end; at += static_cast<int>(hn::Lanes(d)))
  {
    const auto pixel = hn::LoadU(CoverInt(), out.Pixel + at);
    const PixelPlaces places(pixel, cell.Corner);
    BlockEnd entry, exit;
    cell.FindEnds(places.X, places.Y, entry, exit);
    const auto used = hn::FirstN(d, static_cast<std::size_t>(end - at));
    const auto covered = hn::And(used, hn::Lt(exit.U, entry.U));
    // No more than were read: a place that is written to was read before.
    if (hn::AllTrue(d, covered))
    {
      StoreFragments(entry, exit, pixel, count, out);
      count += static_cast<int>(hn::Lanes(d));
    }
    else
    {
      count = AppendFragments(covered, entry.U, exit.U, entry.S, exit.S, pixel, count, out);
    }
  }
  out.Count = count;
}

inline void CoverConvexCell(const ConvexTileTask& task, const TileRectangle& tile, int id,
  const CellBox& box, const BlockShapes& shapes, TileFragments& out)
{
  const CellBlocks cell(task, tile, id, box, shapes);
  if (cell.Faces.Counts[0] == 0 || cell.Faces.Counts[1] == 0)
  {
    return;
  }
  if (cell.Width * cell.Height <= static_cast<int>(hn::Lanes(CoverFloat())))
  {
    CoverConvexAtOnce(cell, out);
  }
  else
  {
    CoverConvexInSpans(task, id, cell, box, out);
  }
}

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
  AppendExactLanes(kept, entry, exit, hn::Mul(rays.ScalarIn, first),
    hn::Mul(rays.ScalarOut, last), pixel, out);
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

/// A cell in double; hands on the queue whenever it is full.
template <class Flush>
void CoverExactConvexCell(const ConvexTileTask& task, const TileRectangle& tile, int id,
  const CellBox& box, ConvexTileExactCell& cell, TileFragments& out, const Flush& flush)
{
  cell.SetUp(*task.Mesh, id);
  const int lanes = static_cast<int>(hn::Lanes(LaneDouble()));
  for (int y = box.FirstY; y <= box.LastY; ++y)
  {
    for (int x = box.FirstX; x <= box.LastX; x += lanes)
    {
      CoverLanes(task, tile, cell, x, y, std::min(lanes, box.LastX - x + 1), out);
    }
    if (out.Count >= TileFragments::Full)
    {
      flush();
    }
  }
}

/// Appends what a cell covers of a tile; `flush` empties the queue.
template <class Flush>
void CoverAnyConvexCell(const ConvexTileTask& task, const TileRectangle& tile, int cell,
  const BlockShapes& shapes, ConvexTileExactCell& exact, TileFragments& out, const Flush& flush)
{
  const CellBox box(task.Cells->Boxes[cell], tile);
  if (box.LastX < box.FirstX || box.LastY < box.FirstY)
  {
    return;
  }
  if (task.Cells->Exact[cell] || task.Mesh->Faces.GetSize(cell) > CellFaces::Most)
  {
    CoverExactConvexCell(task, tile, cell, box, exact, out, flush);
  }
  else
  {
    CoverConvexCell(task, tile, cell, box, shapes, out);
  }
}
}
}
HWY_AFTER_NAMESPACE();

#endif
