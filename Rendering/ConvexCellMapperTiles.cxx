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
#include <utility>

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
bool vtkConvexCellMapper::FindOpaque(CellProjectionFrame& frame)
{
  const int around = static_cast<int>(std::ceil(frame.Statistics.ImageSampleDistance));
  const bool isRead =
    this->Internal->Depth.Read(frame.Window, frame.Origin, frame.GetWidenedBox(around));
  this->WarnOnce(MapperMessages::UnreadableDepth(isRead));
  return !this->Internal->Depth.GetPixels().AreClear();
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::TakeOpaqueDepth(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  internal.Depth.GetPixels().Expand(frame.Size[0], frame.Size[1], internal.OpaqueDepths);
  frame.OpaqueDepths = frame.Statistics.ImageSampleDistance > 1.0
    ? internal.Coarse.ReduceDepths(internal.OpaqueDepths).data()
    : internal.OpaqueDepths.data();
}

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::LookAtWindow(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  frame.ReturnToWindow();
  frame.HoldsColors = !this->CaptureImage && EngineChoice::IsSoftware() &&
                      internal.Pixels.Read(frame.Window, frame.Origin, frame.Box);
  internal.HadOpaque = this->FindOpaque(frame);
  return internal.HadOpaque;
}

//------------------------------------------------------------------------------
const float* vtkConvexCellMapper::DrawTilesAsSeen(CellProjectionFrame& frame)
{
  const FrameStatistics before = frame.Statistics;
  bool hasLooked = false, isOpaque = false;
  auto look = [&]
  {
    isOpaque = std::exchange(hasLooked, true) ? isOpaque : this->LookAtWindow(frame);
    return isOpaque;
  };
  // Most scenes have nothing opaque, and tiles need not wait for the window's pixels then.
  if (!this->Internal->HadOpaque || !look())
  {
    frame.FindsOpaque = look;
    const float* image = this->DrawTiles(frame);
    frame.FindsOpaque = nullptr;
    const bool isDone = image ? !look() : !isOpaque;
    if (isDone)
    {
      return image;
    }
  }
  frame.Statistics = before;
  this->TakeOpaqueDepth(frame);
  return this->DrawTiles(frame);
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
  const float* image = this->DrawTilesAsSeen(frame);
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
  const bool isLaid = frame.HoldsColors && internal.Pixels.LayOver(frame.Pixels, frame.Size[0]);
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
