/**
 * Cuts fragments at the limits of their pixels; those with nothing left go.
 */
#if defined(TileClipping_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileClipping_inl_h
#undef TileClipping_inl_h
#else
#define TileClipping_inl_h
#endif

#include "TileFragments.h"
#include "TileLimits.h"
#include "TileTask.h"
#include "TileView.h"

#include <algorithm>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
inline void ClipFragments(const TileTask& task, const TileRectangle& tile, TileFragments& q)
{
  const TileLimits& limits = *task.Limits;
  int kept = 0;
  for (int i = 0; i < q.Count; ++i)
  {
    const int x = tile.Left + q.Pixel[i] % TileSize::Pixels;
    const int y = tile.Bottom + q.Pixel[i] / TileSize::Pixels;
    const std::size_t pixel = static_cast<std::size_t>(y) * task.View->Width + x;
    const float entry = q.Entry[i], extent = q.Extent[i];
    // Counted from the entry: thin cells keep their digits.
    const float begin = std::max(0.0f, entry - limits.Near[pixel]);
    const float end = std::min(extent, entry - limits.Far[pixel]);
    if (begin < end)
    {
      const float change = (q.ScalarOut[i] - q.ScalarIn[i]) / extent;
      const float scalarIn = q.ScalarIn[i];
      q.Entry[kept] = entry - begin;
      q.Extent[kept] = end - begin;
      q.ScalarIn[kept] = scalarIn + begin * change;
      q.ScalarOut[kept] = end < extent ? scalarIn + end * change : q.ScalarOut[i];
      q.Pixel[kept] = q.Pixel[i];
      q.Cell[kept] = q.Cell[i];
      ++kept;
    }
  }
  q.Count = kept;
}
}
}
HWY_AFTER_NAMESPACE();

#endif
