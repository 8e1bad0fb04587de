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
#include "ConvexTileExactCoverage-inl.h"
#include "ConvexTileMesh.h"
#include "ConvexTileSpans-inl.h"
#include "ConvexTileTask.h"
#include "TileBlocks-inl.h"
#include "TileLimits.h"

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

/// A cell that covers a vector of pixels at most: all of its fragments at once.
inline void CoverConvexAtOnce(const CellEnds<CoverFloat>& ends, const CellBox& box, int corner,
  const BlockShapes& shapes, TileFragments& out)
{
  const CoverFloat d;
  const BlockShapes::Shape& shape = shapes.Choose(box.GetWidth(), box.GetHeight());
  const BlockBox block(shape, box.GetWidth(), box.GetHeight());
  const auto columns = hn::Load(d, shape.X), rows = hn::Load(d, shape.Y);
  const auto pixels = hn::Load(CoverInt(), shape.Pixel);
  for (int top = 0; top < box.GetHeight(); top += shape.Height)
  {
    for (int left = 0; left < box.GetWidth(); left += shape.Width)
    {
      BlockEnd<CoverFloat> entry, exit;
      ends.Find(hn::Add(columns, hn::Set(d, static_cast<float>(left))),
        hn::Add(rows, hn::Set(d, static_cast<float>(top))), entry, exit);
      const auto inRows = block.InRows(top);
      const auto within = left < block.LastLeft ? inRows : hn::And(inRows, block.InLast);
      const auto covered = hn::And(within, hn::Lt(exit.U, entry.U));
      const int first = corner + top * TileSize::Pixels + left;
      out.Count = AppendFragments(covered, entry.U, exit.U, entry.S, exit.S,
        hn::Add(pixels, hn::Set(CoverInt(), first)), out.Count, out);
    }
  }
}

inline void CoverConvexCell(const ConvexTileTask& task, const TileRectangle& tile, int id,
  const CellBox& box, const BlockShapes& shapes, TileFragments& out)
{
  const auto faceAt = [&](int at) -> const ConvexTileFace&
  { return task.Faces->Values[task.Mesh->Faces.Values[at]]; };
  const CellEnds<CoverFloat> ends(task, id, box, faceAt);
  const int corner = CornerPixel(box, tile);
  if (!ends.AreBoth())
  {
    return;
  }
  if (box.GetWidth() * box.GetHeight() <= static_cast<int>(hn::Lanes(CoverFloat())))
  {
    CoverConvexAtOnce(ends, box, corner, shapes, out);
  }
  else
  {
    const RowSpans spans(EdgeList(task, id, box, faceAt), box, false);
    CoverSpans(ends, spans, box.GetHeight(), corner, out);
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
  if (task.Cells->Exact[cell] || task.Mesh->Faces.GetSize(cell) > ConvexTileMesh::MostFaces)
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
