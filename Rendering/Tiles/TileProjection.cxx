// Compiled once for each instruction set that the machine may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "TileProjection.cxx"
#include <hwy/foreach_target.h>

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "TileCellFields.h"
#include "TileLitShading.h"
#include "TilePrefetch.h"
#include "TileProjection.h"
#include "TileScratch.h"

#include "TileClipping-inl.h"
#include "TileCompositing-inl.h"
#include "TileCoverage-inl.h"
#include "TileSetup-inl.h"
#include "TileShading-inl.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
/// Fetches the corners of the cells from `begin` to `end`, and the cells of a group after that.
HWY_INLINE void PrefetchCells(
  const TileTask& task, const std::vector<int>& ids, std::size_t begin, std::size_t end)
{
  const std::size_t soon = std::min(begin, ids.size());
  const std::size_t later = std::min(end, ids.size());
  const std::size_t last = std::min(end + end - begin, ids.size());
  for (std::size_t k = later; k < last; ++k)
  {
    PrefetchCorners(task, ids[k]);
  }
  for (std::size_t k = soon; k < later; ++k)
  {
    PrefetchPlaces(task, ids[k]);
  }
}

HWY_INLINE void PrefetchFields(const TileCellFields& fields, const std::vector<int>& ids,
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

/// Moves the next cells that nothing hides to `at`, a group at most, and the hidden ones behind them;
/// returns how many, and `next` behind the last one that was looked at.
inline int TakeGroup(const TileTask& task, const TileRectangle& tile, std::size_t at,
  std::size_t& next, TileScratch& scratch)
{
  std::vector<int>& ids = scratch.Drawn;
  if (!scratch.Occlusion.HidesAny())
  {
    const auto count = std::min<std::size_t>(TileGroup::Size, ids.size() - next);
    next += count;
    PrefetchCells(task, ids, next, next + TileGroup::Size);
    return static_cast<int>(count);
  }
  std::size_t end = at;
  // Few at a time: what they hide is seen between groups.
  for (; next < ids.size() && end < at + TileGroup::Batch; ++next)
  {
    if (next % TileGroup::Batch == 0)
    {
      PrefetchCells(task, ids, next + TileGroup::Batch, next + 2 * TileGroup::Batch);
    }
    std::uint32_t box = 0;
    if (scratch.Occlusion.HidesCell(task, tile, ids[next], box))
    {
      scratch.Boxes[next] = box;
      continue;
    }
    std::swap(ids[end], ids[next]);
    scratch.Boxes[next] = scratch.Boxes[end++];
  }
  return static_cast<int>(end - at);
}

/// Covers the cells of scratch.Drawn and hands on the queue whenever it is full; cells that are hidden
/// end up last.
template <class Flush>
void CoverTile(
  const TileTask& task, const TileRectangle& tile, TileScratch& scratch, const Flush& flush)
{
  const SetupBounds bounds(task);
  std::vector<int>& ids = scratch.Drawn;
  scratch.Boxes.resize(ids.size());
  scratch.Fragments.Full = scratch.Occlusion.QueueLength();
  scratch.Fragments.Count = 0;
  scratch.Fragments.NamesCells = task.Lighting != nullptr;
  scratch.Fragments.CountsLanes = scratch.Clock.GetIsOn();
  auto handOn = [&]
  {
    scratch.Counts.CoveredLanes += scratch.Fragments.Count;
    scratch.Fragments.NameCells();
    if (task.Limits)
    {
      ClipFragments(task, tile, scratch.Fragments);
    }
    flush();
    scratch.Fragments.Full = scratch.Occlusion.QueueLength();
    scratch.Fragments.Count = 0;
  };
  std::size_t next = 0, at = 0;
  while (next < ids.size())
  {
    const int count = TakeGroup(task, tile, at, next, scratch);
    if (count == 0)
    {
      break;
    }
    const std::size_t end = at + static_cast<std::size_t>(count);
    if (task.Lighting)
    {
      PrefetchFields(*task.Gradients, ids, at, end);
      PrefetchFields(*task.Colors, ids, at, end);
    }
    SetUpGroup(task, tile, bounds, &ids[at], count, scratch.Group);
    scratch.Clock.Lap(TileStages::SetUp);
    for (int k = 0; k < count;)
    {
      k = CoverGroup(
        task, tile, scratch.Group, &ids[at], k, count, &scratch.Boxes[at], scratch.Fragments, handOn);
      if (scratch.Fragments.Count >= scratch.Fragments.Full)
      {
        handOn();
      }
    }
    scratch.Clock.Lap(TileStages::Cover);
    at = end;
  }
  scratch.Counts.HiddenCells += static_cast<long long>(ids.size() - at);
  handOn();
  scratch.Counts.LanesOfBlocks += scratch.Fragments.LanesOfBlocks;
  scratch.Fragments.LanesOfBlocks = 0;
}

inline TileShadeCount ShadeTile(const TileTask& task, const TileRectangle& tile, TileScratch& scratch)
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
  scratch.Occlusion.Clear(task, tile, false);
  CoverTile(task, repair.Box(tile), scratch,
    [&]
    {
      scratch.Clock.Lap(TileStages::Cover);
      repair.Collect(scratch.Fragments);
      scratch.Clock.Lap(TileStages::Repair);
    });
  repair.Sort(*task.View);
  repair.Clear(scratch.Buffer);
  while (repair.Take(scratch.Fragments))
  {
    scratch.Clock.Lap(TileStages::Repair);
    ShadeTile(task, tile, scratch);
    scratch.Clock.Lap(TileStages::Shade);
    CompositeFragments<false>(scratch.Fragments, task.Tolerance, scratch.Buffer);
    scratch.Clock.Lap(TileStages::Composite);
  }
}

