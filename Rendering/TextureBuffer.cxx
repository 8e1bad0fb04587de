#include "TextureBuffer.h"

#include "VTKVersions.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include CELLPROJECTION_OPENGL_HEADER

//------------------------------------------------------------------------------
bool TextureBuffer::Fits(size_t texels)
{
  int limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
  if (texels <= static_cast<size_t>(limit))
  {
    return true;
  }
  this->Failure = std::to_string(texels) + " texels exceed the driver's texture buffer limit of " +
                  std::to_string(limit);
  return false;
}

//------------------------------------------------------------------------------
bool TextureBuffer::Create(
  vtkOpenGLRenderWindow* window, size_t texels, int components, int type, int format)
{
  this->Texture->SetContext(window);
  // Without it VTK would choose a format that normalises integers.
  this->Texture->SetInternalFormat(static_cast<unsigned int>(format));
  if (this->Texture->CreateTextureBuffer(
        static_cast<unsigned int>(texels), components, type, this->Buffer))
  {
    return true;
  }
  this->Failure = "the driver refused a texture buffer of " + std::to_string(texels) + " texels";
  return false;
}

//------------------------------------------------------------------------------
bool TextureBuffer::Upload(
  vtkOpenGLRenderWindow* window, const float* values, size_t count, int components)
{
  const size_t texels = count / components;
  return this->Fits(texels) &&
         this->Buffer->Upload(values, count, vtkOpenGLBufferObject::TextureBuffer) &&
         this->Create(
           window, texels, components, VTK_FLOAT, components == 1 ? GL_R32F : GL_RGBA32F);
}

//------------------------------------------------------------------------------
bool TextureBuffer::Upload(
  vtkOpenGLRenderWindow* window, const int* values, size_t count, int components)
{
  const size_t texels = count / components;
  return this->Fits(texels) &&
         this->Buffer->Upload(values, count, vtkOpenGLBufferObject::TextureBuffer) &&
         this->Create(window, texels, components, VTK_INT, components == 1 ? GL_R32I : GL_RGBA32I);
}

//------------------------------------------------------------------------------
void TextureBuffer::Activate(vtkShaderProgram* program, const char* name)
{
  this->Texture->Activate();
  program->SetUniformi(name, this->Texture->GetTextureUnit());
}

//------------------------------------------------------------------------------
void TextureBuffer::Deactivate()
{
  this->Texture->Deactivate();
}

//------------------------------------------------------------------------------
void TextureBuffer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Buffer->ReleaseGraphicsResources();
}
