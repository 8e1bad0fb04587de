#include "vtkBarycentricShellMapper.h"

#include "BarycentricShellInternals.h"
#include "MeshBlocks.h"
#include "MapperMessages.h"
#include "MeshExtent.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <sstream>

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
  internal.HasSurfaces = internal.IsInShells = false;
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
  internal.Elements.Select(prepared,
    [&internal](float low, float high) { return internal.Surfaces.IsEmpty(low, high); });
}

//------------------------------------------------------------------------------
bool vtkBarycentricShellMapper::MakeTriangles(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  std::vector<std::string> problems;
  internal.Surfaces.TakeValues(frame, this->GetPreparedVolume(), problems);
  for (const std::string& text : problems)
  {
    this->WarnOnce(text);
  }
  if (!internal.Surfaces.AreTriangles())
  {
    return false;
  }
  internal.MakeTriangles(this->GetPreparedVolume(), frame.Statistics);
  return true;
}

//------------------------------------------------------------------------------
bool vtkBarycentricShellMapper::DrawsIntoWindow() const
{
  return this->BlendMode == ISOSURFACE && !this->CaptureImage &&
         this->Internal->Surfaces.AreTriangles();
}

//------------------------------------------------------------------------------
void vtkBarycentricShellMapper::WarnOfTurnedCells(vtkIdType before)
{
  // Their number changes with every frame: it is said once, until all are well again.
  const vtkIdType turned = this->Internal->Elements.NumberOfTurnedCells;
  if (before == 0 && turned > 0)
  {
    vtkWarningMacro("Moved points have turned "
                    << turned
                    << " tetrahedra inside out: they are drawn as they are, see "
                       "GetNumberOfTurnedCells().");
  }
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
    if (this->BlendMode != ISOSURFACE || !this->MakeTriangles(frame))
    {
      this->SelectCells(frame);
      internal.Elements.FindSeen(this->GetPreparedVolume(), frame.GetRasterView());
      internal.Elements.FillStatistics(frame.Statistics);
    }
    this->WarnOfTurnedCells(turned);
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
    std::ostringstream text;
    text << "A distance of " << spacing << " between samples would take " << slices
         << " slices a frame, more than " << ShellPlan::MaximumNumberOfSlices
         << ": nothing is drawn; set a larger SampleDistance or fewer SamplesPerRay.";
    this->FailOnce(text.str());
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
    std::ostringstream text;
    text << "A MemoryLimit of " << this->MemoryLimit << " MiB holds no block: drawn in blocks of "
         << MeshBlocks::LeastBytes << " bytes; set more.";
    this->WarnOnce(text.str());
  }
  return internal.Blocks->empty() ? internal.Buffers.Upload(frame.Window, prepared)
                                  : internal.Buffers.UploadWithoutMesh(frame.Window, prepared);
}

//------------------------------------------------------------------------------
bool vtkBarycentricShellMapper::ProjectCells(CellProjectionFrame& frame)
{
  Internals& internal = *this->Internal;
  const PreparedVolume& prepared = this->GetPreparedVolume();
  const bool asTriangles =
    this->BlendMode == ISOSURFACE && internal.Surfaces.AreTriangles();
  bool inShells = this->BlendMode != ISOSURFACE && this->Method == SHELLS;
  if (inShells && !internal.Shells.CanDraw(frame.Window, frame.Size, this->SamplesPerShell))
  {
    this->WarnOnce("The driver cannot blend " + std::to_string(this->SamplesPerShell) +
                   " floats per pixel: drawn by CellProjection.");
    inShells = false;
    this->OrderCells(frame);
  }
  std::string problem;
  bool drawn = (!inShells || this->PlanShells(frame)) &&
               (asTriangles || this->UploadMesh(frame, inShells));
  if (drawn)
  {
    drawn = inShells ? internal.DrawShells(frame, prepared, *this, problem)
            : this->DrawsIntoWindow() ? internal.DrawIntoWindow(frame, prepared, problem)
            : this->BlendMode == ISOSURFACE ? internal.DrawSurfaces(frame, prepared, problem)
                                            : internal.DrawOrdered(frame, prepared, problem);
  }
  this->WarnOnce(MapperMessages::UnresolvedCells(internal.Drawn.NumberOfUnresolvedCells));
  // Triangles have buffers of their own: these say what failed in an earlier frame.
  problem = problem.empty() && !asTriangles ? internal.Buffers.GetFailure() : problem;
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
void vtkBarycentricShellMapper::ReleaseBuffers(vtkWindow* window)
{
  this->Internal->Buffers.ReleaseGraphicsResources(window);
  this->Internal->Shells.ReleaseGraphicsResources(window);
  this->Internal->Projection.ReleaseGraphicsResources(window);
  this->Internal->Surfaces.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseBuffers(window);
}
