// Compiled once for each instruction set that the machine may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "EmissionProjection.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "EmissionProjection.h"
#include "TileScratch.h"

#include "ConvexTileCoverage-inl.h"
#include "EmissionShading-inl.h"
#include "TileClipping-inl.h"

#include <algorithm>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// The fragments of a vector from `at` on.
template <class Number>
HWY_INLINE void AddVector(const TileFragments& q, int at, Number count, TileBuffer& tile)
{
  const hn::CappedTag<float, 4> d;
  for (int i = 0; i < count; ++i)
  {
    const float* color = q.Slots[at + ColorSlot(i)];
    float* sum = &tile.Pixels[q.Pixel[at + i]].Red;
    for (std::size_t k = 0; k < 4; k += hn::Lanes(d))
    {
      hn::Store(hn::Add(hn::Load(d, color + k), hn::Load(d, sum + k)), d, sum + k);
    }
  }
}

inline void AddFragments(const TileFragments& q, TileBuffer& tile)
{
  constexpr int lanes = static_cast<int>(hn::MaxLanes(ColorFloat()));
  int at = 0;
  for (; at + lanes <= q.Count; at += lanes)
  {
    AddVector(q, at, std::integral_constant<int, lanes>(), tile);
  }
  AddVector(q, at, q.Count - at, tile);
}

// NOLINTNEXTLINE: Highway's dispatch table names it.
void DrawEmission(const ConvexTileTask& task, const TileRectangle& tile, const int* cells,
  int count, const EmissionTable& table, TileScratch& scratch)
{
  static const BlockShapes shapes;
  const TileView& view = *task.Common.View;
  TileFragments& q = scratch.Fragments;
  std::fill_n(scratch.Buffer.Pixels, TileSize::Pixels * TileSize::Pixels, TileBuffer::Pixel{ 0.0f, 0.0f, 0.0f, 0.0f });
  // In no order, nothing is ever opaque.
  q.Full = TileFragments::Longest;
  q.Count = 0;
  auto flush = [&]
  {
    if (task.Common.Limits)
    {
      ClipFragments(task.Common, tile, q);
    }
    scratch.Counts.Fragments += q.Count;
    scratch.Counts.Pieces += ShadeEmission(table, view, tile, q, scratch.Remainders).Pieces;
    AddFragments(q, scratch.Buffer);
    q.Count = 0;
  };
  for (int i = 0; i < count; ++i)
  {
    FetchAhead(task, cells, i, count);
    if (IsCutOff(task, cells[i], CellBox(task.Cells->Boxes[cells[i]], tile)))
    {
      ++scratch.Counts.HiddenCells;
      continue;
    }
    CoverAnyConvexCell(task, tile, cells[i], shapes, scratch.ExactCell, q, flush);
    if (q.Count >= q.Full)
    {
      flush();
    }
  }
  flush();
  scratch.Counts.Cells += count;
  for (int y = tile.FirstY; y <= tile.LastY; ++y)
  {
    const float* row = &scratch.Buffer.Pixels[(y - tile.Bottom) * TileSize::Pixels].Red;
    std::copy_n(row, 4 * (tile.LastX - tile.Left + 1),
      task.Common.Image + 4 * (static_cast<std::size_t>(y) * view.Width + tile.Left));
  }
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace CellProjectionTiles
{
HWY_EXPORT(DrawEmission);
}

//------------------------------------------------------------------------------
void EmissionProjection::Draw(const ConvexTileTask& task, const TileRectangle& tile,
  const int* cells, int count, const EmissionTable& table, TileScratch& scratch)
{
  HWY_DYNAMIC_DISPATCH(CellProjectionTiles::DrawEmission)
  (task, tile, cells, count, table, scratch);
}
#endif
