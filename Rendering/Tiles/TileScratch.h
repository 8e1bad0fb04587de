/**
 * What one thread needs to draw tiles; kept from frame to frame.
 */
#ifndef TileScratch_h
#define TileScratch_h

#include "TileBuffer.h"
#include "TileFragments.h"
#include "TileGroup.h"
#include "TileOrder.h"
#include "TileRepair.h"
#include "TileTask.h"

#include <vector>

struct TileScratch
{
  TileGroup Group;
  TileFragments Fragments;
  TileRemainders Remainders[2];
  TileBuffer Buffer;
  TileOrder Order;
  TileRepair Repair;
  std::vector<int> Drawn;
  TileCounts Counts;
};

#endif
