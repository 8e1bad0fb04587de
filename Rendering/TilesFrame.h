/**
 * What every Tiles engine takes from a frame.
 */
#ifndef TilesFrame_h
#define TilesFrame_h

#include "TileLoop.h"
#include "TileView.h"

#include <string>

struct CellProjectionFrame;

namespace TilesFrame
{
/** What keeps the engines from drawing this frame, whatever the mapper; empty where nothing does. */
std::string FindObstacle(const CellProjectionFrame& frame);
TileView::Camera GetCamera(const CellProjectionFrame& frame);
/** Asks the window, and once others draw the frame, which must outlive it. */
TileLoop::AbortCheck GetAbortCheck(const CellProjectionFrame& frame);
}

#endif
