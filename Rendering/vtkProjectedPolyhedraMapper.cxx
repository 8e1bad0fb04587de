#include "vtkProjectedPolyhedraMapper.h"

#include "CellProjectionFrame.h"
#include "PolyhedraRaster.h"
#include "PolyhedraTiles.h"
#include "PreparedPolyhedra.h"
#include "PreparedVolume.h"
#include "ThreePassRaster.h"
#include "Tiles/EmissionTilesEngine.h"
#include "TilesFrame.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTimeStamp.h"

vtkStandardNewMacro(vtkProjectedPolyhedraMapper);

/// What the mapper keeps from frame to frame.
class vtkProjectedPolyhedraMapper::Internals
{
public:
  PreparedPolyhedra Polyhedra;
  PolyhedraRaster Raster;
  ThreePassRaster ThreePasses;
  PolyhedraTiles Tiles;
  EmissionTilesEngine Engine;
  vtkTimeStamp CellsUploaded;
};

//------------------------------------------------------------------------------
vtkProjectedPolyhedraMapper::vtkProjectedPolyhedraMapper()
  : Internal(new Internals)
{
  this->BlendMode = ADDITIVE;
}

//------------------------------------------------------------------------------
vtkProjectedPolyhedraMapper::~vtkProjectedPolyhedraMapper()
{
  this->LeaveWindow();
}

//------------------------------------------------------------------------------
const char* vtkProjectedPolyhedraMapper::GetMethodName() const
{
  return this->Passes == ONE ? "ProjectedPolyhedra" : "ProjectedPolyhedraThreePasses";
}

//------------------------------------------------------------------------------
void vtkProjectedPolyhedraMapper::SetPasses(int passes)
{
  if (passes != ONE && passes != THREE)
  {
    vtkErrorMacro("Passes is " << passes << ": it is 1 or 3.");
  }
  else if (passes != this->Passes)
  {
    this->Passes = passes;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkProjectedPolyhedraMapper::SortCells(CellProjectionFrame& frame)
{
  // Sums need no order: there are only cells to leave out.
  FrameStatistics::Timer timer(frame.Statistics.SecondsPrepare);
  const PreparedVolume& prepared = this->GetPreparedVolume();
  PreparedPolyhedra& polyhedra = this->Internal->Polyhedra;
  polyhedra.Prepare(
    prepared, [&prepared](float low, float high) { return prepared.Function.IsDark(low, high); },
    [this](double share) { this->ReportPreparation(0.5 + 0.4 * share); });
  polyhedra.FillStatistics(frame.Statistics);
  if (frame.UsesTiles)
  {
    this->UpdateTiles();
  }
  if (polyhedra.GetNumberOfFlatCells() > 0)
  {
    this->WarnOnce(polyhedra.GetFlatCellsMessage());
  }
}

//------------------------------------------------------------------------------
std::string vtkProjectedPolyhedraMapper::FindTilesObstacle(const CellProjectionFrame& frame) const
{
  return this->Passes == THREE  ? "three passes"
         : this->AverageEmission ? "the mean emission of both ends"
                                 : TilesFrame::FindObstacle(frame);
}

//------------------------------------------------------------------------------
void vtkProjectedPolyhedraMapper::UpdateTiles()
{
  Internals& internal = *this->Internal;
  internal.Tiles.Update(internal.Engine, this->GetPreparedVolume(), internal.Polyhedra,
    [&](const std::vector<float>& values, bool onePerCell)
    { internal.Engine.SetScalars(values, onePerCell); });
}

//------------------------------------------------------------------------------
const float* vtkProjectedPolyhedraMapper::DrawTiles(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  const PreparedVolume& prepared = this->GetPreparedVolume();
  if (!internal.Engine.Render(PolyhedraTiles::DescribeScene(frame, prepared)))
  {
    return nullptr;
  }
  PolyhedraTiles::FillStatistics(internal.Engine, frame.Statistics);
  return internal.Engine.GetImage().data();
}

//------------------------------------------------------------------------------
bool vtkProjectedPolyhedraMapper::DrawOnePass(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  PreparedPolyhedra& polyhedra = internal.Polyhedra;
  if (internal.CellsUploaded < polyhedra.SelectionTime)
  {
    if (!internal.Raster.UploadCells(polyhedra.Selection.DrawnCells))
    {
      return false;
    }
    internal.CellsUploaded.Modified();
  }
  return internal.Raster.Draw(
    frame.Window, frame.GetRasterView(), polyhedra.Buffers, this->AverageEmission);
}

//------------------------------------------------------------------------------
bool vtkProjectedPolyhedraMapper::ProjectCells(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  std::string failure;
  if (!internal.Polyhedra.Buffers.Upload(frame.Window, this->GetPreparedVolume()))
  {
    failure = internal.Polyhedra.Buffers.GetFailure();
  }
  else if (this->Passes == THREE)
  {
    ThreePassRaster& raster = internal.ThreePasses;
    const bool drawn = raster.Draw(
      frame.Window, frame.GetRasterView(), this->GetPreparedVolume(), internal.Polyhedra);
    failure = drawn ? "" : raster.GetFailure();
  }
  else if (!this->DrawOnePass(frame))
  {
    failure = internal.Raster.GetFailure();
  }
  if (!failure.empty())
  {
    this->FailOnce(internal.Polyhedra.GetFailureMessage(failure));
    frame.Statistics.CellsDrawn = 0;
  }
  return failure.empty();
}

//------------------------------------------------------------------------------
void vtkProjectedPolyhedraMapper::ReleaseBuffers(vtkWindow* window)
{
  this->Internal->Polyhedra.Buffers.ReleaseGraphicsResources(window);
  this->Internal->Raster.ReleaseGraphicsResources();
  this->Internal->ThreePasses.ReleaseGraphicsResources(window);
  this->Internal->CellsUploaded = vtkTimeStamp();
  this->Superclass::ReleaseBuffers(window);
}

//------------------------------------------------------------------------------
void vtkProjectedPolyhedraMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Passes: " << this->Passes << "\n";
  os << indent << "AverageEmission: " << this->AverageEmission << "\n";
}
