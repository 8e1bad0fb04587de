#include "DepthLayers.h"

#include "VTKVersions.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <limits>

namespace
{
// Behind and before every depth there is.
constexpr float Behind = std::numeric_limits<float>::max();
constexpr float Before = -std::numeric_limits<float>::max();
}

DepthLayers::DepthLayers() = default;
DepthLayers::~DepthLayers() = default;

//------------------------------------------------------------------------------
bool DepthLayers::MakeTarget(Layer& layer, int width, int height)
{
  layer.Framebuffer->SetContext(this->Window);
  layer.Depth->SetContext(this->Window);
  if (static_cast<int>(layer.Depth->GetWidth()) != width ||
      static_cast<int>(layer.Depth->GetHeight()) != height)
  {
    layer.Depth->SetMinificationFilter(vtkTextureObject::Nearest);
    layer.Depth->SetMagnificationFilter(vtkTextureObject::Nearest);
    layer.Depth->Allocate2D(width, height, 1, VTK_FLOAT);
  }
  layer.Framebuffer->Bind();
  layer.Framebuffer->AddColorAttachment(0, layer.Depth);
  layer.Framebuffer->ActivateDrawBuffer(0);
  const char* reason = nullptr;
  return vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_FRAMEBUFFER, reason) != 0;
}

//------------------------------------------------------------------------------
bool DepthLayers::Begin(vtkOpenGLRenderWindow* window, int width, int height)
{
  this->Window = window;
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  const bool good = this->MakeTarget(this->Layers[0], width, height) &&
                    this->MakeTarget(this->Layers[1], width, height);
  state->PopFramebufferBindings();
  if (!good)
  {
    return false;
  }
  if (this->Query == 0)
  {
    glGenQueries(1, &this->Query);
  }
  for (Layer& layer : this->Layers)
  {
    layer.Depth->Activate();
  }
  return true;
}

//------------------------------------------------------------------------------
void DepthLayers::End()
{
  for (Layer& layer : this->Layers)
  {
    layer.Depth->Deactivate();
  }
}

//------------------------------------------------------------------------------
void DepthLayers::BindAndClear(Layer& layer, float depth)
{
  layer.Framebuffer->Bind();
  // Never clamped, as the clear colour may be.
  const float values[4] = { depth, depth, depth, depth };
  glClearBufferfv(GL_COLOR, 0, values);
}

//------------------------------------------------------------------------------
void DepthLayers::BeginGroup(const std::array<int, 4>& box)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(box[0], box[1], box[2], box[3]);
  state->PushFramebufferBindings();
  this->BindAndClear(this->Layers[this->Newest], Behind);
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void DepthLayers::BeginSearch(vtkShaderProgram* program)
{
  const Layer& behind = this->Layers[this->Newest];
  program->SetUniformi("layerBehind", behind.Depth->GetTextureUnit());
  this->Newest = 1 - this->Newest;
  vtkOpenGLState* state = this->Window->GetState();
  state->PushFramebufferBindings();
  this->BindAndClear(this->Layers[this->Newest], Before);
  state->vtkglBlendEquation(GL_MAX);
  glBeginQuery(GL_SAMPLES_PASSED, this->Query);
}

//------------------------------------------------------------------------------
void DepthLayers::EndSearch()
{
  glEndQuery(GL_SAMPLES_PASSED);
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
bool DepthLayers::WasAnyFound()
{
  unsigned int samples = 0;
  glGetQueryObjectuiv(this->Query, GL_QUERY_RESULT, &samples);
  return samples > 0;
}

//------------------------------------------------------------------------------
void DepthLayers::SetUniforms(vtkShaderProgram* program)
{
  program->SetUniformi("thisLayer", this->Layers[this->Newest].Depth->GetTextureUnit());
  program->SetUniformi("layerBehind", this->Layers[1 - this->Newest].Depth->GetTextureUnit());
}

//------------------------------------------------------------------------------
void DepthLayers::DrawGroup(
  const std::array<int, 4>& box, int cells, const Programs& programs, const Drawer& draw)
{
  const vtkOpenGLState::ScopedglEnableDisable scissorTest(
    this->Window->GetState(), GL_SCISSOR_TEST);
  const vtkOpenGLState::ScopedglScissor scissor(this->Window->GetState());
  vtkOpenGLShaderCache* shaders = this->Window->GetShaderCache();
  this->BeginGroup(box);
  bool found = box[2] > 0 && box[3] > 0;
  for (int layer = 0; found && layer <= cells; ++layer)
  {
    shaders->ReadyShaderProgram(programs.Search);
    this->BeginSearch(programs.Search);
    draw(programs.Search);
    this->EndSearch();
    // Drawn even where nothing was found: rounding may have left a cell between the two programs.
    shaders->ReadyShaderProgram(programs.Layer);
    this->SetUniforms(programs.Layer);
    draw(programs.Layer);
    found = this->WasAnyFound();
  }
}

//------------------------------------------------------------------------------
void DepthLayers::ReleaseGraphicsResources(vtkWindow* window)
{
  for (Layer& layer : this->Layers)
  {
    layer.Framebuffer->ReleaseGraphicsResources(window);
    layer.Depth->ReleaseGraphicsResources(window);
  }
  if (this->Query != 0)
  {
    glDeleteQueries(1, &this->Query);
    this->Query = 0;
  }
}
