#include "Framebuffer.h"

#include "VTKVersions.h"
#include "vtkOpenGLState.h"
#include "vtkPixelBufferObject.h"
#include "vtkSmartPointer.h"

#include CELLPROJECTION_OPENGL_HEADER

//------------------------------------------------------------------------------
Framebuffer::Framebuffer(vtkRenderWindow* window, const Kind& kind)
  : Window(vtkOpenGLRenderWindow::SafeDownCast(window))
  , State(this->Window->GetState())
{
  this->Window->MakeCurrent();
  this->State->PushFramebufferBindings();
  this->Object->SetContext(this->Window);
  this->IsComplete =
    this->Object->PopulateFramebuffer(Size, Size, kind.HasTextures, kind.Colors, kind.ColorType,
      kind.DepthBits > 0, kind.DepthBits, kind.Samples, kind.HasStencil);
  this->Object->Bind();
  this->Object->ActivateDrawBuffers(static_cast<unsigned int>(kind.Colors));
  this->Object->ActivateReadBuffer(0);
  this->State->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  this->State->vtkglDepthMask(GL_TRUE);
  this->State->vtkglDisable(GL_DEPTH_TEST);
}

//------------------------------------------------------------------------------
Framebuffer::~Framebuffer()
{
  this->State->PopFramebufferBindings();
  this->Object->ReleaseGraphicsResources(this->Window);
}

//------------------------------------------------------------------------------
void Framebuffer::Clear(const float (&color)[4], double depth)
{
  this->ClearPart({ 0, 0, Size, Size }, color, depth);
}

//------------------------------------------------------------------------------
void Framebuffer::ClearPart(const int (&part)[4], const float (&color)[4], double depth)
{
  this->State->vtkglEnable(GL_SCISSOR_TEST);
  this->State->vtkglScissor(part[0], part[1], part[2], part[3]);
  this->State->vtkglClearColor(color[0], color[1], color[2], color[3]);
  this->State->vtkglClearDepth(depth);
  this->State->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  this->State->vtkglDisable(GL_SCISSOR_TEST);
}

//------------------------------------------------------------------------------
std::vector<unsigned char> Framebuffer::ReadColors()
{
  std::vector<unsigned char> colors(4 * Size * Size);
  int extent[4] = { 0, Size - 1, 0, Size - 1 };
  unsigned int sizes[2] = { Size, Size };
  vtkIdType increments[2] = { 0, 0 };
  auto buffer = vtkSmartPointer<vtkPixelBufferObject>::Take(
    this->Object->DownloadColor4(extent, VTK_UNSIGNED_CHAR));
  buffer->Download2D(VTK_UNSIGNED_CHAR, colors.data(), sizes, 4, increments);
  return colors;
}
