// When and how vtkConvexCellMapper draws by Tiles: as fine as the time allows, and enlarged to the
// viewport.

#include "ConvexCellMapperInternals.h"
#include "EngineChoice.h"
#include "MapperMessages.h"
#include "VTKVersions.h"
#include "vtkConvexCellMapper.h"
#include "vtkVolume.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <cmath>

//------------------------------------------------------------------------------
void vtkConvexCellMapper::ChooseEngine(CellProjectionFrame& frame)
{
  const std::string obstacle = this->FindTilesObstacle(frame);
  frame.UsesTiles = EngineChoice::UsesTiles(this->Engine, obstacle);
  frame.Statistics.Engine = frame.UsesTiles ? "Tiles" : "Raster";
  if (frame.UsesTiles)
  {
    // Software draws what the scene asked for so far while we prepare; its depth is read then.
    glFlush();
  }
  if (this->Engine == TILES && !obstacle.empty())
  {
    this->WarnOnce("The Tiles engine does not draw " + obstacle + ": drawn by Raster.");
  }
}

//------------------------------------------------------------------------------
double vtkConvexCellMapper::ChooseImageSampleDistance(CellProjectionFrame& frame) const
{
  if (!this->AutoAdjustSampleDistances)
  {
    return this->ImageSampleDistance;
  }
  const ImageSampling::Limits limits{ this->MinimumImageSampleDistance,
    this->MaximumImageSampleDistance };
  const double pixels = static_cast<double>(frame.Size[0]) * frame.Size[1];
  return this->Internal->Sampling.Choose(frame.Volume->GetAllocatedRenderTime(), pixels, limits);
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::ReadOpaqueDepth(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  const double distance = frame.Statistics.ImageSampleDistance;
  const bool isRead = internal.Depth.Read(
    frame.Window, frame.Origin, frame.GetWidenedBox(static_cast<int>(std::ceil(distance))));
  this->WarnOnce(MapperMessages::UnreadableDepth(isRead));
  const DepthPixels& pixels = internal.Depth.GetPixels();
  if (pixels.AreClear())
  {
    return;
  }
  pixels.Expand(frame.Size[0], frame.Size[1], internal.OpaqueDepths);
  frame.OpaqueDepths = distance > 1.0 ? internal.Coarse.ReduceDepths(internal.OpaqueDepths).data()
                                      : internal.OpaqueDepths.data();
}

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::ProjectByTiles(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  const double distance = this->ChooseImageSampleDistance(frame);
  frame.Statistics.ImageSampleDistance = distance;
  const bool isCoarse = distance > 1.0;
  if (isCoarse)
  {
    internal.Coarse.SetSize(frame.Size[0], frame.Size[1], distance);
    frame.ImageSize[0] = internal.Coarse.GetWidth();
    frame.ImageSize[1] = internal.Coarse.GetHeight();
    frame.Box = frame.GetWidenedBox(static_cast<int>(std::ceil(distance)));
  }
  this->ReadOpaqueDepth(frame);
  const float* image = this->DrawTiles(frame);
  // What the abort check wakes.
  frame.ReturnToWindow();
  frame.Pixels = image && isCoarse ? internal.Coarse.Enlarge(image) : image;
  frame.Statistics.CellsDrawn = image ? frame.Statistics.CellsDrawn : 0;
  return image != nullptr;
}

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::LayPixelsOver(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  const bool isLaid = !this->CaptureImage && EngineChoice::IsSoftware() &&
                      internal.Pixels.LayOver(
                        frame.Window, frame.Origin, frame.Box, frame.Pixels, frame.Size[0]);
  if (!isLaid)
  {
    internal.Target.Upload(frame.Window, frame.Size, frame.Box, frame.Pixels);
  }
  return isLaid;
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::RecordSampling(const CellProjectionFrame& frame, bool isDrawn)
{
  const FrameStatistics& s = frame.Statistics;
  const double seconds = s.SecondsSort + s.SecondsProject + s.SecondsBlend;
  const ImageSampling::Rays rays{ static_cast<double>(frame.Size[0]) * frame.Size[1],
    s.ImageSampleDistance };
  if (frame.UsesTiles && isDrawn)
  {
    this->Internal->Sampling.Record(rays, seconds);
  }
  else if (frame.UsesTiles)
  {
    this->Internal->Sampling.RecordGivenUp(rays, seconds);
  }
}
