#include "ShellRaster.h"

#include "ElementBuffers.h"
#include "MeshBlocks.h"
#include "RayUniforms.h"
#include "ShellCells.h"
#include "ShellPlan.h"
#include "VTKVersions.h"
#include "ViewRays.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <glm/geometric.hpp>

#include <algorithm>

namespace
{
// How many shells pass between two looks whether anything can still be seen.
constexpr int ShellsPerQuery = 8;
}

//------------------------------------------------------------------------------
bool ShellRaster::Prepare(vtkOpenGLRenderWindow* window, const View& view)
{
  const ShellShaders::Variant variant{ view.IsPreIntegrated, view.IsTextured,
    view.Plan->SamplesPerShell / 4 };
  if (this->BlendSource.empty() || !(variant == this->Variant))
  {
    this->Variant = variant;
    this->BlendSource = ShellShaders::BlendSource(variant);
  }
  const bool compiled = this->Blend.Ready(window, this->BlendSource) &&
                        this->Open.Ready(window, ShellShaders::OpenSource());
  this->Elements = ShellShaders::ReadyElements(window, view, variant);
  if (!compiled || !this->Elements)
  {
    this->Failure = "the shells' shaders did not compile";
  }
  return compiled && this->Elements;
}

//------------------------------------------------------------------------------
bool ShellRaster::Draw(vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers)
{
  this->NumberOfElements = 0;
  this->NumberOfShells = 0;
  if (view.Plan->NumberOfShells == 0 || view.Box[2] <= 0 || view.Box[3] <= 0)
  {
    return true;
  }
  if (!this->Prepare(window, view))
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  const vtkOpenGLState::ScopedglScissor scissor(state);
  const vtkOpenGLState::ScopedglBlendFuncSeparate function(state);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(view.Box[0], view.Box[1], view.Box[2], view.Box[3]);
  // What is behind shows as far as what is before lets it.
  state->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  view.OpaqueDepth->Activate();
  view.Image->Activate();
  window->GetShaderCache()->ReadyShaderProgram(this->Elements);
  RayUniforms::Set(this->Elements, view);
  this->Elements->SetUniformi("image", view.Image->GetTextureUnit());
  buffers.Activate(this->Elements);
  buffers.Activate(this->Blend.Ready(window, this->BlendSource));
  const bool drawn = this->DrawShells(window, view, buffers);
  buffers.Deactivate();
  view.Image->Deactivate();
  view.OpaqueDepth->Deactivate();
  return drawn;
}

//------------------------------------------------------------------------------
void ShellRaster::BeginLists(const View& view)
{
  this->Lists.resize(std::max<size_t>(view.Blocks->size(), 1));
  if (view.Blocks->empty())
  {
    this->Lists[0].Begin(
      *view.Cells, *view.Plan, 0, view.Cells->GetNumberOfCells(), view.Corners->data());
  }
  for (size_t i = 0; i < view.Blocks->size(); ++i)
  {
    const MeshBlock& block = (*view.Blocks)[i];
    this->Lists[i].Begin(*view.Cells, *view.Plan, block.Begin, block.End, block.Corners.data());
  }
}

//------------------------------------------------------------------------------
int ShellRaster::AdvanceLists()
{
  int elements = 0;
  for (ElementLists& lists : this->Lists)
  {
    lists.Advance();
    elements += lists.GetNumberOfElements();
  }
  return elements;
}

