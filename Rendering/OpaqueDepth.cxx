#include "OpaqueDepth.h"

#include "FramebufferAttachment.h"
#include "PlainPixelStore.h"
#include "VTKVersions.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <vector>

namespace
{
int DepthParameter(GLenum parameter)
{
  return FramebufferAttachment::Get(GL_DEPTH_ATTACHMENT, parameter);
}

// What has no depth, or is the window system's, has no such parameter.
bool HoldsFloats()
{
  int framebuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  return framebuffer != 0 &&
         DepthParameter(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE &&
         DepthParameter(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
}

// The sized format of the multisampled depth attachment: a blit resolves between equal formats
// only.
int DepthFormat()
{
  int format = 0;
  const int name = DepthParameter(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME);
  switch (DepthParameter(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE))
  {
    case GL_TEXTURE:
      glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, static_cast<GLuint>(name));
      glGetTexLevelParameteriv(GL_TEXTURE_2D_MULTISAMPLE, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
      glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
      break;
    case GL_RENDERBUFFER:
      glBindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(name));
      glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_INTERNAL_FORMAT, &format);
      glBindRenderbuffer(GL_RENDERBUFFER, 0);
      break;
    default:
      break;
  }
  return format;
}

// A framebuffer of one sample per pixel that lives for one resolve.
class ResolveTarget
{
public:
  ResolveTarget(vtkOpenGLState* state, GLenum format, const int size[2])
  {
    glGenFramebuffers(1, &this->Framebuffer);
    glGenRenderbuffers(1, &this->Renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, this->Renderbuffer);
    glRenderbufferStorage(GL_RENDERBUFFER, format, size[0], size[1]);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Framebuffer);
    glFramebufferRenderbuffer(
      GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, this->Renderbuffer);
    state->vtkglDrawBuffer(GL_NONE);
  }
  ~ResolveTarget()
  {
    glDeleteFramebuffers(1, &this->Framebuffer);
    glDeleteRenderbuffers(1, &this->Renderbuffer);
  }
  ResolveTarget(const ResolveTarget&) = delete;
  void operator=(const ResolveTarget&) = delete;

  GLuint Framebuffer = 0;

private:
  GLuint Renderbuffer = 0;
};
}

//------------------------------------------------------------------------------
bool OpaqueDepth::Grab(vtkOpenGLRenderWindow* window, const int origin[2], const int size[2])
{
  this->Allocate(window, size);
  if (Visit(window, origin, size, [&](const int corner[2]) { this->CopyBound(corner, size); }))
  {
    return true;
  }
  std::vector<float> farthest(static_cast<size_t>(size[0]) * size[1], 1.0f);
  this->Depth->CreateDepthFromRaw(
    size[0], size[1], vtkTextureObject::Float32, VTK_FLOAT, farthest.data());
  return false;
}

//------------------------------------------------------------------------------
bool OpaqueDepth::Read(vtkOpenGLRenderWindow* window, const int origin[2], const Box& box)
{
  if (box[2] <= 0 || box[3] <= 0)
  {
    this->Pixels.Allocate({ { 0, 0, 0, 0 } }, false);
    return true;
  }
  // As the framebuffer holds them: drivers convert slowly.
  const bool areFloats = HoldsFloats();
  const int first[2] = { origin[0] + box[0], origin[1] + box[1] };
  void* values = this->Pixels.Allocate(box, areFloats);
  const PlainPixelStore plain;
  const bool isRead = Visit(window, first, &box[2],
    [&](const int corner[2])
    {
      glReadPixels(corner[0], corner[1], box[2], box[3], GL_DEPTH_COMPONENT,
        areFloats ? GL_FLOAT : GL_UNSIGNED_INT, values);
    });
  if (!isRead)
  {
    this->Pixels.Allocate({ { 0, 0, 0, 0 } }, areFloats);
  }
  return isRead;
}

//------------------------------------------------------------------------------
bool OpaqueDepth::Visit(vtkOpenGLRenderWindow* window, const int origin[2], const int size[2],
  const Reading& read)
{
  // An error that others left behind is not ours.
  glGetError();
  vtkOpenGLState* state = window->GetState();
  int framebuffer = 0, samples = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  glGetIntegerv(GL_SAMPLES, &samples);
  if (framebuffer != 0 && DepthParameter(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE)
  {
    return false;
  }
  if (framebuffer != 0 && samples > 0)
  {
    return VisitResolved(window, origin, size, read);
  }
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<unsigned int>(framebuffer));
  read(origin);
  state->PopFramebufferBindings();
  return glGetError() == GL_NO_ERROR;
}

//------------------------------------------------------------------------------
bool OpaqueDepth::VisitResolved(vtkOpenGLRenderWindow* window, const int origin[2],
  const int size[2], const Reading& read)
{
  const int format = DepthFormat();
  if (format == 0)
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  int framebuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  state->PushFramebufferBindings();
  {
    // The scissor box of the viewport would cut the blit's destination, which starts at 0, 0.
    vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
    state->vtkglDisable(GL_SCISSOR_TEST);
    ResolveTarget target(state, static_cast<GLenum>(format), size);
    state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<unsigned int>(framebuffer));
    glBlitFramebuffer(origin[0], origin[1], origin[0] + size[0], origin[1] + size[1], 0, 0, size[0],
      size[1], GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, target.Framebuffer);
    // A framebuffer without colour is complete for reading only if no colour is to be read.
    state->vtkglReadBuffer(GL_NONE);
    const int corner[2] = { 0, 0 };
    read(corner);
    state->PopFramebufferBindings();
  }
  return glGetError() == GL_NO_ERROR;
}

//------------------------------------------------------------------------------
void OpaqueDepth::CopyBound(const int origin[2], const int size[2])
{
  // VTK's own CopyFromFrameBuffer would resolve once more, into a format that may not match.
  this->Depth->Activate();
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, origin[0], origin[1], size[0], size[1]);
  this->Depth->Deactivate();
}

//------------------------------------------------------------------------------
void OpaqueDepth::Allocate(vtkOpenGLRenderWindow* window, const int size[2])
{
  this->Depth->SetContext(window);
  if (static_cast<int>(this->Depth->GetWidth()) != size[0] ||
      static_cast<int>(this->Depth->GetHeight()) != size[1])
  {
    this->Depth->AllocateDepth(size[0], size[1], vtkTextureObject::Float32);
  }
}

//------------------------------------------------------------------------------
void OpaqueDepth::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Depth->ReleaseGraphicsResources(window);
}
