#include "FramebufferAttachment.h"

#include "VTKVersions.h"

#include CELLPROJECTION_OPENGL_HEADER

//------------------------------------------------------------------------------
int FramebufferAttachment::Get(unsigned int attachment, unsigned int parameter)
{
  int value = 0;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, parameter, &value);
  return value;
}
