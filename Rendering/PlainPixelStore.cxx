#include "PlainPixelStore.h"

#include "VTKVersions.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <cstddef>

namespace
{
struct Setting
{
  GLenum Name;
  int Plain;
};
constexpr Setting Settings[] = { { GL_PACK_ALIGNMENT, 4 }, { GL_PACK_ROW_LENGTH, 0 },
  { GL_PACK_SKIP_ROWS, 0 }, { GL_PACK_SKIP_PIXELS, 0 }, { GL_PACK_SWAP_BYTES, 0 },
  { GL_UNPACK_ALIGNMENT, 4 }, { GL_UNPACK_ROW_LENGTH, 0 }, { GL_UNPACK_SKIP_ROWS, 0 },
  { GL_UNPACK_SKIP_PIXELS, 0 }, { GL_UNPACK_SWAP_BYTES, 0 } };

constexpr GLenum Buffers[2] = { GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER };
constexpr GLenum Bindings[2] = { GL_PIXEL_PACK_BUFFER_BINDING, GL_PIXEL_UNPACK_BUFFER_BINDING };
}

//------------------------------------------------------------------------------
PlainPixelStore::PlainPixelStore()
{
  static_assert(sizeof(Settings) / sizeof(Setting) == Count, "one place for each");
  for (std::size_t i = 0; i < Count; ++i)
  {
    glGetIntegerv(Settings[i].Name, &this->Before[i]);
    glPixelStorei(Settings[i].Name, Settings[i].Plain);
  }
  for (int i = 0; i < 2; ++i)
  {
    glGetIntegerv(Bindings[i], &this->BuffersBefore[i]);
    glBindBuffer(Buffers[i], 0);
  }
}

//------------------------------------------------------------------------------
PlainPixelStore::~PlainPixelStore()
{
  for (std::size_t i = 0; i < Count; ++i)
  {
    glPixelStorei(Settings[i].Name, this->Before[i]);
  }
  for (int i = 0; i < 2; ++i)
  {
    glBindBuffer(Buffers[i], static_cast<GLuint>(this->BuffersBefore[i]));
  }
}
