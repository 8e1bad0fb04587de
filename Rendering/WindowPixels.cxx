#include "WindowPixels.h"

#include "FramebufferAttachment.h"
#include "PixelBlending.h"
#include "PlainPixelStore.h"
#include "VTKVersions.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkSMPTools.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace
{
int Get(GLenum name)
{
  int value = 0;
  glGetIntegerv(name, &value);
  return value;
}

// The only attachment that is drawn to; GL_NONE where there are more, or none.
GLenum FindDrawBuffer()
{
  const int last = Get(GL_MAX_DRAW_BUFFERS) - 1;
  for (int i = 1; i <= last; ++i)
  {
    if (Get(GL_DRAW_BUFFER0 + static_cast<GLenum>(i)) != GL_NONE)
    {
      return GL_NONE;
    }
  }
  return static_cast<GLenum>(Get(GL_DRAW_BUFFER0));
}

bool IsPlainTexture(GLenum attachment)
{
  const struct
  {
    GLenum Name;
    int Value;
  } expected[] = { { GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, GL_TEXTURE },
    { GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL, 0 }, { GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER, 0 },
    { GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, 8 }, { GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE, 8 },
    { GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE, 8 }, { GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE, 8 },
    { GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, GL_UNSIGNED_NORMALIZED },
    { GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING, GL_LINEAR } };
  return std::all_of(std::begin(expected), std::end(expected), [attachment](const auto& each)
    { return FramebufferAttachment::Get(attachment, each.Name) == each.Value; });
}

// Binds a texture as long as it lives.
class BoundTexture
{
public:
  explicit BoundTexture(GLuint texture)
    : Before(Get(GL_TEXTURE_BINDING_2D))
  {
    glBindTexture(GL_TEXTURE_2D, texture);
  }
  ~BoundTexture() { glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(this->Before)); }
  BoundTexture(const BoundTexture&) = delete;
  void operator=(const BoundTexture&) = delete;

private:
  const int Before;
};

// Whether a texture has all pixels of a box; one of another kind cannot be bound.
bool HasPixels(GLuint texture, const std::array<int, 2>& corner, const WindowPixels::Box& box)
{
  const BoundTexture bound(texture);
  int size[2] = { 0, 0 };
  glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &size[0]);
  glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &size[1]);
  return glGetError() == GL_NO_ERROR && corner[0] >= 0 && corner[1] >= 0 &&
         corner[0] + box[2] <= size[0] && corner[1] + box[3] <= size[1];
}

// Whether every fragment is written as it is.
bool IsUnmasked()
{
  GLboolean mask[4] = {};
  glGetBooleanv(GL_COLOR_WRITEMASK, mask);
  return std::all_of(std::begin(mask), std::end(mask), [](GLboolean on) { return on == GL_TRUE; }) &&
         !glIsEnabled(GL_STENCIL_TEST) && !glIsEnabled(GL_COLOR_LOGIC_OP);
}
}

//------------------------------------------------------------------------------
bool WindowPixels::Read(vtkOpenGLRenderWindow* window, const int origin[2], const Box& box)
{
  this->Texture = 0;
  // An error that others left behind is not ours.
  glGetError();
  const int framebuffer = Get(GL_DRAW_FRAMEBUFFER_BINDING);
  const GLenum attachment = framebuffer == 0 ? GL_NONE : FindDrawBuffer();
  if (attachment == GL_NONE || Get(GL_SAMPLES) > 0 || !IsUnmasked() || !IsPlainTexture(attachment))
  {
    return false;
  }
  this->Corner = { { origin[0] + box[0], origin[1] + box[1] } };
  this->Part = box;
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<unsigned int>(framebuffer));
  const auto texture = static_cast<GLuint>(
    FramebufferAttachment::Get(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
  if (static_cast<GLenum>(Get(GL_READ_BUFFER)) == attachment &&
    HasPixels(texture, this->Corner, box))
  {
    this->ReadColors();
    this->Texture = glGetError() == GL_NO_ERROR ? texture : 0;
  }
  state->PopFramebufferBindings();
  return this->Texture != 0;
}

//------------------------------------------------------------------------------
void WindowPixels::ReadColors()
{
  this->Colors.resize(4 * static_cast<std::size_t>(this->Part[2]) * this->Part[3]);
  const PlainPixelStore plain;
  glReadPixels(this->Corner[0], this->Corner[1], this->Part[2], this->Part[3], GL_RGBA,
    GL_UNSIGNED_BYTE, this->Colors.data());
}

//------------------------------------------------------------------------------
bool WindowPixels::LayOver(const float* image, int width)
{
  if (this->Texture == 0)
  {
    return false;
  }
  this->Blend(image, width);
  glGetError();
  const BoundTexture bound(this->Texture);
  const PlainPixelStore plain;
  glTexSubImage2D(GL_TEXTURE_2D, 0, this->Corner[0], this->Corner[1], this->Part[2], this->Part[3],
    GL_RGBA, GL_UNSIGNED_BYTE, this->Colors.data());
  this->Texture = 0;
  return glGetError() == GL_NO_ERROR;
}

//------------------------------------------------------------------------------
void WindowPixels::Blend(const float* image, int width)
{
  const Box& box = this->Part;
  vtkSMPTools::For(0, box[3], 64,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType y = begin; y < end; ++y)
      {
        const auto first = static_cast<std::size_t>(box[1] + y) * width + box[0];
        PixelBlending::LayOver(
          image + 4 * first, box[2], this->Colors.data() + 4 * static_cast<std::size_t>(y) * box[2]);
      }
    });
}