/// So many floats of pixels, a multiple of 4: red, green, blue and 1 less what shines through.
template <std::size_t Count>
HWY_INLINE void WritePixels(const float* from, float* to)
{
  const hn::CappedTag<float, Count> d;
  HWY_ALIGN static constexpr float scale[16] = { 1, 1, 1, -1, 1, 1, 1, -1, 1, 1, 1, -1, 1, 1, 1, -1 };
  HWY_ALIGN static constexpr float offset[16] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  for (std::size_t i = 0; i < Count; i += hn::Lanes(d))
  {
    const auto pixels = hn::Load(d, from + i);
    hn::StoreU(hn::MulAdd(pixels, hn::Load(d, scale + i), hn::Load(d, offset + i)), d, to + i);
  }
}

inline void WriteTile(const TileTask& task, const TileRectangle& tile, const TileBuffer& buffer)
{
  const int size = 4 * (tile.LastX + 1 - tile.Left);
  for (int y = tile.FirstY; y <= tile.LastY; ++y)
  {
    const float* from = &buffer.Pixels[(y - tile.Bottom) * TileSize::Pixels].Red;
    float* to = task.Image + 4 * (static_cast<std::size_t>(y) * task.View->Width + tile.Left);
    int i = 0;
    for (; i + 16 <= size; i += 16)
    {
      WritePixels<16>(from + i, to + i);
    }
    for (; i < size; i += 4)
    {
      WritePixels<4>(from + i, to + i);
    }
  }
}

void DrawTile(const TileTask& task, const TileRectangle& tile, TileScratch& scratch)
{
  TileFragments& fragments = scratch.Fragments;
  TileBuffer& buffer = scratch.Buffer;
  buffer.Clear(tile.LastY + 1 - tile.Bottom, !scratch.IsInOrder);
  scratch.Occlusion.Clear(task, tile, scratch.IsInOrder);
  scratch.Clock.Lap(TileStages::Write);
  CoverTile(task, tile, scratch,
    [&]
    {
      scratch.Counts.Fragments += fragments.Count;
      scratch.Counts.TrustedFragments += scratch.IsInOrder ? fragments.Count : 0;
      scratch.Clock.Lap(TileStages::Cover);
      const TileShadeCount shaded = ShadeTile(task, tile, scratch);
      scratch.Counts.Pieces += shaded.Pieces;
      scratch.Counts.ShadedLanes += shaded.Lanes;
      scratch.Clock.Lap(TileStages::Shade);
      scratch.IsInOrder ? CompositeFragments<false>(fragments, task.Tolerance, buffer)
                        : CompositeFragments<true>(fragments, task.Tolerance, buffer);
      scratch.Occlusion.Watch(fragments, buffer);
      scratch.Clock.Lap(TileStages::Composite);
    });
  scratch.Counts.Cells += static_cast<long long>(scratch.Drawn.size());
  RepairTile(task, tile, scratch);
  scratch.Clock.Lap(TileStages::Repair);
  WriteTile(task, tile, buffer);
  scratch.Clock.Lap(TileStages::Write);
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
