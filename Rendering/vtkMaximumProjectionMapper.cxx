#include "vtkMaximumProjectionMapper.h"

#include "CellProjectionFrame.h"
#include "CutCells.h"
#include "DrawnFaces.h"
#include "MaximumRaster.h"
#include "PolyhedraTiles.h"
#include "PreparedPolyhedra.h"
#include "PreparedVolume.h"
#include "Tiles/ExtremumTilesEngine.h"
#include "TilesFrame.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTimeStamp.h"

#include <limits>

vtkStandardNewMacro(vtkMaximumProjectionMapper);

/// What the mapper keeps from frame to frame.
class vtkMaximumProjectionMapper::Internals
{
public:
  PreparedPolyhedra Polyhedra;
  MaximumRaster Raster;
  PolyhedraTiles Tiles;
  ExtremumTilesEngine Engine;
  // For which blend mode cells were selected.
  bool SelectedLeast = false;

  // When the GPU's copies were made; a default stamp is older than everything.
  vtkTimeStamp FaceScalarsUploaded;
  vtkTimeStamp SelectionUploaded;
};

//------------------------------------------------------------------------------
vtkMaximumProjectionMapper::vtkMaximumProjectionMapper()
  : Internal(new Internals)
{
  this->BlendMode = MAXIMUM_INTENSITY;
}

//------------------------------------------------------------------------------
vtkMaximumProjectionMapper::~vtkMaximumProjectionMapper()
{
  this->LeaveWindow();
}

//------------------------------------------------------------------------------
bool vtkMaximumProjectionMapper::CanDrawBlendMode(int mode) const
{
  return mode == MAXIMUM_INTENSITY || mode == MINIMUM_INTENSITY;
}

//------------------------------------------------------------------------------
bool vtkMaximumProjectionMapper::FindsLeast()
{
  return this->GetBlendMode() == MINIMUM_INTENSITY;
}

//------------------------------------------------------------------------------
void vtkMaximumProjectionMapper::SortCells(CellProjectionFrame& frame)
{
  // A maximum needs no order: there are only cells to leave out.
  FrameStatistics::Timer timer(frame.Statistics.SecondsPrepare);
  const TransferFunction& function = this->GetPreparedVolume().Function;
  PreparedPolyhedra& polyhedra = this->Internal->Polyhedra;
  const bool least = this->FindsLeast();
  if (this->Internal->SelectedLeast != least)
  {
    this->Internal->SelectedLeast = least;
    polyhedra.SelectionTime = vtkTimeStamp();
    this->Internal->Tiles.RenewScalars();
  }
  constexpr float end = std::numeric_limits<float>::max();
  polyhedra.Prepare(this->GetPreparedVolume(), [&function, least](float low, float high)
    { return least ? function.IsTransparent(low, end) : function.IsTransparent(-end, high); },
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
std::string vtkMaximumProjectionMapper::FindTilesObstacle(const CellProjectionFrame& frame) const
{
  return TilesFrame::FindObstacle(frame);
}

//------------------------------------------------------------------------------
void vtkMaximumProjectionMapper::UpdateTiles()
{
  Internals& internal = *this->Internal;
  internal.Tiles.Update(internal.Engine, this->GetPreparedVolume(), internal.Polyhedra,
    [&](const std::vector<float>& values, bool onePerCell)
    { internal.Engine.SetScalars(values, onePerCell, this->FindsLeast()); });
}

//------------------------------------------------------------------------------
const float* vtkMaximumProjectionMapper::DrawTiles(CellProjectionFrame& frame)
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
bool vtkMaximumProjectionMapper::UploadFaceScalars(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  PreparedPolyhedra& polyhedra = internal.Polyhedra;
  const ScalarField& scalars = this->GetPreparedVolume().Scalars;
  // The selection is made again for every change of cells, scalars or blend mode.
  if (internal.FaceScalarsUploaded > polyhedra.SelectionTime)
  {
    return true;
  }
  std::vector<float> values;
  if (scalars.OnePerCell)
  {
    values = DrawnFaces::CellScalars(polyhedra.Buffers.GetCells(), polyhedra.Buffers.GetPieces(),
      polyhedra.Selection, scalars, this->FindsLeast());
  }
  const bool good = internal.Raster.UploadFaceScalars(frame.Window, values);
  if (good)
  {
    internal.FaceScalarsUploaded.Modified();
  }
  return good;
}

//------------------------------------------------------------------------------
bool vtkMaximumProjectionMapper::UploadSelection()
{
  Internals& internal = *this->Internal;
  PreparedPolyhedra& polyhedra = internal.Polyhedra;
  if (internal.SelectionUploaded > polyhedra.SelectionTime)
  {
    return true;
  }
  DrawnFaces faces;
  faces.Build(polyhedra.Buffers.GetCells(), polyhedra.Buffers.GetPieces(), polyhedra.Selection);
  const bool good = internal.Raster.UploadFaces(faces.Pieces) &&
                    internal.Raster.UploadCells(polyhedra.Selection.DrawnCells);
  if (good)
  {
    internal.SelectionUploaded.Modified();
  }
  return good;
}

//------------------------------------------------------------------------------
bool vtkMaximumProjectionMapper::UploadCutCells(CellProjectionFrame& frame)
{
  const PreparedPolyhedra& polyhedra = this->Internal->Polyhedra;
  return this->Internal->Raster.UploadCutCells(CutCells::Find(
    this->GetPreparedVolume().Coordinates.Points, polyhedra.Buffers.GetCells().Corners,
    polyhedra.Selection, CutCells::Planes(frame.Rays, frame.ClippingPlanes)));
}

//------------------------------------------------------------------------------
bool vtkMaximumProjectionMapper::ProjectCells(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  ConvexCellBuffers& buffers = internal.Polyhedra.Buffers;
  std::string failure;
  if (!buffers.Upload(frame.Window, this->GetPreparedVolume()))
  {
    failure = buffers.GetFailure();
  }
  else if (!this->UploadFaceScalars(frame) || !this->UploadSelection() ||
           !this->UploadCutCells(frame) ||
           !internal.Raster.Draw(frame.Window, frame.GetRasterView(), buffers, this->FindsLeast()))
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
void vtkMaximumProjectionMapper::ReleaseBuffers(vtkWindow* window)
{
  Internals& internal = *this->Internal;
  internal.Polyhedra.Buffers.ReleaseGraphicsResources(window);
  internal.Raster.ReleaseGraphicsResources(window);
  internal.FaceScalarsUploaded = vtkTimeStamp();
  internal.SelectionUploaded = vtkTimeStamp();
  this->Superclass::ReleaseBuffers(window);
}
