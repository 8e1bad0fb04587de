#include "vtkConvexCellMapper.h"

#include "ConvexCellMapperInternals.h"
#include "PremultipliedBlending.h"
#include "RayUniforms.h"
#include "ScalarChoice.h"
#include "SceneView.h"
#include "VTKVersions.h"
#include "VolumePropertyReader.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace
{
const char* MapperForBlendMode(int mode)
{
  switch (mode)
  {
    case vtkConvexCellMapper::COMPOSITE:
      return "use vtkPreIntegratedTetrahedraMapper";
    case vtkConvexCellMapper::MAXIMUM_INTENSITY:
    case vtkConvexCellMapper::MINIMUM_INTENSITY:
      return "use vtkMaximumProjectionMapper";
    case vtkConvexCellMapper::ADDITIVE:
      return "use vtkProjectedPolyhedraMapper";
    case vtkConvexCellMapper::ISOSURFACE:
      return "use vtkBarycentricShellMapper";
    default:
      return "the modes are 0, 1, 2, 4 and 5";
  }
}
}

//------------------------------------------------------------------------------
vtkConvexCellMapper::vtkConvexCellMapper()
  : Internal(new Internals)
{
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
    if (this->Project(frame))
    {
      this->Blend(frame);
    }
  }
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
  this->Internal->Captured = nullptr;
  frame.Renderer = renderer;
  frame.Volume = volume;
  frame.Window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  frame.Statistics.Method = this->GetMethodName();
  frame.Statistics.Engine = "Raster";
  renderer->GetTiledSizeAndOrigin(
    &frame.Size[0], &frame.Size[1], &frame.Origin[0], &frame.Origin[1]);
  if (!frame.Window)
  {
    this->FailOnce("The renderer has no OpenGL window: nothing is drawn.");
    return false;
  }
  if (frame.Size[0] <= 0 || frame.Size[1] <= 0)
  {
    this->WarnOnce("The viewport has " + std::to_string(frame.Size[0]) + "x" +
                   std::to_string(frame.Size[1]) + " pixels: nothing is drawn.");
    return false;
  }
  if (this->Internal->Window && this->Internal->Window != frame.Window)
  {
    this->ReleaseGraphicsResources(this->Internal->Window);
    frame.Window->MakeCurrent();
  }
  this->Internal->Window = frame.Window;
  if (this->Engine == TILES)
  {
    this->WarnOnce("The Tiles engine is not part of this version: drawn by Raster.");
  }
  return true;
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
  cells->SetInputData(this->GetInput());
  cells->SetTetrahedraOnly(this->NeedsTetrahedra());
  cells->Update();
  frame.Statistics.CellsIn = this->GetInput()->GetNumberOfCells();
  frame.Statistics.CellsSkippedInvalid = cells->GetNumberOfSkippedCells();
  if (cells->GetNumberOfSkippedCells() > 0)
  {
    this->WarnOnce(cells->GetLeftOutSummary() + ". They are skipped, the rest is drawn.");
  }
  vtkUnstructuredGrid* convex = cells->GetOutput();
  if (this->Internal->SeenCells != convex->GetMTime())
  {
    this->Internal->SeenCells = convex->GetMTime();
    this->Internal->Prepared.Cells = convex;
    this->Internal->Prepared.Coordinates.Build(convex);
    this->Internal->Prepared.CellsTime.Modified();
  }
  return convex->GetNumberOfCells() > 0;
}

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::CheckInput()
{
  vtkUnstructuredGridBase* input = this->GetInput();
  if (!input)
  {
    this->FailOnce("No input: call SetInputData or SetInputConnection with an unstructured grid.");
    return false;
  }
  if (input->GetNumberOfPoints() == 0 || input->GetNumberOfCells() == 0)
  {
    this->FailOnce("The input has " + std::to_string(input->GetNumberOfPoints()) + " points and " +
                   std::to_string(input->GetNumberOfCells()) + " cells: there is nothing to draw.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::PrepareScalars(CellProjectionFrame& frame)
{
  FrameStatistics::Timer timer(frame.Statistics.SecondsPrepare);
  const ScalarChoice choice(this, this->Internal->Prepared.Cells);
  vtkDataArray* array = choice.Array;
  if (!array)
  {
    this->FailOnce("No scalars: " + choice.Problem);
    return false;
  }
  VolumePropertyReader reader(frame.Volume->GetProperty());
  for (const std::string& text : reader.FindUnsupported(array->GetNumberOfComponents()))
  {
    this->WarnOnce(text);
  }
  const int component = reader.ChooseComponent(array->GetNumberOfComponents());
  PreparedVolume& prepared = this->Internal->Prepared;
  const vtkMTimeType built = prepared.ScalarsTime;
  if (built < prepared.CellsTime || built < this->GetMTime() ||
      component != this->Internal->SeenComponent)
  {
    this->Internal->SeenComponent = component;
    prepared.Scalars.Build(array, component, choice.OnePerCell);
    prepared.ScalarsTime.Modified();
  }
  return this->CheckScalars(array, choice.OnePerCell);
}

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::CheckScalars(vtkDataArray* array, bool onePerCell)
{
  const vtkIdType offenders = this->Internal->Prepared.Scalars.NumberOfNonFiniteValues;
  if (offenders == 0)
  {
    return true;
  }
  const std::string name = array->GetName() ? array->GetName() : "(without a name)";
  this->WarnOnce("Array " + name + " holds " + std::to_string(offenders) + " of " +
                 std::to_string(array->GetNumberOfTuples()) + " values that are not finite: " +
                 (onePerCell ? "these cells" : "the cells at these points") + " are skipped.");
  return offenders < array->GetNumberOfTuples();
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::PrepareTransferFunction(CellProjectionFrame& frame)
{
  FrameStatistics::Timer timer(frame.Statistics.SecondsPrepare);
  vtkVolumeProperty* property = frame.Volume->GetProperty();
  PreparedVolume& prepared = this->Internal->Prepared;
  const vtkMTimeType built = prepared.FunctionTime;
  if (property == this->Internal->SeenProperty && built > property->GetMTime() &&
      built > prepared.ScalarsTime)
  {
    return;
  }
  std::vector<std::string> problems;
  VolumePropertyReader reader(property);
  reader.Read(prepared.Scalars.Range, prepared.Function, problems);
  for (const std::string& text : problems)
  {
    this->WarnOnce(text);
  }
  this->Internal->SeenProperty = property;
  prepared.FunctionTime.Modified();
}

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::PrepareView(CellProjectionFrame& frame)
{
  if (!SceneView::SetRays(frame, this->Internal->Prepared.Coordinates))
  {
    this->FailOnce(
      "The matrix of the volume or of the camera cannot be inverted: nothing is drawn.");
    return false;
  }
  const int count = this->ClippingPlanes ? this->ClippingPlanes->GetNumberOfItems() : 0;
  if (count > RayUniforms::MaximumClippingPlanes)
  {
    this->WarnOnce(std::to_string(count) + " clipping planes are set: the first " +
                   std::to_string(RayUniforms::MaximumClippingPlanes) + " clip.");
  }
  SceneView::SetClippingPlanes(frame, this->ClippingPlanes);
  return true;
}

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::Project(CellProjectionFrame& frame)
{
  FrameStatistics::Timer timer(frame.Statistics.SecondsProject);
  if (!this->Internal->Depth.Grab(frame.Window, frame.Origin, frame.Size))
  {
    this->WarnOnce("The window's depth cannot be read: opaque geometry does not hide the volume.");
  }
  frame.OpaqueDepth = this->Internal->Depth.GetTexture();

  const PremultipliedBlending blending(frame.Window->GetState());
  if (!this->Internal->Target.Begin(frame.Window, frame.Size[0], frame.Size[1]))
  {
    this->FailOnce("The driver cannot render to 32-bit float images: nothing is drawn.");
    return false;
  }
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
  if (this->CaptureImage)
  {
    this->Internal->Captured = vtkSmartPointer<vtkImageData>::New();
    this->Internal->Target.Capture(this->Internal->Captured);
  }
  const PremultipliedBlending blending(frame.Window->GetState());
  this->Internal->Target.Blend(frame.Window, frame.Origin, frame.Size);
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
    "Blend mode " << mode << " is not drawn by this mapper: " << MapperForBlendMode(mode) << ".");
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::Update()
{
  // Without an input VTK's pipeline would repeat its own error several times a frame.
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    this->CheckInput();
    return;
  }
  this->Superclass::Update();
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
  this->Internal->Depth.ReleaseGraphicsResources(window);
  this->Internal->Target.ReleaseGraphicsResources(window);
  this->Internal->Window = nullptr;
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
const PreparedVolume& vtkConvexCellMapper::GetPreparedVolume() const
{
  return this->Internal->Prepared;
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::WarnOnce(const std::string& text)
{
  if (this->Internal->Reported.insert(text).second)
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
int vtkConvexCellMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Engine: " << this->Engine << "\n";
  os << indent << "CaptureImage: " << this->CaptureImage << "\n";
}
