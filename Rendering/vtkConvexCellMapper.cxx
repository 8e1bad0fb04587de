#include "vtkConvexCellMapper.h"

#include "BlendModeAdvice.h"
#include "ConvexCellMapperInternals.h"
#include "MapperMessages.h"
#include "MeshExtent.h"
#include "PremultipliedBlending.h"
#include "ScalarChoice.h"
#include "SceneView.h"
#include "VTKVersions.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <algorithm>

//------------------------------------------------------------------------------
vtkConvexCellMapper::vtkConvexCellMapper()
  : Internal(new Internals)
{
  this->Internal->Cells->AddObserver(
    vtkCommand::ProgressEvent, this, &vtkConvexCellMapper::ReportCells);
}

//------------------------------------------------------------------------------
vtkConvexCellMapper::~vtkConvexCellMapper() = default;

//------------------------------------------------------------------------------
void vtkConvexCellMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  CellProjectionFrame frame;
  if (!this->BeginFrame(renderer, volume, frame))
  {
    return;
  }
  if (this->PrepareCells(frame) && this->PrepareScalars(frame) && this->PrepareView(frame))
  {
    this->PrepareTransferFunction(frame);
    this->SortCells(frame);
    this->EndPreparation(frame);
    const bool isDrawn = this->Project(frame);
    if (isDrawn && !this->DrawsIntoWindow())
    {
      this->Blend(frame);
    }
    this->RecordSampling(frame, isDrawn);
  }
  this->EndPreparation(frame);
  this->EndFrame(frame);
}

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::BeginFrame(
  vtkRenderer* renderer, vtkVolume* volume, CellProjectionFrame& frame)
{
  if (renderer->GetSelector())
  {
    return false;
  }
  frame.Renderer = renderer;
  frame.Volume = volume;
  frame.Statistics.Method = this->GetMethodName();
  this->Internal->Captured = nullptr;
  this->Internal->Statistics = frame.Statistics;
  return this->PassesWithout(MapperMessages::RendererProblem(renderer)) && this->EnterWindow(frame);
}

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::EnterWindow(CellProjectionFrame& frame)
{
  frame.Window = static_cast<vtkOpenGLRenderWindow*>(frame.Renderer->GetRenderWindow());
  frame.Renderer->GetTiledSizeAndOrigin(
    &frame.Size[0], &frame.Size[1], &frame.Origin[0], &frame.Origin[1]);
  std::copy_n(frame.Size, 2, frame.ImageSize);
  frame.Box = { { 0, 0, frame.Size[0], frame.Size[1] } };
  if (frame.Size[0] <= 0 || frame.Size[1] <= 0)
  {
    this->WarnOnce("The viewport has " + std::to_string(frame.Size[0]) + "x" +
                   std::to_string(frame.Size[1]) + " pixels: nothing is drawn.");
    return false;
  }
  if (this->Internal->Window != frame.Window)
  {
    this->LeaveWindow();
    frame.Window->MakeCurrent();
  }
  this->Internal->Window = frame.Window;
  this->ChooseEngine(frame);
  return true;
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::LeaveWindow()
{
  if (this->Internal->Window)
  {
    this->ReleaseGraphicsResources(this->Internal->Window);
  }
}

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::PrepareCells(CellProjectionFrame& frame)
{
  FrameStatistics::Timer timer(frame.Statistics.SecondsPrepare);
  if (!this->CheckInput())
  {
    return false;
  }
  vtkConvexCells* cells = this->Internal->Cells;
  MapperInput::Feed(this->Internal->Mesh, this, cells);
  cells->SetTolerance(this->Tolerance);
  cells->SetTetrahedraOnly(this->NeedsTetrahedra());
  cells->SetKeepCells(this->KeepsCells());
  cells->Update();
  frame.Statistics.CellsIn = this->Internal->Mesh->GetNumberOfCells();
  frame.Statistics.CellsSkippedInvalid = cells->GetNumberOfSkippedCells();
  if (cells->GetNumberOfSkippedCells() > 0)
  {
    this->WarnOnce(cells->GetLeftOutSummary() + ". They are skipped, the rest is drawn.");
  }
  if (this->Internal->TakeGeometry(cells->GetOutput()))
  {
    this->ReportPreparation(0.5);
  }
  return cells->GetOutput()->GetNumberOfCells() > 0;
}

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::PrepareScalars(CellProjectionFrame& frame)
{
  FrameStatistics::Timer timer(frame.Statistics.SecondsPrepare);
  Internals& internal = *this->Internal;
  PreparedVolume& prepared = internal.Prepared;
  const ScalarChoice choice(this, internal.Mesh);
  vtkDataArray* own = this->GetOwnScalars();
  if (!own && !choice.Array)
  {
    this->FailOnce("No scalars: " + choice.Problem);
    return false;
  }
  VolumePropertyReader reader(frame.Volume->GetProperty());
  const int components = (own ? own : choice.Array)->GetNumberOfComponents();
  const bool onePerCell = !own && choice.OnePerCell;
  for (const std::string& text :
    reader.FindUnsupported(components, onePerCell, this->CanShade(), this->CanDepend()))
  {
    this->WarnOnce(text);
  }
  // The cells' own copy of the array: points merge, cells are cut up.
  vtkDataArray* array = own ? own : choice.FindIn(prepared.Cells, this);
  if (!array)
  {
    return false;
  }
  const ScalarSource source{ array, reader.ChooseComponent(components, this->CanDepend()),
    reader.FindLimits() };
  prepared.Array = array;
  if (prepared.ScalarsTime < prepared.CellsTime || prepared.ScalarsTime < array->GetMTime() ||
      !(source == internal.SeenSource))
  {
    internal.SeenSource = source;
    prepared.Scalars.Build(array, source.Component, onePerCell, source.Limits.data());
    prepared.ScalarsTime.Modified();
  }
  if (prepared.Scalars.NumberOfNonFiniteValues > 0)
  {
    this->WarnOnce(MapperMessages::NonFiniteScalars(array, prepared.Scalars));
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::PrepareTransferFunction(CellProjectionFrame& frame)
{
  FrameStatistics::Timer timer(frame.Statistics.SecondsPrepare);
  PreparedVolume& prepared = this->Internal->Prepared;
  VolumePropertyReader reader(frame.Volume->GetProperty());
  const VolumePropertyReader::Source source = reader.FindSource();
  if (source == this->Internal->SeenFunction && prepared.FunctionTime > prepared.ScalarsTime &&
      this->Internal->SeenPerLength == this->IsOpacityPerLength())
  {
    return;
  }
  std::vector<std::string> problems;
  const ScalarField& scalars = prepared.Scalars;
  reader.Read(scalars.Normal, scalars.Range, scalars.OnePerCell, this->IsOpacityPerLength(),
    prepared.Function, problems);
  for (const std::string& text : problems)
  {
    this->WarnOnce(text);
  }
  this->Internal->SeenFunction = source;
  this->Internal->SeenPerLength = this->IsOpacityPerLength();
  prepared.FunctionTime.Modified();
}

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::PrepareView(CellProjectionFrame& frame)
{
  if (!SceneView::SetRays(frame, this->Internal->Prepared.Coordinates))
  {
    return this->PassesWithout(
      "The matrix of the volume or of the camera cannot be inverted, or has no far plane: nothing is drawn.");
  }
  this->WarnOnce(MapperMessages::ExcessPlanes(this->ClippingPlanes));
  SceneView::SetClippingPlanes(frame, this->ClippingPlanes);
  if (!this->CaptureImage)
  {
    const MeshCoordinates& coordinates = this->Internal->Prepared.Coordinates;
    frame.Box = MeshExtent::FindScreenBox(coordinates, frame.GetRasterView());
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::Project(CellProjectionFrame& frame)
{
  FrameStatistics::Timer timer(frame.Statistics.SecondsProject);
  if (!this->DrawsIntoWindow())
  {
    return frame.UsesTiles ? this->ProjectByTiles(frame) : this->ProjectIntoTarget(frame);
  }
  const bool drawn = this->ProjectCells(frame);
  glFinish();
  return drawn;
}

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::ProjectIntoTarget(CellProjectionFrame& frame)
{
  const bool hasDepth = this->Internal->Depth.Grab(frame.Window, frame.Origin, frame.Size);
  this->WarnOnce(MapperMessages::UnreadableDepth(hasDepth));
  frame.OpaqueDepth = this->Internal->Depth.GetTexture();
  const PremultipliedBlending blending(frame.Window->GetState());
  if (!this->Internal->Target.Begin(frame.Window, frame.Size[0], frame.Size[1]))
  {
    this->FailOnce("The driver cannot render to 32-bit float images: nothing is drawn.");
    return false;
  }
  frame.Image = this->Internal->Target.GetTexture();
  const bool drawn = this->ProjectCells(frame);
  this->Internal->Target.End(frame.Window);
  // Without it the seconds would be those of the submission, and the blend would pay for the cells.
  glFinish();
  return drawn;
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::Blend(CellProjectionFrame& frame)
{
  FrameStatistics::Timer timer(frame.Statistics.SecondsBlend);
  if (frame.Pixels && this->LayPixelsOver(frame))
  {
    return;
  }
  if (this->CaptureImage)
  {
    this->Internal->Captured = vtkSmartPointer<vtkImageData>::New();
    this->Internal->Target.Capture(this->Internal->Captured);
  }
  const PremultipliedBlending blending(frame.Window->GetState());
  this->Internal->Target.Blend(frame.Window, frame.Origin, frame.Size, frame.Box);
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::EndFrame(CellProjectionFrame& frame)
{
  this->Internal->Statistics = frame.Statistics;
  const FrameStatistics& s = frame.Statistics;
  this->TimeToDraw = s.SecondsPrepare + s.SecondsSort + s.SecondsProject + s.SecondsBlend;
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::SetBlendMode(int mode)
{
  if (this->CanDrawBlendMode(mode))
  {
    this->Superclass::SetBlendMode(mode);
    return;
  }
  vtkErrorMacro(
    "Blend mode " << mode << " is not drawn by this mapper: " << BlendModeAdvice(mode) << ".");
}

//------------------------------------------------------------------------------
vtkImageData* vtkConvexCellMapper::GetCapturedImage()
{
  return this->Internal->Captured;
}

//------------------------------------------------------------------------------
vtkTable* vtkConvexCellMapper::GetLastStatistics()
{
  this->Internal->Statistics.FillTable(this->Internal->StatisticsTable);
  return this->Internal->StatisticsTable;
}

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::IsSupported(vtkRenderWindow* window)
{
  // VTK's own windows ask for OpenGL 3.2, which has all that Raster needs.
  auto* glWindow = vtkOpenGLRenderWindow::SafeDownCast(window);
  return glWindow && glWindow->SupportsOpenGL() != 0;
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  // GL names mean something in their own context only: in another they name what others made. A
  // window that is being destroyed is no longer known here, and has made its context current.
  vtkOpenGLRenderWindow* own = this->Internal->Window;
  if (own && own != window)
  {
    return;
  }
  if (own)
  {
    own->PushContext();
  }
  this->ReleaseBuffers(window);
  this->Internal->Window = nullptr;
  if (own)
  {
    own->PopContext();
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::ReleaseBuffers(vtkWindow* window)
{
  this->Internal->Depth.ReleaseGraphicsResources(window);
  this->Internal->Target.ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
const PreparedVolume& vtkConvexCellMapper::GetPreparedVolume() const
{
  return this->Internal->Prepared;
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::WarnOnce(const std::string& text)
{
  if (!text.empty() && this->Internal->Reported.insert(text).second)
  {
    vtkWarningMacro(<< text);
  }
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::FailOnce(const std::string& text)
{
  if (this->Internal->Reported.insert(text).second)
  {
    vtkErrorMacro(<< text);
  }
}

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::PassesWithout(const std::string& problem)
{
  if (!problem.empty())
  {
    this->FailOnce(problem);
  }
  return problem.empty();
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Engine: " << this->Engine << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "CaptureImage: " << this->CaptureImage << "\n";
  os << indent << "AutoAdjustSampleDistances: " << this->AutoAdjustSampleDistances << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "MinimumImageSampleDistance: " << this->MinimumImageSampleDistance << "\n";
  os << indent << "MaximumImageSampleDistance: " << this->MaximumImageSampleDistance << "\n";
}
