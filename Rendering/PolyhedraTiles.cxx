#include "PolyhedraTiles.h"

#include "CellProjectionFrame.h"
#include "TilesFrame.h"

//------------------------------------------------------------------------------
ConvexTilesFrame::Scene PolyhedraTiles::DescribeScene(
  const CellProjectionFrame& frame, const PreparedVolume& prepared)
{
  ConvexTilesFrame::Scene scene;
  scene.Camera = TilesFrame::GetCamera(frame);
  scene.Function = &prepared.Function;
  scene.OpaqueDepth = frame.OpaqueDepths;
  scene.ClippingPlanes = frame.ClippingPlanes;
  scene.IsAborted = TilesFrame::GetAbortCheck(frame);
  return scene;
}
