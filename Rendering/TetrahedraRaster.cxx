#include "TetrahedraRaster.h"

#include "RayUniforms.h"
#include "ScreenBox.h"
#include "ShadingBuffers.h"
#include "TransferFunction.h"
#include "VTKVersions.h"
#include "ViewRays.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <algorithm>

//------------------------------------------------------------------------------
bool TetrahedraRaster::Check(const TextureBuffer& buffer, bool uploaded)
{
  if (!uploaded)
  {
    this->Failure = buffer.GetFailure();
  }
  return uploaded;
}

//------------------------------------------------------------------------------
bool TetrahedraRaster::UploadPoints(vtkOpenGLRenderWindow* window, const std::vector<float>& points)
{
  return this->Check(this->Points, this->Points.Upload(window, points, 4));
}

//------------------------------------------------------------------------------
bool TetrahedraRaster::UploadCorners(vtkOpenGLRenderWindow* window, const std::vector<int>& corners)
{
  return this->Check(this->Corners, this->Corners.Upload(window, corners, 4));
}

//------------------------------------------------------------------------------
bool TetrahedraRaster::UploadPlanes(vtkOpenGLRenderWindow* window, const std::vector<float>& planes)
{
  return this->Check(this->Planes, this->Planes.Upload(window, planes, 4));
}

//------------------------------------------------------------------------------
bool TetrahedraRaster::UploadScalars(
  vtkOpenGLRenderWindow* window, const std::vector<float>& scalars)
{
  return this->Check(this->Scalars, this->Scalars.Upload(window, scalars, 4));
}

//------------------------------------------------------------------------------
bool TetrahedraRaster::UploadTransferFunction(
  vtkOpenGLRenderWindow* window, const TransferFunction& function)
{
  this->NumberOfNodes = function.GetNumberOfNodes();
  return this->Check(
           this->NodePositions, this->NodePositions.Upload(window, function.GetPositions(), 1)) &&
         this->Check(this->NodeValues, this->NodeValues.Upload(window, function.GetValues(), 4));
}

//------------------------------------------------------------------------------
bool TetrahedraRaster::UploadOrder(const DrawnCells& cells)
{
  return cells.Cells.empty() ||
         this->Order->Upload(cells.Cells, vtkOpenGLBufferObject::ElementArrayBuffer);
}

//------------------------------------------------------------------------------
bool TetrahedraRaster::BuildPrograms(
  vtkOpenGLRenderWindow* window, const View& view, bool withLayers, Programs& programs)
{
  using TetrahedraShaders::ReadyProgram;
  using TetrahedraShaders::Task;
  TetrahedraShaders::Variant variant;
  variant.Integration = view.Integration;
  variant.IsLit = view.Shading && view.Shading->IsLit();
  variant.HasGradientOpacity = view.Shading && view.Shading->HasGradientOpacity();
  variant.Colors = view.Shading ? view.Shading->GetColors() : DependentColors::None;
  if (withLayers)
  {
    programs.Search = ReadyProgram(window, view, Task::LayerSearch, variant);
    programs.Layer = ReadyProgram(window, view, Task::Layer, variant);
  }
  programs.Cells = ReadyProgram(window, view, Task::Cells, variant);
  const bool compiled = programs.Cells && (!withLayers || (programs.Search && programs.Layer));
  if (!compiled)
  {
    this->Failure = "the projection's shaders did not compile";
  }
  return compiled;
}

//------------------------------------------------------------------------------
void TetrahedraRaster::SetUniforms(vtkShaderProgram* program, const View& view)
{
  RayUniforms::Set(program, view);
  program->SetUniformi("numberOfNodes", this->NumberOfNodes);
  for (const NamedBuffer& named : this->GetBuffers())
  {
    named.Buffer->Activate(program, named.Sampler);
  }
  if (view.Integration == SegmentIntegration::Table)
  {
    this->Table.Activate(program);
    program->SetUniformi("samplesPerSegment", view.SamplesPerSegment);
  }
  if (view.Shading)
  {
    view.Shading->Activate(program);
  }
}

