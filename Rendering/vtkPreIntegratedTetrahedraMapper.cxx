#include "vtkPreIntegratedTetrahedraMapper.h"

#include "BackToFrontOrder.h"
#include "CellProjectionFrame.h"
#include "DrawnCells.h"
#include "MapperMessages.h"
#include "PreIntegrationTable.h"
#include "PreparedVolume.h"
#include "ShadingBuffers.h"
#include "TetrahedraApproximation.h"
#include "TetrahedraPlanes.h"
#include "TetrahedraRaster.h"
#include "TetrahedraSelection.h"
#include "TetrahedraTiles.h"
#include "TilesFrame.h"
#include "VolumeShading.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVisibilitySort.h"

vtkStandardNewMacro(vtkPreIntegratedTetrahedraMapper);

/// What the mapper keeps from frame to frame.
class vtkPreIntegratedTetrahedraMapper::Internals
{
public:
  vtkSmartPointer<vtkVisibilitySort> Sort;
  BackToFrontOrder Order;
  TetrahedraSelection Selection;
  DrawnCells Drawn;
  TetrahedraRaster Raster;
  TetrahedraApproximation Approximation;
  TetrahedraTiles Tiles;
  PreIntegrationTable Table;
  VolumeShading Shading;
  ShadingBuffers ShadingOnGPU;
  vtkTimeStamp TableTime;
  vtkTimeStamp CornersTime;
  vtkTimeStamp SelectionTime;
  vtkTimeStamp DrawnOrderTime;
  vtkTimeStamp DrawnTime;

  // When the GPU's copies were made; a default stamp is older than everything.
  vtkTimeStamp CellsUploaded;
  vtkTimeStamp ScalarsUploaded;
  vtkTimeStamp FunctionUploaded;
  vtkTimeStamp OrderUploaded;
  vtkTimeStamp TableUploaded;
  bool TableFits = true;
};

//------------------------------------------------------------------------------
vtkPreIntegratedTetrahedraMapper::vtkPreIntegratedTetrahedraMapper()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkPreIntegratedTetrahedraMapper::~vtkPreIntegratedTetrahedraMapper()
{
  this->LeaveWindow();
}

