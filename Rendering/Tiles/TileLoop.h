/**
 * Draws the tiles of a frame on all cores, unless the frame is given up.
 *
 * Whether it is given up is asked at the start and before every tile of the thread that called: a
 * window may only be asked from there. Where that thread does not work itself (vtkSMPTools'
 * STDThread), it is asked after as many tiles as are in a row.
 */
#ifndef TileLoop_h
#define TileLoop_h

#include <functional>
#include <vector>

class TileScratchPool;
struct TileScratch;

namespace TileLoop
{
/** True where the frame is given up; empty where it never is. */
using AbortCheck = std::function<bool()>;
using Drawer = std::function<void(int tile, TileScratch& scratch)>;

/** Threads take the tiles one by one in this order; `row`: how many are a row of the image. False
 *  where the frame was given up: not all tiles are drawn. */
bool Run(const std::vector<int>& tiles, int row, const AbortCheck& isAborted, TileScratchPool& pool,
  const Drawer& draw);
}

#endif
