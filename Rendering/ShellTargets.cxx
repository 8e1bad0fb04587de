#include "ShellTargets.h"

#include "VTKVersions.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <string>

//------------------------------------------------------------------------------
bool ShellTargets::MakeSet(vtkOpenGLRenderWindow* window, Set& set, int width, int height)
{
  set.Framebuffer->SetContext(window);
  set.Framebuffer->Bind();
  set.Framebuffer->RemoveColorAttachments(4);
  for (int i = 0; i < this->NumberOfTargets; ++i)
  {
    vtkTextureObject* texture = set.Slices[i];
    texture->SetContext(window);
    if (static_cast<int>(texture->GetWidth()) != width ||
        static_cast<int>(texture->GetHeight()) != height)
    {
      texture->SetMinificationFilter(vtkTextureObject::Nearest);
      texture->SetMagnificationFilter(vtkTextureObject::Nearest);
      texture->Allocate2D(width, height, 4, VTK_FLOAT);
    }
    set.Framebuffer->AddColorAttachment(i, texture);
  }
  set.Framebuffer->ActivateDrawBuffers(this->NumberOfTargets);
  const char* reason = nullptr;
  return vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_FRAMEBUFFER, reason);
}

//------------------------------------------------------------------------------
bool ShellTargets::Prepare(
  vtkOpenGLRenderWindow* window, int width, int height, int samplesPerShell)
{
  this->NumberOfTargets = samplesPerShell / 4;
  window->GetState()->PushFramebufferBindings();
  const bool good = this->MakeSet(window, this->Sets[0], width, height) &&
                    this->MakeSet(window, this->Sets[1], width, height);
  window->GetState()->PopFramebufferBindings();
  return good;
}

//------------------------------------------------------------------------------
void ShellTargets::BeginShell(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Newest = 1 - this->Newest;
  Set& set = this->Sets[this->Newest];
  set.Framebuffer->Bind();
  set.Framebuffer->ActivateDrawBuffers(this->NumberOfTargets);
  // Never clamped, as the clear colour may be.
  const float values[4] = { Empty, Empty, Empty, Empty };
  for (int i = 0; i < this->NumberOfTargets; ++i)
  {
    glClearBufferfv(GL_COLOR, i, values);
  }
  state->vtkglBlendEquation(GL_MAX);
}

//------------------------------------------------------------------------------
void ShellTargets::EndShell(vtkOpenGLRenderWindow* window)
{
  window->GetState()->vtkglBlendEquation(GL_FUNC_ADD);
  window->GetState()->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void ShellTargets::Activate(vtkShaderProgram* program)
{
  Set& set = this->Sets[this->Newest];
  for (int i = 0; i < 4; ++i)
  {
    // A sampler that is not read must still name a texture of its kind.
    vtkTextureObject* texture = set.Slices[i < this->NumberOfTargets ? i : 0];
    texture->Activate();
    program->SetUniformi(("slices" + std::to_string(i)).c_str(), texture->GetTextureUnit());
  }
  vtkTextureObject* last = this->Sets[1 - this->Newest].Slices[this->NumberOfTargets - 1];
  last->Activate();
  program->SetUniformi("lastSlices", last->GetTextureUnit());
}

//------------------------------------------------------------------------------
void ShellTargets::Deactivate()
{
  for (int i = 0; i < this->NumberOfTargets; ++i)
  {
    this->Sets[this->Newest].Slices[i]->Deactivate();
  }
  this->Sets[1 - this->Newest].Slices[this->NumberOfTargets - 1]->Deactivate();
}

//------------------------------------------------------------------------------
void ShellTargets::ReleaseGraphicsResources(vtkWindow* window)
{
  for (Set& set : this->Sets)
  {
    for (auto& texture : set.Slices)
    {
      texture->ReleaseGraphicsResources(window);
    }
    set.Framebuffer->ReleaseGraphicsResources(window);
  }
}