//------------------------------------------------------------------------------
void vtkPreIntegratedTetrahedraMapper::SetVisibilitySort(vtkVisibilitySort* sort)
{
  if (this->Internal->Sort != sort)
  {
    this->Internal->Sort = sort;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkVisibilitySort* vtkPreIntegratedTetrahedraMapper::GetVisibilitySort()
{
  return this->Internal->Sort;
}

//------------------------------------------------------------------------------
const char* vtkPreIntegratedTetrahedraMapper::GetMethodName() const
{
  static const char* const names[] = { "PreIntegratedTetrahedra", "ShirleyTuchman",
    "ShirleyTuchmanExponential", "Voxel", "UniformThickness1", "UniformThickness2", "Centroid" };
  return names[this->Approximation];
}

//------------------------------------------------------------------------------
void vtkPreIntegratedTetrahedraMapper::PrepareTetrahedra(CellProjectionFrame& frame)
{
  FrameStatistics::Timer timer(frame.Statistics.SecondsPrepare);
  Internals& internal = *this->Internal;
  const PreparedVolume& prepared = this->GetPreparedVolume();
  if (internal.CornersTime < prepared.CellsTime)
  {
    internal.Selection.TakeCorners(prepared.Cells);
    this->ReportPreparation(0.6);
    internal.CornersTime.Modified();
  }
  if (internal.SelectionTime < internal.CornersTime ||
      internal.SelectionTime < prepared.FunctionTime)
  {
    internal.Selection.Classify(prepared.Scalars, prepared.Function);
    internal.SelectionTime.Modified();
  }
  if (this->Approximation != NONE)
  {
    this->PrepareApproximation(frame);
    return;
  }
  if (frame.UsesTiles)
  {
    internal.Tiles.Update(prepared, internal.Selection, internal.SelectionTime,
      [this](double share) { this->ReportPreparation(0.6 + 0.35 * share); });
    this->WarnOnce(MapperMessages::FlatTetrahedra(internal.Tiles.GetNumberOfFlatCells()));
  }
  std::string problem;
  internal.Shading.Prepare(frame, prepared, internal.Selection.Corners, internal.CornersTime, problem);
  this->WarnOnce(problem);
  if (this->DrawsTable() &&
    (internal.TableTime < prepared.FunctionTime || internal.Table.Size != this->TableSize ||
      internal.Table.IsLit() != internal.Shading.IsLit))
  {
    const std::array<float, 2> range = prepared.Scalars.GetNormalisedRange();
    internal.Table.Build(prepared.Function, range.data(), this->TableSize, internal.Shading.IsLit);
    internal.TableTime.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPreIntegratedTetrahedraMapper::SortCells(CellProjectionFrame& frame)
{
  this->PrepareTetrahedra(frame);
  // Tiles find their own order.
  if (!frame.UsesTiles || this->Internal->Sort || this->ReportOrder)
  {
    this->OrderCells(frame);
  }
  const TetrahedraSelection& selection = this->Internal->Selection;
  frame.Statistics.CellsSkippedTransparent = selection.NumberOfTransparentCells;
  frame.Statistics.CellsSkippedInvalid += selection.NumberOfInvalidCells;
  frame.Statistics.CellsDrawn = selection.GetNumberOfCells() - selection.NumberOfTransparentCells -
                                selection.NumberOfInvalidCells;
}

//------------------------------------------------------------------------------
void vtkPreIntegratedTetrahedraMapper::OrderCells(CellProjectionFrame& frame)
{
  FrameStatistics::Timer timer(frame.Statistics.SecondsSort);
  Internals& internal = *this->Internal;
  const PreparedVolume& prepared = this->GetPreparedVolume();
  if (internal.Order.Update(internal.Sort, prepared.Cells, frame))
  {
    internal.DrawnOrderTime.Modified();
  }
  if (internal.Order.NumberOfWrongIds > 0)
  {
    this->WarnOnce("The visibility sort repeated, invented or left out " +
                   std::to_string(internal.Order.NumberOfWrongIds) +
                   " cells: the order is not right there.");
  }
  frame.Statistics.Cycles = static_cast<vtkIdType>(internal.Order.CyclicGroups.size());
  frame.Statistics.MisorderedFaces = this->ReportOrder ? internal.Order.CountMisorderedFaces() : 0;
}

//------------------------------------------------------------------------------
bool vtkPreIntegratedTetrahedraMapper::UploadCells(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  const MeshCoordinates& coordinates = this->GetPreparedVolume().Coordinates;
  const std::vector<int>& corners = internal.Selection.Corners;
  if (internal.CellsUploaded > internal.CornersTime)
  {
    return true;
  }
  const std::vector<float> planes = TetrahedraPlanes::Planes(coordinates.Points, corners);
  this->WarnOnce(MapperMessages::FlatTetrahedra(TetrahedraPlanes::CountFlatCells(planes)));
  const bool good = internal.Raster.UploadPoints(frame.Window, coordinates.Points) &&
                    internal.Raster.UploadCorners(frame.Window, corners) &&
                    internal.Raster.UploadPlanes(frame.Window, planes);
  // Stamped where it worked only: the next frame tries again, and draws nothing that is not there.
  if (good)
  {
    internal.CellsUploaded.Modified();
  }
  return good;
}

//------------------------------------------------------------------------------
bool vtkPreIntegratedTetrahedraMapper::UploadField(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  const PreparedVolume& prepared = this->GetPreparedVolume();
  bool good = true;
  if (internal.ScalarsUploaded < prepared.ScalarsTime)
  {
    good = internal.Raster.UploadScalars(
      frame.Window, TetrahedraPlanes::Scalars(prepared.Scalars, internal.Selection.Corners));
  }
  if (good && internal.FunctionUploaded < prepared.FunctionTime)
  {
    good = internal.Raster.UploadTransferFunction(frame.Window, prepared.Function);
  }
  if (good)
  {
    internal.ScalarsUploaded.Modified();
    internal.FunctionUploaded.Modified();
  }
  return good;
}

//------------------------------------------------------------------------------
void vtkPreIntegratedTetrahedraMapper::BuildDrawnCells()
{
  Internals& internal = *this->Internal;
  if (internal.DrawnTime < internal.DrawnOrderTime || internal.DrawnTime < internal.SelectionTime)
  {
    internal.Drawn.Build(internal.Order, internal.Selection);
    internal.DrawnTime.Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkPreIntegratedTetrahedraMapper::UploadOrder()
{
  Internals& internal = *this->Internal;
  this->BuildDrawnCells();
  if (internal.OrderUploaded > internal.DrawnTime)
  {
    return true;
  }
  this->WarnOnce(MapperMessages::UnresolvedCells(internal.Drawn.NumberOfUnresolvedCells));
  const bool good = internal.Raster.UploadOrder(internal.Drawn);
  if (good)
  {
    internal.OrderUploaded.Modified();
  }
  return good;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPreIntegratedTetrahedraMapper::GetTableTime() const
{
  return this->Internal->TableTime;
}

//------------------------------------------------------------------------------
bool vtkPreIntegratedTetrahedraMapper::DrawsTable()
{
  const bool isDependent = this->Internal->Shading.Colors.Kind != DependentColors::None;
  if (this->Integration == TABLE && isDependent)
  {
    this->WarnOnce("A table holds one scalar: dependent components are drawn with the exact "
                   "integral; call SetIntegrationToExact().");
  }
  return this->Integration == TABLE && !isDependent;
}

//------------------------------------------------------------------------------
bool vtkPreIntegratedTetrahedraMapper::UploadTable(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  if (internal.TableUploaded < internal.TableTime)
  {
    internal.TableFits = !internal.Table.Texels.empty() &&
      internal.Raster.UploadTable(frame.Window, internal.Table);
    internal.TableUploaded.Modified();
  }
  if (!internal.TableFits)
  {
    this->WarnOnce("There is no room for a pre-integration table of size " +
      std::to_string(this->TableSize) +
      ": drawn with the exact integral; call SetTableSize with less.");
  }
  return internal.TableFits;
}

//------------------------------------------------------------------------------
void vtkPreIntegratedTetrahedraMapper::PrepareApproximation(CellProjectionFrame& frame)
{
  const TetrahedraApproximation::Settings settings{
    static_cast<ApproximationKind>(this->Approximation), this->CentroidThickness,
    this->CentroidRimOpacity };
  this->Internal->Approximation.Prepare(settings, this->GetPreparedVolume(), this->Internal->Selection, frame);
}

//------------------------------------------------------------------------------
bool vtkPreIntegratedTetrahedraMapper::ProjectApproximation(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  if (!internal.Order.CyclicGroups.empty())
  {
    this->WarnOnce(std::to_string(internal.Order.CyclicGroups.size()) +
                   " groups of cells hide each other in a circle: an approximation draws them as "
                   "the sort left them; SetApproximationToNone() puts them in order per pixel.");
  }
  this->BuildDrawnCells();
  return internal.Approximation.Draw(
           this->GetPreparedVolume(), internal.Selection, internal.Drawn.Cells, frame) ||
         this->Fail(frame, internal.Approximation.GetFailure());
}

//------------------------------------------------------------------------------
bool vtkPreIntegratedTetrahedraMapper::Fail(CellProjectionFrame& frame, const std::string& reason)
{
  frame.Statistics.CellsDrawn = 0;
  this->FailOnce(std::to_string(this->Internal->Selection.GetNumberOfCells()) +
                 " tetrahedra cannot be drawn: " + reason + "; draw fewer cells.");
  return false;
}

//------------------------------------------------------------------------------
bool vtkPreIntegratedTetrahedraMapper::UploadShading(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  if (!internal.Shading.IsNeeded())
  {
    return false;
  }
  const bool good = internal.ShadingOnGPU.Upload(frame.Window, internal.Shading);
  if (!good)
  {
    this->WarnOnce("No light and no gradient opacity: " + internal.ShadingOnGPU.GetFailure() +
                   "; draw fewer points.");
  }
  return good;
}

//------------------------------------------------------------------------------
std::string vtkPreIntegratedTetrahedraMapper::FindTilesObstacle(const CellProjectionFrame& frame) const
{
  return this->Integration == EXACT && this->Approximation == NONE
    ? TilesFrame::FindObstacle(frame)
    : "by table, average or approximation";
}

//------------------------------------------------------------------------------
const float* vtkPreIntegratedTetrahedraMapper::DrawTiles(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  internal.Tiles.UpdateShading(internal.Shading);
  internal.Tiles.ReportsStages = this->ReportStages;
  return internal.Tiles.Draw(frame, this->GetPreparedVolume(), internal.Shading,
    internal.Sort || this->ReportOrder ? &internal.Order : nullptr);
}

//------------------------------------------------------------------------------
bool vtkPreIntegratedTetrahedraMapper::ProjectCells(CellProjectionFrame& frame)
{
  if (this->Approximation != NONE)
  {
    return this->ProjectApproximation(frame);
  }
  TetrahedraRaster::View view;
  view.SamplesPerSegment = this->SamplesPerSegment;
  view.Integration = this->Integration == AVERAGE                     ? SegmentIntegration::Average
                     : this->DrawsTable() && this->UploadTable(frame) ? SegmentIntegration::Table
                                                                      : SegmentIntegration::Exact;
  static_cast<RasterView&>(view) = frame.GetRasterView();
  view.Shading = this->UploadShading(frame) ? &this->Internal->ShadingOnGPU : nullptr;
  view.Cells = &this->Internal->Drawn;
  view.Points = &this->GetPreparedVolume().Coordinates.Points;
  view.Corners = &this->Internal->Selection.Corners;
  TetrahedraRaster& raster = this->Internal->Raster;
  return (this->UploadCells(frame) && this->UploadField(frame) && this->UploadOrder() &&
           raster.Draw(frame.Window, view)) ||
         this->Fail(frame, raster.GetFailure());
}

//------------------------------------------------------------------------------
void vtkPreIntegratedTetrahedraMapper::ReleaseBuffers(vtkWindow* window)
{
  Internals& internal = *this->Internal;
  internal.Raster.ReleaseGraphicsResources(window);
  internal.Approximation.ReleaseGraphicsResources();
  internal.ShadingOnGPU.ReleaseGraphicsResources(window);
  internal.CellsUploaded = internal.ScalarsUploaded = internal.FunctionUploaded =
    internal.OrderUploaded = internal.TableUploaded = vtkTimeStamp();
  this->Superclass::ReleaseBuffers(window);
}

//------------------------------------------------------------------------------
void vtkPreIntegratedTetrahedraMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Integration: " << this->Integration << "\n";
  os << indent << "TableSize: " << this->TableSize << "\n";
  os << indent << "SamplesPerSegment: " << this->SamplesPerSegment << "\n";
  os << indent << "Approximation: " << this->GetMethodName() << "\n";
  os << indent << "CentroidThickness: " << this->CentroidThickness << "\n";
  os << indent << "CentroidRimOpacity: " << this->CentroidRimOpacity << "\n";
  os << indent << "ReportOrder: " << this->ReportOrder << "\n";
  os << indent << "ReportStages: " << this->ReportStages << "\n";
  os << indent << "VisibilitySort: " << this->Internal->Sort.GetPointer() << "\n";
}
