#include "vtkBarycentricShellMapper.h"

#include "CellProjectionFrame.h"
#include "ElementBuffers.h"
#include "MeshExtent.h"
#include "PreparedVolume.h"
#include "ShellCells.h"
#include "ShellPlan.h"
#include "ShellRaster.h"
#include "TetrahedraSelection.h"
#include "TurnedCells.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTimeStamp.h"

#include <cmath>

vtkStandardNewMacro(vtkBarycentricShellMapper);

/// What the mapper keeps from frame to frame.
class vtkBarycentricShellMapper::Internals
{
public:
  TetrahedraSelection Selection;
  vtkTimeStamp CornersTime;
  vtkTimeStamp SelectionTime;
  TurnedCells Turned;
  vtkTimeStamp TurnedTime;
  ShellCells Cells;
  ShellPlan Plan;
  ElementBuffers Buffers;
  ShellRaster Raster;
  vtkIdType TargetBytes = 0;
};

//------------------------------------------------------------------------------
vtkBarycentricShellMapper::vtkBarycentricShellMapper()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkBarycentricShellMapper::~vtkBarycentricShellMapper()
{
  this->LeaveWindow();
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::SetSampleDistance(double distance)
{
  if (!(distance > 0.0) || !std::isfinite(distance))
  {
    vtkErrorMacro("SampleDistance is " << distance << ": it must be positive; "
                                       << this->SampleDistance << " stays.");
  }
  else if (distance != this->SampleDistance || this->SamplesPerRay != 0.0)
  {
    this->SampleDistance = distance;
    this->SamplesPerRay = 0.0;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::SetSamplesPerRay(double samples)
{
  if (!(samples > 0.0) || !std::isfinite(samples))
  {
    vtkErrorMacro("SamplesPerRay is " << samples << ": it must be positive; "
                                      << this->SamplesPerRay << " stays.");
  }
  else if (samples != this->SamplesPerRay)
  {
    this->SamplesPerRay = samples;
    this->SampleDistance = 0.0;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::SetSamplesPerShell(int samples)
{
  if (samples != 4 && samples != 8 && samples != 16)
  {
    vtkErrorMacro("SamplesPerShell is " << samples << ": it is 4, 8 or 16.");
  }
  else if (samples != this->SamplesPerShell)
  {
    this->SamplesPerShell = samples;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::SelectCells()
{
  Internals& internal = *this->Internal;
  const PreparedVolume& prepared = this->GetPreparedVolume();
  if (internal.CornersTime < prepared.CellsTime)
  {
    internal.Selection.TakeCorners(prepared.Cells);
    internal.CornersTime.Modified();
  }
  if (internal.SelectionTime < internal.CornersTime ||
      internal.SelectionTime < prepared.FunctionTime)
  {
    internal.Selection.Classify(prepared.Scalars, prepared.Function);
    internal.SelectionTime.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::CountTurnedCells()
{
  Internals& internal = *this->Internal;
  const PreparedVolume& prepared = this->GetPreparedVolume();
  const std::vector<float>& points = prepared.Coordinates.Points;
  const vtkIdType before = this->NumberOfTurnedCells;
  if (internal.TurnedTime < prepared.CellsTime)
  {
    internal.Turned.TakeSides(points, internal.Selection.Corners);
    this->NumberOfTurnedCells = 0;
  }
  else if (internal.TurnedTime < prepared.PointsTime)
  {
    this->NumberOfTurnedCells = internal.Turned.Count(points, internal.Selection.Corners);
  }
  internal.TurnedTime.Modified();
  // Their number changes with every frame: it is said once, until all are well again.
  if (before == 0 && this->NumberOfTurnedCells > 0)
  {
    vtkWarningMacro("Moved points have turned " << this->NumberOfTurnedCells
                                                << " tetrahedra inside out: they are drawn as they "
                                                   "are, see GetNumberOfTurnedCells().");
  }
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::SortCells(CellProjectionFrame& frame)
{
  // Shells need no order: there are only distances from the eye to find.
  FrameStatistics::Timer timer(frame.Statistics.SecondsPrepare);
  this->SelectCells();
  this->CountTurnedCells();
  Internals& internal = *this->Internal;
  internal.Cells.Build(this->GetPreparedVolume().Coordinates.Points, internal.Selection.Corners,
    internal.Selection, frame.GetRasterView());
  this->FillStatistics(frame);
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::FillStatistics(CellProjectionFrame& frame)
{
  const TetrahedraSelection& selection = this->Internal->Selection;
  const ShellCells& cells = this->Internal->Cells;
  frame.Statistics.CellsSkippedTransparent = selection.NumberOfTransparentCells;
  frame.Statistics.CellsSkippedInvalid += selection.NumberOfInvalidCells + cells.NumberOfLostCells;
  frame.Statistics.CellsSkippedOutside = cells.NumberOfOutsideCells;
  frame.Statistics.CellsDrawn = cells.NumberOfSeenCells;
}

//------------------------------------------------------------------------------
bool vtkBarycentricShellMapper::PlanShells(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  const RasterView view = frame.GetRasterView();
  const double spacing = this->SampleDistance > 0.0
                           ? this->SampleDistance
                           : MeshExtent::FindDiagonal(this->GetPreparedVolume().Coordinates, view) /
                               this->SamplesPerRay;
  const double slices = ShellPlan::CountSlices(internal.Cells.Range, spacing);
  if (!(slices <= ShellPlan::MaximumNumberOfSlices))
  {
    this->FailOnce("A distance of " + std::to_string(spacing) + " between samples would take " +
                   std::to_string(slices) + " slices a frame, more than " +
                   std::to_string(static_cast<int>(ShellPlan::MaximumNumberOfSlices)) +
                   ": nothing is drawn; set a larger SampleDistance or fewer SamplesPerRay.");
    return false;
  }
  internal.Plan.Build(
    internal.Cells.Range, spacing, this->SamplesPerShell, this->Integration == PRE_INTEGRATED);
  return true;
}

//------------------------------------------------------------------------------
bool vtkBarycentricShellMapper::ProjectCells(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  if (!this->PlanShells(frame))
  {
    frame.Statistics.CellsDrawn = 0;
    return false;
  }
  ShellRaster::View view;
  static_cast<RasterView&>(view) = frame.GetRasterView();
  view.Image = frame.Image;
  view.Plan = &internal.Plan;
  view.Cells = &internal.Cells;
  view.Corners = &internal.Selection.Corners;
  view.IsPreIntegrated = this->Integration == PRE_INTEGRATED;
  view.Box = MeshExtent::FindScreenBox(this->GetPreparedVolume().Coordinates, view);
  internal.TargetBytes = static_cast<vtkIdType>(sizeof(float)) * 2 * this->SamplesPerShell *
                         frame.Size[0] * frame.Size[1];
  const bool uploaded = internal.Buffers.Upload(frame.Window, this->GetPreparedVolume());
  if (uploaded && internal.Raster.Draw(frame.Window, view, internal.Buffers))
  {
    return true;
  }
  frame.Statistics.CellsDrawn = 0;
  this->FailOnce(std::to_string(internal.Selection.GetNumberOfCells()) +
                 " tetrahedra cannot be drawn: " +
                 (uploaded ? internal.Raster.GetFailure() : internal.Buffers.GetFailure()) + ".");
  return false;
}

//------------------------------------------------------------------------------
vtkIdType vtkBarycentricShellMapper::GetNumberOfElementsDrawn() const
{
  return this->Internal->Raster.GetNumberOfElements();
}

//------------------------------------------------------------------------------
int vtkBarycentricShellMapper::GetNumberOfShells() const
{
  return this->Internal->Raster.GetNumberOfShells();
}

//------------------------------------------------------------------------------
vtkIdType vtkBarycentricShellMapper::GetMeshBytes() const
{
  return static_cast<vtkIdType>(this->Internal->Buffers.GetNumberOfBytes());
}

//------------------------------------------------------------------------------
vtkIdType vtkBarycentricShellMapper::GetTargetBytes() const
{
  return this->Internal->TargetBytes;
}

//------------------------------------------------------------------------------
vtkIdType vtkBarycentricShellMapper::GetUploadedBytes() const
{
  return static_cast<vtkIdType>(this->Internal->Buffers.GetUploadedBytes());
}

//------------------------------------------------------------------------------
double vtkBarycentricShellMapper::GetUploadSeconds() const
{
  return this->Internal->Buffers.GetUploadSeconds();
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::ReleaseBuffers(vtkWindow* window)
{
  this->Internal->Buffers.ReleaseGraphicsResources(window);
  this->Internal->Raster.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseBuffers(window);
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "SamplesPerRay: " << this->SamplesPerRay << "\n";
  os << indent << "SamplesPerShell: " << this->SamplesPerShell << "\n";
  os << indent << "Integration: " << this->Integration << "\n";
}
