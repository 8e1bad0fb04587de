#include "PolyhedraTiles.h"

#include "CellProjectionFrame.h"
#include "TileCells.h"

#include <algorithm>

//------------------------------------------------------------------------------
std::string PolyhedraTiles::FindObstacle(const CellProjectionFrame& frame)
{
  if (std::max(frame.Size[0], frame.Size[1]) > TileSize::LargestImage)
  {
    return "viewports of more than " + std::to_string(TileSize::LargestImage) + " pixels";
  }
  return "";
}

//------------------------------------------------------------------------------
ConvexTilesFrame::Scene PolyhedraTiles::DescribeScene(
  const CellProjectionFrame& frame, const PreparedVolume& prepared)
{
  ConvexTilesFrame::Scene scene;
  scene.Camera.MeshToView = frame.Rays.MeshToView;
  scene.Camera.ViewToClip = frame.Rays.ViewToClip;
  scene.Camera.ViewToWorld = frame.Rays.ViewToWorld;
  scene.Camera.Width = frame.Size[0];
  scene.Camera.Height = frame.Size[1];
  scene.Function = &prepared.Function;
  scene.OpaqueDepth = frame.OpaqueDepths.empty() ? nullptr : frame.OpaqueDepths.data();
  scene.ClippingPlanes = frame.ClippingPlanes;
  return scene;
}