//------------------------------------------------------------------------------
bool TetrahedraRaster::BeginCells(
  vtkOpenGLRenderWindow* window, const View& view, Programs& programs)
{
  const std::vector<DrawnCells::Run>& runs = view.Cells->Runs;
  const bool withLayers =
    std::any_of(runs.begin(), runs.end(), [](const DrawnCells::Run& run) { return run.IsCyclic; });
  if (!this->BuildPrograms(window, view, withLayers, programs))
  {
    return false;
  }
  if (withLayers && !this->Layers.Begin(window, view.Width, view.Height))
  {
    this->Failure = "the driver cannot render to single floats";
    return false;
  }
  view.OpaqueDepth->Activate();
  for (vtkShaderProgram* program : { programs.Search, programs.Layer, programs.Cells })
  {
    if (program)
    {
      window->GetShaderCache()->ReadyShaderProgram(program);
      this->SetUniforms(program, view);
    }
  }
  this->VertexArray.Bind();
  this->Order->Bind();
  return true;
}

//------------------------------------------------------------------------------
void TetrahedraRaster::EndCells(const View& view, const Programs& programs)
{
  this->Order->Release();
  EmptyVertexArray::Release();
  for (const NamedBuffer& named : this->GetBuffers())
  {
    named.Buffer->Deactivate();
  }
  if (view.Integration == SegmentIntegration::Table)
  {
    this->Table.Deactivate();
  }
  if (view.Shading)
  {
    view.Shading->Deactivate();
  }
  view.OpaqueDepth->Deactivate();
  if (programs.Layer)
  {
    this->Layers.End();
  }
}

//------------------------------------------------------------------------------
bool TetrahedraRaster::Draw(vtkOpenGLRenderWindow* window, const View& view)
{
  if (view.Cells->Runs.empty())
  {
    return true;
  }
  Programs programs;
  if (!this->BeginCells(window, view, programs))
  {
    return false;
  }
  for (const DrawnCells::Run& run : view.Cells->Runs)
  {
    if (run.IsCyclic)
    {
      this->DrawGroup(run, view, programs);
    }
    else
    {
      window->GetShaderCache()->ReadyShaderProgram(programs.Cells);
      this->DrawRun(run);
    }
  }
  this->EndCells(view, programs);
  return true;
}

//------------------------------------------------------------------------------
std::array<TetrahedraRaster::NamedBuffer, 6> TetrahedraRaster::GetBuffers()
{
  return { { { &this->Points, "points" }, { &this->Corners, "cornerIds" },
    { &this->Planes, "cellPlanes" }, { &this->Scalars, "cellScalars" },
    { &this->NodePositions, "nodePositions" }, { &this->NodeValues, "nodeValues" } } };
}

//------------------------------------------------------------------------------
void TetrahedraRaster::DrawRun(const DrawnCells::Run& run)
{
  const size_t offset = sizeof(unsigned int) * static_cast<size_t>(run.First);
  glDrawElements(GL_POINTS, run.Count, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
}

//------------------------------------------------------------------------------
void TetrahedraRaster::DrawGroup(
  const DrawnCells::Run& run, const View& view, const Programs& programs)
{
  const std::array<int, 4> box = ScreenBox::Around(*view.Points, *view.Corners,
    &view.Cells->Cells[run.First], run.Count, { view.Rays->MeshToClip, view.Width, view.Height });
  this->Layers.DrawGroup(box, run.Count, { programs.Search, programs.Layer },
    [&](vtkShaderProgram*) { this->DrawRun(run); });
}

//------------------------------------------------------------------------------
void TetrahedraRaster::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const NamedBuffer& named : this->GetBuffers())
  {
    named.Buffer->ReleaseGraphicsResources(window);
  }
  this->Table.ReleaseGraphicsResources(window);
  this->Order->ReleaseGraphicsResources();
  this->Layers.ReleaseGraphicsResources(window);
  this->VertexArray.ReleaseGraphicsResources();
}
