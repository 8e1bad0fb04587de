#include "FloatTarget.h"

#include "PlainPixelStore.h"
#include "VTKVersions.h"
#include "cpBlendFragment.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPixelBufferObject.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <cstddef>

FloatTarget::FloatTarget() = default;
FloatTarget::~FloatTarget() = default;

//------------------------------------------------------------------------------
void FloatTarget::Allocate(vtkOpenGLRenderWindow* window, int width, int height)
{
  this->Color->SetContext(window);
  if (static_cast<int>(this->Color->GetWidth()) != width ||
      static_cast<int>(this->Color->GetHeight()) != height)
  {
    this->Color->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Color->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->Color->Allocate2D(width, height, 4, VTK_FLOAT);
  }
}

//------------------------------------------------------------------------------
void FloatTarget::Upload(
  vtkOpenGLRenderWindow* window, const int size[2], const Box& box, const float* image)
{
  this->Allocate(window, size[0], size[1]);
  this->Color->Activate();
  const PlainPixelStore plain;
  glPixelStorei(GL_UNPACK_ROW_LENGTH, size[0]);
  glTexSubImage2D(GL_TEXTURE_2D, 0, box[0], box[1], box[2], box[3], GL_RGBA, GL_FLOAT,
    image + 4 * (static_cast<std::ptrdiff_t>(box[1]) * size[0] + box[0]));
  this->Color->Deactivate();
}

//------------------------------------------------------------------------------
bool FloatTarget::Begin(vtkOpenGLRenderWindow* window, int width, int height)
{
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->SetContext(window);
  this->Allocate(window, width, height);
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Color);
  this->Framebuffer->ActivateDrawBuffer(0);
  const char* reason = nullptr;
  if (!vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_FRAMEBUFFER, reason))
  {
    state->PopFramebufferBindings();
    return false;
  }
  state->vtkglViewport(0, 0, width, height);
  state->vtkglScissor(0, 0, width, height);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  return true;
}

//------------------------------------------------------------------------------
void FloatTarget::End(vtkOpenGLRenderWindow* window)
{
  window->GetState()->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void FloatTarget::Capture(vtkImageData* image)
{
  const unsigned int size[2] = { this->Color->GetWidth(), this->Color->GetHeight() };
  vtkNew<vtkFloatArray> values;
  values->SetName("RGBA");
  values->SetNumberOfComponents(4);
  values->SetNumberOfTuples(static_cast<vtkIdType>(size[0]) * size[1]);
  vtkSmartPointer<vtkPixelBufferObject> buffer =
    vtkSmartPointer<vtkPixelBufferObject>::Take(this->Color->Download());
  unsigned int dimensions[2] = { size[0], size[1] };
  vtkIdType increments[2] = { 0, 0 };
  buffer->Download2D(VTK_FLOAT, values->GetPointer(0), dimensions, 4, increments);
  image->Initialize();
  image->SetDimensions(static_cast<int>(size[0]), static_cast<int>(size[1]), 1);
  image->GetPointData()->SetScalars(values);
}

//------------------------------------------------------------------------------
void FloatTarget::Blend(
  vtkOpenGLRenderWindow* window, const int origin[2], const int size[2], const Box& box)
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglViewport(origin[0], origin[1], size[0], size[1]);
  if (!this->Quad)
  {
    this->Quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, cpBlendFragment, nullptr);
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  vtkShaderProgram* program = this->Quad->Program;
  if (!program || !program->GetCompiled())
  {
    return;
  }
  this->Color->Activate();
  program->SetUniformi("volumeImage", this->Color->GetTextureUnit());
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(origin[0] + box[0], origin[1] + box[1], box[2], box[3]);
  this->Quad->Render();
  this->Color->Deactivate();
}

//------------------------------------------------------------------------------
void FloatTarget::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad.reset();
  this->Color->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
}