//------------------------------------------------------------------------------
bool ShellRaster::DrawShells(
  vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers)
{
  this->BeginLists(view);
  this->HasLast = false;
  for (int shell = 0; shell < view.Plan->NumberOfShells; ++shell)
  {
    const int elements = this->AdvanceLists();
    if (elements == 0)
    {
      this->HasLast = false;
      continue;
    }
    const bool asks = this->NumberOfShells % ShellsPerQuery == ShellsPerQuery - 1;
    if (!this->SampleShell(window, view, buffers, shell, asks))
    {
      this->Failure = "the driver has no room for the elements of a shell";
      return false;
    }
    this->BlendShell(window, view, shell);
    this->NumberOfElements += elements;
    ++this->NumberOfShells;
    this->HasLast = true;
    if (asks && this->IsOpaque())
    {
      break;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool ShellRaster::DrawLists(
  vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers)
{
  if (view.Blocks->empty())
  {
    return this->Vertices.Draw(this->Lists[0].Vertices, this->Elements);
  }
  bool drawn = true;
  for (size_t i = 0; drawn && i < view.Blocks->size(); ++i)
  {
    if (!this->Lists[i].Vertices.empty())
    {
      drawn = buffers.UploadBlock(window, *view.Prepared, (*view.Blocks)[i]);
      buffers.Activate(this->Elements);
      drawn = drawn && this->Vertices.Draw(this->Lists[i].Vertices, this->Elements);
    }
  }
  return drawn;
}

//------------------------------------------------------------------------------
void ShellRaster::SetShell(vtkShaderProgram* program, const View& view, int shell)
{
  const ViewRays& rays = *view.Rays;
  const double lengthPerDepth = glm::length(glm::dvec3(rays.World[0]));
  const double first = view.Plan->GetDistance(shell) + rays.EyeDepth * lengthPerDepth;
  const float values[3] = { static_cast<float>(first), static_cast<float>(view.Plan->Spacing),
    static_cast<float>(rays.EyeDepth) };
  program->SetUniform3f("shell", values);
}

//------------------------------------------------------------------------------
bool ShellRaster::SampleShell(vtkOpenGLRenderWindow* window, const View& view,
  ElementBuffers& buffers, int shell, bool asks)
{
  this->Targets.BeginShell(window);
  if (asks)
  {
    this->CountOpen(window, view);
  }
  window->GetShaderCache()->ReadyShaderProgram(this->Elements);
  this->SetShell(this->Elements, view, shell);
  const bool drawn = this->DrawLists(window, view, buffers);
  this->Targets.EndShell(window);
  return drawn;
}

//------------------------------------------------------------------------------
void ShellRaster::BlendShell(vtkOpenGLRenderWindow* window, const View& view, int shell)
{
  vtkShaderProgram* program = this->Blend.Ready(window, this->BlendSource);
  this->Targets.Activate(program);
  this->SetShell(program, view, shell);
  program->SetUniformi("isFirstShell", this->HasLast ? 0 : 1);
  this->Blend.Draw();
  this->Targets.Deactivate();
}

//------------------------------------------------------------------------------
void ShellRaster::CountOpen(vtkOpenGLRenderWindow* window, const View& view)
{
  if (this->Query == 0)
  {
    glGenQueries(1, &this->Query);
  }
  // Drawn to the slices, which it leaves empty, for the image cannot be read while it is drawn to.
  vtkShaderProgram* program = this->Open.Ready(window, ShellShaders::OpenSource());
  program->SetUniformi("image", view.Image->GetTextureUnit());
  glBeginQuery(GL_SAMPLES_PASSED, this->Query);
  this->Open.Draw();
  glEndQuery(GL_SAMPLES_PASSED);
}

//------------------------------------------------------------------------------
bool ShellRaster::IsOpaque() const
{
  unsigned int open = 0;
  glGetQueryObjectuiv(this->Query, GL_QUERY_RESULT, &open);
  return open == 0;
}

//------------------------------------------------------------------------------
void ShellRaster::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Vertices.ReleaseGraphicsResources();
  this->Targets.ReleaseGraphicsResources(window);
  this->Blend.ReleaseGraphicsResources();
  this->Open.ReleaseGraphicsResources();
  this->Elements = nullptr;
  if (this->Query != 0)
  {
    glDeleteQueries(1, &this->Query);
    this->Query = 0;
  }
}
