/**
 * What one thread needs to draw tiles; kept from frame to frame.
 */
#ifndef TileScratch_h
#define TileScratch_h

#include "ConvexTileExactCell.h"
#include "TileBuffer.h"
#include "TileClock.h"
#include "TileEntries.h"
#include "TileFragments.h"
#include "TileGroup.h"
#include "TileLitPieces.h"
#include "TileOcclusion.h"
#include "TileOrder.h"
#include "TileRepair.h"
#include "TileTask.h"

#include <cstdint>
#include <memory>
#include <vector>

struct TileScratch
{
  TileGroup Group;
  TileFragments Fragments;
  TileRemainders Remainders[2];
  /** Made by the first frame that needs them. */
  std::unique_ptr<TileLitRemainders> LitRemainders;
  TileBuffer Buffer;
  TileOrder Order;
  TileEntries Entries;
  /** Whether the order of the tile's cells is known to be right. */
  bool IsInOrder = false;
  TileOcclusion Occlusion;
  TileRepair Repair;
  std::vector<int> Drawn;
  /** Where in the tile the drawn cells lie, see TileBox. */
  std::vector<std::uint32_t> Boxes;
  ConvexTileExactCell ExactCell;
  TileCounts Counts;
  TileClock Clock;
};

#endif
