/**
 * Fetches what a stage needs of cells before their turn.
 *
 * Inlined: g++ takes a call of what does nothing else for one without effect, and leaves it out.
 */
#ifndef TilePrefetch_h
#define TilePrefetch_h

#include "TileMesh.h"
#include "TileTask.h"
#include "TileVertices.h"

#include <hwy/cache_control.h>

#include <cstddef>

/** Which corners a cell has. */
HWY_INLINE void PrefetchCorners(const TileTask& task, int cell)
{
  hwy::Prefetch(&task.Mesh->Corners[4 * static_cast<std::size_t>(cell)]);
}

/** Where its corners are on the screen. */
HWY_INLINE void PrefetchPlaces(const TileTask& task, int cell)
{
  const int* corners = &task.Mesh->Corners[4 * static_cast<std::size_t>(cell)];
  for (int i = 0; i < 4; ++i)
  {
    hwy::Prefetch(&task.Vertices->Values[4 * static_cast<std::size_t>(corners[i])]);
  }
}

#endif
