// Compiled once for each instruction set that the machine may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ExtremumProjection.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "ExtremumProjection.h"
#include "TileScratch.h"

#include "ConvexTileCoverage-inl.h"
#include "TileClipping-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// The greatest scalars of a tile's pixels, row by row.
struct ExtremumTile
{
  /// A vector may begin at the last pixel.
  alignas(64) float Values[TileSize::Pixels * TileSize::Pixels + 64];

  ExtremumTile() { std::fill_n(this->Values, sizeof(this->Values) / 4, ExtremumProjection::Nothing); }

  /// Whether every pixel of a box has a value of at least `scalar`.
  bool HasAtLeast(float scalar, const CellBox& box, const TileRectangle& tile) const
  {
    const CoverFloat d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const auto wanted = hn::Set(d, scalar);
    const int width = box.LastX - box.FirstX + 1;
    for (int y = box.FirstY; y <= box.LastY; ++y)
    {
      const float* row =
        this->Values + (y - tile.Bottom) * TileSize::Pixels + box.FirstX - tile.Left;
      for (int x = 0; x < width; x += lanes)
      {
        const auto used = hn::FirstN(d, static_cast<std::size_t>(width - x));
        if (!hn::AllFalse(d, hn::And(used, hn::Lt(hn::LoadU(d, row + x), wanted))))
        {
          return false;
        }
      }
    }
    return true;
  }

  /// Fragments of a cell whose scalars are at most `greatest`.
  void Take(const TileView& view, float greatest, TileFragments& q)
  {
    const CoverFloat d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const auto scale = hn::Set(d, static_cast<float>(view.WeightScale));
    const auto offset = hn::Set(d, static_cast<float>(view.WeightOffset));
    for (int at = 0; at < q.Count; at += lanes)
    {
      const auto entry = hn::Load(d, q.Entry + at), extent = hn::Load(d, q.Extent + at);
      const auto weightIn = hn::MulAdd(scale, entry, offset);
      const auto weightOut = hn::NegMulAdd(scale, extent, weightIn);
      const auto in = hn::Div(hn::Load(d, q.ScalarIn + at), weightIn);
      const auto larger = hn::Max(in, hn::Div(hn::Load(d, q.ScalarOut + at), weightOut));
      // Rounding must not exceed it: which cells are left out would show.
      hn::Store(hn::Min(larger, hn::Set(d, greatest)), d, q.ScalarIn + at);
    }
    for (int i = 0; i < q.Count; ++i)
    {
      float& value = this->Values[q.Pixel[i]];
      value = std::max(value, q.ScalarIn[i]);
    }
    q.Count = 0;
  }

  void CopyTo(const TileRectangle& tile, int width, float* extrema) const
  {
    for (int y = tile.FirstY; y <= tile.LastY; ++y)
    {
      std::copy_n(this->Values + (y - tile.Bottom) * TileSize::Pixels, tile.LastX - tile.Left + 1,
        extrema + static_cast<std::size_t>(y) * width + tile.Left);
    }
  }
};

/// One cell, whose scalars are at most `greatest`.
inline void TakeCell(const ConvexTileTask& task, const TileRectangle& tile, int cell, float greatest,
  const BlockShapes& shapes, TileScratch& scratch, ExtremumTile& values)
{
  TileFragments& q = scratch.Fragments;
  auto flush = [&]
  {
    scratch.Counts.Fragments += q.Count;
    if (task.Common.Limits)
    {
      ClipFragments(task.Common, tile, q);
    }
    values.Take(*task.Common.View, greatest, q);
  };
  CoverAnyConvexCell(task, tile, cell, shapes, scratch.ExactCell, q, flush);
  flush();
  ++scratch.Counts.Cells;
}

// NOLINTNEXTLINE: Highway's dispatch table names it.
void DrawExtrema(const ConvexTileTask& task, const TileRectangle& tile, const int* cells, int count,
  const float* greatest, TileScratch& scratch, float* extrema)
{
  static const BlockShapes shapes;
  // Cells in vain after which all of the tile is looked at.
  constexpr int Worthwhile = 32;
  ExtremumTile values;
  int inVain = 0;
  scratch.Fragments.Count = 0;
  for (int i = 0; i < count; ++i)
  {
    const int cell = cells[i];
    const CellBox box(task.Cells->Boxes[cell], tile);
    if (values.HasAtLeast(greatest[cell], box, tile))
    {
      ++inVain;
      if (inVain % Worthwhile == 0 && values.HasAtLeast(greatest[cell], CellBox(tile), tile))
      {
        // Those that follow hold nothing greater.
        break;
      }
    }
    else if (IsCutOff(task, cell, box))
    {
      ++scratch.Counts.HiddenCells;
    }
    else
    {
      FetchAhead(task, cells, i, count);
      TakeCell(task, tile, cell, greatest[cell], shapes, scratch, values);
    }
  }
  values.CopyTo(tile, task.Common.View->Width, extrema);
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace CellProjectionTiles
{
HWY_EXPORT(DrawExtrema);
}

//------------------------------------------------------------------------------
void ExtremumProjection::Draw(const ConvexTileTask& task, const TileRectangle& tile,
  const int* cells, int count, const float* greatest, TileScratch& scratch, float* extrema)
{
  HWY_DYNAMIC_DISPATCH(CellProjectionTiles::DrawExtrema)
  (task, tile, cells, count, greatest, scratch, extrema);
}
#endif
