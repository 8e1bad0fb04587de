#ifndef FramebufferAttachment_h
#define FramebufferAttachment_h

/// What is attached to the framebuffer that is bound for drawing, by OpenGL's names. Of the window
/// system's framebuffer, and of what is not attached, only the type may be asked.
namespace FramebufferAttachment
{
int Get(unsigned int attachment, unsigned int parameter);
}

#endif
