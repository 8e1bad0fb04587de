#include "vtkBarycentricShellMapper.h"

#include "BarycentricShellInternals.h"
#include "MeshBlocks.h"
#include "MeshExtent.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkBarycentricShellMapper);

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
void vtkBarycentricShellMapper::SetMemoryLimit(double limit)
{
  if (!(limit >= 0.0) || !std::isfinite(limit))
  {
    vtkErrorMacro("MemoryLimit is " << limit << " MiB: it must not be negative; "
                                    << this->MemoryLimit << " stays.");
  }
  else if (limit != this->MemoryLimit)
  {
    this->MemoryLimit = limit;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::SetVisibilitySort(vtkVisibilitySort* sort)
{
  if (this->Internal->Sort != sort)
  {
    this->Internal->Sort = sort;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkVisibilitySort* vtkBarycentricShellMapper::GetVisibilitySort()
{
  return this->Internal->Sort;
}

//------------------------------------------------------------------------------
const char* vtkBarycentricShellMapper::GetMethodName() const
{
  return this->BlendMode == ISOSURFACE       ? "BarycentricIsoSurfaces"
         : this->Method == CELL_PROJECTION ? "BarycentricCellProjection"
                                           : "BarycentricShells";
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  Internals& internal = *this->Internal;
  internal.HasSurfaces = false;
  if (internal.Texture && !this->CheckTexture())
  {
    return;
  }
  this->Superclass::Render(renderer, volume);
  if (internal.HasSurfaces)
  {
    internal.Surfaces.DrawDepth(internal.SurfacesFrame);
  }
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::SetVolumeTexture(vtkImageData* image)
{
  if (this->Internal->Texture != image)
  {
    this->Internal->Texture = image;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkBarycentricShellMapper::GetVolumeTexture()
{
  return this->Internal->Texture;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkBarycentricShellMapper::GetOwnScalars()
{
  vtkImageData* image = this->Internal->Texture;
  return image ? image->GetPointData()->GetScalars() : nullptr;
}

//------------------------------------------------------------------------------
bool vtkBarycentricShellMapper::CheckTexture()
{
  vtkUnstructuredGridBase* input = this->GetInput();
  vtkDataArray* coordinates = input ? input->GetPointData()->GetTCoords() : nullptr;
  const int components = coordinates ? coordinates->GetNumberOfComponents() : 0;
  if (!this->GetOwnScalars())
  {
    this->FailOnce("The volume texture has no point scalars: nothing is drawn; set them.");
  }
  else if (input && components != 3)
  {
    this->FailOnce("The points have texture coordinates of " + std::to_string(components) +
                   " components: nothing is drawn; a volume texture takes 3, set by SetTCoords().");
  }
  else if (this->BlendMode == ISOSURFACE)
  {
    this->FailOnce("Iso-surfaces of a volume texture are not drawn: take scalars of points.");
  }
  return this->GetOwnScalars() && (!input || components == 3) && this->BlendMode != ISOSURFACE;
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::SelectCells(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  const PreparedVolume& prepared = this->GetPreparedVolume();
  if (internal.Buffers.GetTexture().IsUsed())
  {
    internal.Elements.SelectAll(prepared);
    return;
  }
  if (this->BlendMode != ISOSURFACE)
  {
    internal.Elements.Select(prepared);
    return;
  }
  std::vector<std::string> problems;
  internal.Surfaces.TakeValues(frame, prepared, problems);
  for (const std::string& text : problems)
  {
    this->WarnOnce(text);
  }
  internal.Elements.Select(prepared,
    [&internal](float low, float high) { return internal.Surfaces.IsEmpty(low, high); });
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::SortCells(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  {
    // Shells need no order: there are only distances from the eye to find.
    FrameStatistics::Timer timer(frame.Statistics.SecondsPrepare);
    internal.Buffers.GetTexture().SetSource(internal.Texture,
      internal.Texture ? this->GetPreparedVolume().Cells->GetPointData()->GetTCoords() : nullptr);
    const vtkIdType turned = internal.Elements.NumberOfTurnedCells;
    this->SelectCells(frame);
    internal.Elements.FindSeen(this->GetPreparedVolume(), frame.GetRasterView());
    internal.Elements.FillStatistics(frame.Statistics);
    // Their number changes with every frame: it is said once, until all are well again.
    if (turned == 0 && internal.Elements.NumberOfTurnedCells > 0)
    {
      vtkWarningMacro("Moved points have turned "
                      << internal.Elements.NumberOfTurnedCells
                      << " tetrahedra inside out: they are drawn as they are, see "
                         "GetNumberOfTurnedCells().");
    }
  }
  if (this->Method == CELL_PROJECTION && this->BlendMode != ISOSURFACE)
  {
    this->OrderCells(frame);
  }
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::OrderCells(CellProjectionFrame& frame)
{
  FrameStatistics::Timer timer(frame.Statistics.SecondsSort);
  Internals& internal = *this->Internal;
  const PreparedVolume& prepared = this->GetPreparedVolume();
  // Cells may have kept their time when their points moved.
  if (!internal.Order || internal.OrderTime < prepared.PointsTime)
  {
    internal.Order = std::make_unique<BackToFrontOrder>();
    internal.OrderTime.Modified();
  }
  internal.Order->Update(internal.Sort, prepared.Cells, frame);
  frame.Statistics.Cycles = static_cast<vtkIdType>(internal.Order->CyclicGroups.size());
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
  const double slices = ShellPlan::CountSlices(internal.Elements.Cells.Range, spacing);
  if (!(slices <= ShellPlan::MaximumNumberOfSlices))
  {
    this->FailOnce("A distance of " + std::to_string(spacing) + " between samples would take " +
                   std::to_string(slices) + " slices a frame, more than " +
                   std::to_string(static_cast<int>(ShellPlan::MaximumNumberOfSlices)) +
                   ": nothing is drawn; set a larger SampleDistance or fewer SamplesPerRay.");
    return false;
  }
  internal.Plan.Build(internal.Elements.Cells.Range, spacing, this->SamplesPerShell,
    this->Integration == PRE_INTEGRATED);
  return true;
}

//------------------------------------------------------------------------------
bool vtkBarycentricShellMapper::UploadMesh(CellProjectionFrame& frame, bool inShells)
{
  Internals& internal = *this->Internal;
  const PreparedVolume& prepared = this->GetPreparedVolume();
  const auto limit =
    this->MemoryLimit > 0.0 ? std::max<size_t>(this->MemoryLimit * 1048576.0, 1) : 0;
  internal.Blocks = &internal.Elements.CutIntoBlocks(prepared, inShells ? limit : 0);
  if (!internal.Blocks->empty() && limit < MeshBlocks::LeastBytes)
  {
    this->WarnOnce("A MemoryLimit of " + std::to_string(this->MemoryLimit) +
                   " MiB holds no block: drawn in blocks of " +
                   std::to_string(MeshBlocks::LeastBytes) + " bytes; set more.");
  }
  return internal.Blocks->empty() ? internal.Buffers.Upload(frame.Window, prepared)
                                  : internal.Buffers.UploadWithoutMesh(frame.Window, prepared);
}

//------------------------------------------------------------------------------
bool vtkBarycentricShellMapper::ProjectCells(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  const PreparedVolume& prepared = this->GetPreparedVolume();
  bool inShells = this->BlendMode != ISOSURFACE && this->Method == SHELLS;
  if (inShells && !internal.Shells.CanDraw(frame.Window, frame.Size, this->SamplesPerShell))
  {
    this->WarnOnce("The driver cannot blend " + std::to_string(this->SamplesPerShell) +
                   " floats per pixel: drawn by CellProjection.");
    inShells = false;
    this->OrderCells(frame);
  }
  std::string problem;
  bool drawn = (!inShells || this->PlanShells(frame)) && this->UploadMesh(frame, inShells);
  if (drawn)
  {
    drawn = inShells ? internal.DrawShells(frame, prepared, *this, problem)
            : this->BlendMode == ISOSURFACE ? internal.DrawSurfaces(frame, prepared, problem)
                                            : internal.DrawOrdered(frame, problem);
  }
  problem = problem.empty() ? internal.Buffers.GetFailure() : problem;
  if (drawn && !problem.empty())
  {
    this->WarnOnce(problem);
  }
  else if (!problem.empty())
  {
    this->FailOnce(std::to_string(internal.Elements.Selection.GetNumberOfCells()) +
                   " tetrahedra cannot be drawn: " + problem + ".");
  }
  frame.Statistics.CellsDrawn = drawn ? frame.Statistics.CellsDrawn : 0;
  return drawn;
}

//------------------------------------------------------------------------------
vtkIdType vtkBarycentricShellMapper::GetNumberOfElementsDrawn() const
{
  return this->Internal->Shells.GetNumberOfElements();
}

//------------------------------------------------------------------------------
int vtkBarycentricShellMapper::GetNumberOfShells() const
{
  return this->Internal->Shells.GetNumberOfShells();
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
vtkIdType vtkBarycentricShellMapper::GetNumberOfTurnedCells() const
{
  return this->Internal->Elements.NumberOfTurnedCells;
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::ReleaseBuffers(vtkWindow* window)
{
  this->Internal->Buffers.ReleaseGraphicsResources(window);
  this->Internal->Shells.ReleaseGraphicsResources(window);
  this->Internal->Projection.ReleaseGraphicsResources();
  this->Internal->Surfaces.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseBuffers(window);
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "SamplesPerRay: " << this->SamplesPerRay << "\n";
  os << indent << "SamplesPerShell: " << this->SamplesPerShell << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "VisibilitySort: " << this->Internal->Sort.GetPointer() << "\n";
  os << indent << "Integration: " << this->Integration << "\n";
}
