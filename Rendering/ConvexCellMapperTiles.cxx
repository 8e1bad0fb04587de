// How vtkConvexCellMapper draws by Tiles: as fine as the time allows, and enlarged to the viewport.

#include "ConvexCellMapperInternals.h"
#include "vtkConvexCellMapper.h"
#include "vtkVolume.h"

#include <cmath>

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
bool vtkConvexCellMapper::ProjectByTiles(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  internal.Depth.Read(frame.OpaqueDepths);
  const double distance = this->ChooseImageSampleDistance(frame);
  frame.Statistics.ImageSampleDistance = distance;
  const bool isCoarse = distance > 1.0;
  if (isCoarse)
  {
    internal.Coarse.SetSize(frame.Size[0], frame.Size[1], distance);
    frame.OpaqueDepths = internal.Coarse.ReduceDepths(frame.OpaqueDepths);
    frame.ImageSize[0] = internal.Coarse.GetWidth();
    frame.ImageSize[1] = internal.Coarse.GetHeight();
    frame.WidenBox(static_cast<int>(std::ceil(distance)));
  }
  const float* image = this->DrawTiles(frame);
  if (!frame.Window->IsCurrent())
  {
    // What the abort check woke has drawn elsewhere.
    frame.Window->MakeCurrent();
  }
  const float* enlarged = image && isCoarse ? internal.Coarse.Enlarge(image) : image;
  const bool isDrawn = internal.Target.Upload(frame.Window, frame.Size, frame.Box, enlarged);
  frame.Statistics.CellsDrawn = isDrawn ? frame.Statistics.CellsDrawn : 0;
  return isDrawn;
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
