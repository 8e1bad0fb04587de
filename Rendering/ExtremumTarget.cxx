#include "ExtremumTarget.h"

#include "VTKVersions.h"
#include "cpExtremumColourFragment.h"
#include "cpOpaqueQueryFragment.h"
#include "cpTransferFunction.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <limits>
#include <string>

namespace
{
std::string ColourSource()
{
  std::string source = cpExtremumColourFragment;
  vtkShaderProgram::Substitute(source, "//VTK::TransferFunction::Dec", cpTransferFunction);
  return source;
}
}

ExtremumTarget::ExtremumTarget() = default;
ExtremumTarget::~ExtremumTarget() = default;

//------------------------------------------------------------------------------
bool ExtremumTarget::Begin(vtkOpenGLRenderWindow* window, int width, int height, bool findLeast)
{
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->SetContext(window);
  this->Values->SetContext(window);
  if (static_cast<int>(this->Values->GetWidth()) != width ||
      static_cast<int>(this->Values->GetHeight()) != height)
  {
    this->Values->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Values->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->Values->Allocate2D(width, height, 1, VTK_FLOAT);
  }
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Values);
  this->Framebuffer->ActivateDrawBuffer(0);
  const char* reason = nullptr;
  if (!vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_FRAMEBUFFER, reason))
  {
    state->PopFramebufferBindings();
    return false;
  }
  this->Nothing = std::numeric_limits<float>::max() * (findLeast ? 1.0f : -1.0f);
  // Never clamped, as the clear colour may be.
  const float values[4] = { this->Nothing, this->Nothing, this->Nothing, this->Nothing };
  glClearBufferfv(GL_COLOR, 0, values);
  state->vtkglBlendEquation(findLeast ? GL_MIN : GL_MAX);
  return true;
}

//------------------------------------------------------------------------------
void ExtremumTarget::End(vtkOpenGLRenderWindow* window)
{
  window->GetState()->vtkglBlendEquation(GL_FUNC_ADD);
  window->GetState()->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
vtkShaderProgram* ExtremumTarget::ReadyQuad(
  vtkOpenGLRenderWindow* window, Quad& quad, const char* fragment)
{
  if (!quad)
  {
    quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, fragment, nullptr);
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(quad->Program);
  }
  return quad->Program && quad->Program->GetCompiled() ? quad->Program : nullptr;
}

//------------------------------------------------------------------------------
bool ExtremumTarget::HasOpaque(vtkOpenGLRenderWindow* window, vtkTextureObject* opaqueDepth)
{
  vtkShaderProgram* program = ReadyQuad(window, this->QueryQuad, cpOpaqueQueryFragment);
  if (!program)
  {
    return true;
  }
  if (this->Query == 0)
  {
    glGenQueries(1, &this->Query);
  }
  program->SetUniformi("opaqueDepth", opaqueDepth->GetTextureUnit());
  program->SetUniformf("nothing", this->Nothing);
  glBeginQuery(GL_SAMPLES_PASSED, this->Query);
  this->QueryQuad->Render();
  glEndQuery(GL_SAMPLES_PASSED);
  unsigned int samples = 0;
  glGetQueryObjectuiv(this->Query, GL_QUERY_RESULT, &samples);
  return samples > 0;
}

//------------------------------------------------------------------------------
vtkShaderProgram* ExtremumTarget::ReadyColourProgram(vtkOpenGLRenderWindow* window)
{
  static const std::string fragment = ColourSource();
  return ReadyQuad(window, this->ColourQuad, fragment.c_str());
}

//------------------------------------------------------------------------------
void ExtremumTarget::DrawColours(vtkShaderProgram* program)
{
  this->Values->Activate();
  program->SetUniformi("extrema", this->Values->GetTextureUnit());
  this->ColourQuad->Render();
  this->Values->Deactivate();
}

//------------------------------------------------------------------------------
void ExtremumTarget::ReleaseGraphicsResources(vtkWindow* window)
{
  this->ColourQuad.reset();
  this->QueryQuad.reset();
  this->Values->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  if (this->Query != 0)
  {
    glDeleteQueries(1, &this->Query);
    this->Query = 0;
  }
}
