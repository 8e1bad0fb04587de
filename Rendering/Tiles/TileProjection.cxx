// Compiled once for each instruction set that the machine may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "TileProjection.cxx"
#include <hwy/foreach_target.h>

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "TileCellFields.h"
#include "TileLitShading.h"
#include "TileProjection.h"
#include "TileScratch.h"

#include "TileClipping-inl.h"
#include "TileCompositing-inl.h"
#include "TileCoverage-inl.h"
#include "TileSetup-inl.h"
#include "TileShading-inl.h"

#include <algorithm>
#include <memory>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
/// Fetches the cells of the group after next and the corners of the next.
inline void PrefetchGroups(const TileTask& task, const std::vector<int>& ids, std::size_t at)
{
  const std::size_t soon = std::min(at + TileGroup::Size, ids.size());
  const std::size_t later = std::min(soon + TileGroup::Size, ids.size());
  const std::size_t last = std::min(later + TileGroup::Size, ids.size());
  for (std::size_t k = later; k < last; ++k)
  {
    hwy::Prefetch(&task.Mesh->Corners[4 * static_cast<std::size_t>(ids[k])]);
  }
  for (std::size_t k = soon; k < later; ++k)
  {
    const int* corners = &task.Mesh->Corners[4 * static_cast<std::size_t>(ids[k])];
    for (int i = 0; i < 4; ++i)
    {
      hwy::Prefetch(&task.Vertices->Values[4 * static_cast<std::size_t>(corners[i])]);
    }
  }
}

inline void PrefetchFields(const TileCellFields& fields, const std::vector<int>& ids,
  std::size_t begin, std::size_t end)
{
  for (std::size_t k = begin; !fields.Values.empty() && k < end; ++k)
  {
    const float* values =
      &fields.Values[TileCellFields::Stride * static_cast<std::size_t>(ids[k])];
    hwy::Prefetch(values);
    hwy::Prefetch(values + TileCellFields::Stride - 1);
  }
}

/// Covers the cells of scratch.Drawn and hands on the queue whenever it is full.
template <class Flush>
void CoverTile(
  const TileTask& task, const TileRectangle& tile, TileScratch& scratch, const Flush& flush)
{
  static const BlockShapes shapes;
  const SetupBounds bounds(task);
  const std::vector<int>& ids = scratch.Drawn;
  scratch.Boxes.resize(ids.size());
  scratch.Fragments.Count = 0;
  scratch.Fragments.NamesCells = task.Lighting != nullptr;
  auto handOn = [&]
  {
    scratch.Fragments.NameCells();
    if (task.Limits)
    {
      ClipFragments(task, tile, scratch.Fragments);
    }
    flush();
    scratch.Fragments.Count = 0;
  };
  for (std::size_t i = 0; i < ids.size(); i += TileGroup::Size)
  {
    const int count = static_cast<int>(std::min<std::size_t>(TileGroup::Size, ids.size() - i));
    PrefetchGroups(task, ids, i);
    if (task.Lighting)
    {
      PrefetchFields(*task.Gradients, ids, i, i + static_cast<std::size_t>(count));
      PrefetchFields(*task.Colors, ids, i, i + static_cast<std::size_t>(count));
    }
    SetUpGroup(task, tile, bounds, &ids[i], count, scratch.Group);
    for (int k = 0; k < count;)
    {
      k = CoverGroup(task, tile, scratch.Group, &ids[i], k, count, shapes, &scratch.Boxes[i],
        scratch.Fragments);
      if (scratch.Fragments.Count >= TileFragments::Full)
      {
        handOn();
      }
    }
  }
  handOn();
}

inline long long ShadeTile(const TileTask& task, const TileRectangle& tile, TileScratch& scratch)
{
  if (!task.Lighting)
  {
    return ShadeFragments(task, tile, scratch.Fragments, scratch.Remainders);
  }
  if (!scratch.LitRemainders)
  {
    scratch.LitRemainders = std::make_unique<TileLitRemainders>();
  }
  return TileLitShading::Shade(task, tile, scratch.Fragments, scratch.LitRemainders->Pieces);
}

inline void RepairTile(const TileTask& task, const TileRectangle& tile, TileScratch& scratch)
{
  TileRepair& repair = scratch.Repair;
  const int wrong = repair.Find(scratch.Buffer);
  if (wrong == 0)
  {
    return;
  }
  scratch.Counts.RepairedPixels += wrong;
  repair.KeepCells(scratch.Drawn, scratch.Boxes);
  CoverTile(task, repair.Box(tile), scratch, [&] { repair.Collect(scratch.Fragments); });
  repair.Sort(*task.View);
  repair.Clear(scratch.Buffer);
  while (repair.Take(scratch.Fragments))
  {
    ShadeTile(task, tile, scratch);
    CompositeFragments<false>(scratch.Fragments, task.Tolerance, scratch.Buffer);
  }
}

inline void WriteTile(const TileTask& task, const TileRectangle& tile, const TileBuffer& buffer)
{
  for (int y = tile.FirstY; y <= tile.LastY; ++y)
  {
    const TileBuffer::Pixel* from = buffer.Pixels + (y - tile.Bottom) * TileSize::Pixels;
    float* to = task.Image + 4 * (static_cast<std::size_t>(y) * task.View->Width + tile.Left);
    for (int x = tile.FirstX; x <= tile.LastX; ++x, ++from, to += 4)
    {
      to[0] = from->Red;
      to[1] = from->Green;
      to[2] = from->Blue;
      to[3] = 1.0f - from->Through;
    }
  }
}

void DrawTile(const TileTask& task, const TileRectangle& tile, TileScratch& scratch)
{
  scratch.Buffer.Clear();
  CoverTile(task, tile, scratch,
    [&]
    {
      TileFragments& fragments = scratch.Fragments;
      scratch.Counts.Fragments += fragments.Count;
      scratch.Counts.Pieces += ShadeTile(task, tile, scratch);
      CompositeFragments<true>(fragments, task.Tolerance, scratch.Buffer);
    });
  scratch.Counts.Cells += static_cast<long long>(scratch.Drawn.size());
  RepairTile(task, tile, scratch);
  WriteTile(task, tile, scratch.Buffer);
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace CellProjectionTiles
{
HWY_EXPORT(DrawTile);
}

//------------------------------------------------------------------------------
void TileProjection::Draw(const TileTask& task, const TileRectangle& tile, TileScratch& scratch)
{
  HWY_DYNAMIC_DISPATCH(CellProjectionTiles::DrawTile)(task, tile, scratch);
}
#endif
