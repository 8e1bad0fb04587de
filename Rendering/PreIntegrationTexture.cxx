#include "PreIntegrationTexture.h"

#include "PreIntegrationTable.h"
#include "VTKVersions.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <algorithm>

//------------------------------------------------------------------------------
bool PreIntegrationTexture::Upload(vtkOpenGLRenderWindow* window, const PreIntegrationTable& table)
{
  std::copy_n(table.Range, 2, this->Range);
  this->GreatestExtinction = table.GreatestExtinction;
  this->GreatestLength = static_cast<float>(table.GetGreatestLength());
  this->Texture->SetContext(window);
  this->Texture->SetMinificationFilter(vtkTextureObject::Linear);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapR(vtkTextureObject::ClampToEdge);
  const auto size = static_cast<unsigned int>(table.Size);
  if (vtkTextureObject::GetMaximumTextureSize3D(window) < table.Size)
  {
    return false;
  }
  // An error that others left behind is not ours.
  glGetError();
  return this->Texture->Create3DFromRaw(
           size, size, size / 4, 4, VTK_FLOAT, const_cast<float*>(table.Texels.data())) &&
         glGetError() == GL_NO_ERROR;
}

//------------------------------------------------------------------------------
void PreIntegrationTexture::Activate(vtkShaderProgram* program)
{
  this->Texture->Activate();
  program->SetUniformi("preIntegration", this->Texture->GetTextureUnit());
  const float width = this->Range[1] - this->Range[0];
  const float lookUp[4] = { this->Range[0], width > 0.0f ? 1.0f / width : 0.0f,
    this->GreatestExtinction, this->GreatestLength };
  program->SetUniform4f("tableLookUp", lookUp);
}

//------------------------------------------------------------------------------
void PreIntegrationTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
}
