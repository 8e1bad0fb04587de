#include "ElementProjection.h"

#include "ElementBuffers.h"
#include "ElementShaders.h"
#include "RayUniforms.h"
#include "ScreenBox.h"
#include "VTKVersions.h"
#include "ViewRays.h"
#include "cpDepthLayer.h"
#include "cpElementProjection.h"
#include "cpElementSearch.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <algorithm>

namespace
{
std::string ProjectionSource(bool isLayer)
{
  std::string source = cpElementProjection;
  vtkShaderProgram::Substitute(source, "//VTK::Layer::Dec", isLayer ? cpDepthLayer : "");
  vtkShaderProgram::Substitute(source, "//VTK::Layer::Impl",
    isLayer ? "if (!isInLayer(base + passage.x))\n    discard;" : "");
  return source;
}
}

//------------------------------------------------------------------------------
bool ElementProjection::Prepare(
  vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers)
{
  const bool isTextured = buffers.GetTexture().IsUsed();
  const auto ready = [&](const std::string& fragment)
  {
    return ElementShaders::ReadyProgram(
      window, view, ElementShaders::WithElement(fragment, isTextured), isTextured);
  };
  const std::vector<DrawnCells::Run>& runs = view.Cells->Runs;
  this->HasLayers = std::any_of(
    runs.begin(), runs.end(), [](const DrawnCells::Run& run) { return run.IsCyclic; });
  this->Ready = Programs();
  if (this->HasLayers)
  {
    this->Ready.Search = ready(cpElementSearch);
    this->Ready.Layer = ready(ProjectionSource(true));
  }
  this->Ready.Cells = ready(ProjectionSource(false));
  const bool isReady =
    this->Ready.Cells && (!this->HasLayers || (this->Ready.Search && this->Ready.Layer));
  this->Failure = isReady ? "" : "the projection's shaders did not compile";
  if (isReady && this->HasLayers && !this->Layers.Begin(window, view.Width, view.Height))
  {
    this->Failure = "the driver cannot render to the layers of cyclic groups";
  }
  return this->Failure.empty();
}

//------------------------------------------------------------------------------
void ElementProjection::Activate(
  vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers)
{
  for (vtkShaderProgram* program : { this->Ready.Search, this->Ready.Layer, this->Ready.Cells })
  {
    if (program)
    {
      window->GetShaderCache()->ReadyShaderProgram(program);
      RayUniforms::Set(program, view);
      buffers.Activate(program);
    }
  }
}

//------------------------------------------------------------------------------
bool ElementProjection::Draw(
  vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers)
{
  if (view.Vertices->empty())
  {
    return true;
  }
  if (!this->Prepare(window, view, buffers))
  {
    return false;
  }
  view.OpaqueDepth->Activate();
  this->Activate(window, view, buffers);
  const bool drawn = this->Vertices.Begin(*view.Vertices);
  if (drawn)
  {
    this->DrawRuns(window, view);
  }
  this->Vertices.End();
  if (this->HasLayers)
  {
    this->Layers.End();
  }
  buffers.Deactivate();
  view.OpaqueDepth->Deactivate();
  this->Failure = drawn ? "" : "the driver has no room for the elements";
  return drawn;
}

//------------------------------------------------------------------------------
void ElementProjection::DrawRuns(vtkOpenGLRenderWindow* window, const View& view)
{
  for (const DrawnCells::Run& run : view.Cells->Runs)
  {
    if (run.IsCyclic)
    {
      this->DrawGroup(view, run);
    }
    else
    {
      window->GetShaderCache()->ReadyShaderProgram(this->Ready.Cells);
      this->Vertices.DrawPart(run.First, run.Count, this->Ready.Cells);
    }
  }
}

//------------------------------------------------------------------------------
void ElementProjection::DrawGroup(const View& view, const DrawnCells::Run& run)
{
  const std::array<int, 4> box = ScreenBox::Around(*view.Points, *view.Corners,
    &view.Cells->Cells[run.First], run.Count, { view.Rays->MeshToClip, view.Width, view.Height });
  this->Layers.DrawGroup(box, run.Count, { this->Ready.Search, this->Ready.Layer },
    [&](vtkShaderProgram* program) { this->Vertices.DrawPart(run.First, run.Count, program); });
}

//------------------------------------------------------------------------------
void ElementProjection::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Vertices.ReleaseGraphicsResources();
  this->Layers.ReleaseGraphicsResources(window);
}
