#include "TilesFrame.h"

#include "CellProjectionFrame.h"
#include "TileCells.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

//------------------------------------------------------------------------------
std::string TilesFrame::FindObstacle(const CellProjectionFrame& frame)
{
  if (std::max(frame.Size[0], frame.Size[1]) > TileSize::LargestImage)
  {
    return "viewports of more than " + std::to_string(TileSize::LargestImage) + " pixels";
  }
  return "";
}

//------------------------------------------------------------------------------
TileView::Camera TilesFrame::GetCamera(const CellProjectionFrame& frame)
{
  TileView::Camera camera;
  camera.MeshToView = frame.Rays.MeshToView;
  camera.ViewToClip = frame.Rays.ViewToClip;
  camera.ViewToWorld = frame.Rays.ViewToWorld;
  camera.Width = frame.ImageSize[0];
  camera.Height = frame.ImageSize[1];
  return camera;
}

//------------------------------------------------------------------------------
TileLoop::AbortCheck TilesFrame::GetAbortCheck(const CellProjectionFrame& frame)
{
  return [&frame, isFirst = true]() mutable
  {
    // The first question comes before others draw: they would wait for the window.
    const bool othersDraw = !isFirst;
    isFirst = false;
    return frame.Window->CheckAbortStatus() != 0 ||
           (othersDraw && frame.FindsOpaque && frame.FindsOpaque());
  };
}
