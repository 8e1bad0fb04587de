#include "IsoLayers.h"

#include "VTKVersions.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include CELLPROJECTION_OPENGL_HEADER

//------------------------------------------------------------------------------
bool IsoLayers::MakeLayer(vtkOpenGLRenderWindow* window, Layer& layer, int width, int height)
{
  layer.Color->SetContext(window);
  layer.Depth->SetContext(window);
  if (static_cast<int>(layer.Color->GetWidth()) != width ||
      static_cast<int>(layer.Color->GetHeight()) != height)
  {
    for (vtkTextureObject* texture : { layer.Color.GetPointer(), layer.Depth.GetPointer() })
    {
      texture->SetMinificationFilter(vtkTextureObject::Nearest);
      texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    }
    layer.Color->Allocate2D(width, height, 4, VTK_FLOAT);
    layer.Depth->AllocateDepth(width, height, vtkTextureObject::Float32);
  }
  layer.Framebuffer->SetContext(window);
  layer.Framebuffer->Bind();
  layer.Framebuffer->AddColorAttachment(0, layer.Color);
  layer.Framebuffer->AddDepthAttachment(layer.Depth);
  layer.Framebuffer->ActivateDrawBuffer(0);
  const char* reason = nullptr;
  return vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_FRAMEBUFFER, reason);
}

//------------------------------------------------------------------------------
bool IsoLayers::Prepare(vtkOpenGLRenderWindow* window, int width, int height)
{
  window->GetState()->PushFramebufferBindings();
  bool good = true;
  for (Layer& layer : this->Layers)
  {
    good = good && MakeLayer(window, layer, width, height);
  }
  window->GetState()->PopFramebufferBindings();
  if (this->Query == 0)
  {
    glGenQueries(1, &this->Query);
  }
  return good;
}

//------------------------------------------------------------------------------
void IsoLayers::BeginLayer(vtkOpenGLRenderWindow* window, bool isFirst)
{
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Last = isFirst ? 1 : this->Newest;
  this->Newest = isFirst ? 0 : this->Newest == 1 ? 2 : 1;
  Layer& layer = this->Layers[this->Newest];
  layer.Framebuffer->Bind();
  layer.Framebuffer->ActivateDrawBuffer(0);
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LESS);
  const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  const float farthest = 1.0f;
  glClearBufferfv(GL_COLOR, 0, nothing);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  glBeginQuery(GL_SAMPLES_PASSED, this->Query);
}

//------------------------------------------------------------------------------
void IsoLayers::EndLayer(vtkOpenGLRenderWindow* window)
{
  glEndQuery(GL_SAMPLES_PASSED);
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
bool IsoLayers::WasAnyDrawn() const
{
  unsigned int samples = 0;
  glGetQueryObjectuiv(this->Query, GL_QUERY_RESULT, &samples);
  return samples > 0;
}

//------------------------------------------------------------------------------
void IsoLayers::ReleaseGraphicsResources(vtkWindow* window)
{
  for (Layer& layer : this->Layers)
  {
    layer.Color->ReleaseGraphicsResources(window);
    layer.Depth->ReleaseGraphicsResources(window);
    layer.Framebuffer->ReleaseGraphicsResources(window);
  }
  if (this->Query != 0)
  {
    glDeleteQueries(1, &this->Query);
    this->Query = 0;
  }
}
