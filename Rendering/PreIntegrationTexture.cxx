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
  this->IsLit = table.IsLit();
  return vtkTextureObject::GetMaximumTextureSize3D(window) >= table.Size &&
         this->Upload(window, this->Texture, table.Texels, table.Size) &&
         (!this->IsLit || (this->Upload(window, this->Front, table.Front, table.Size) &&
                            this->Upload(window, this->Back, table.Back, table.Size)));
}

//------------------------------------------------------------------------------
bool PreIntegrationTexture::Upload(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
  const std::vector<float>& texels, int tableSize)
{
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  const auto size = static_cast<unsigned int>(tableSize);
  // An error that others left behind is not ours.
  glGetError();
  return texture->Create3DFromRaw(
           size, size, size / 4, 4, VTK_FLOAT, const_cast<float*>(texels.data())) &&
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
  if (this->IsLit)
  {
    this->Front->Activate();
    this->Back->Activate();
    program->SetUniformi("preIntegrationFront", this->Front->GetTextureUnit());
    program->SetUniformi("preIntegrationBack", this->Back->GetTextureUnit());
  }
}

//------------------------------------------------------------------------------
void PreIntegrationTexture::Deactivate()
{
  this->Texture->Deactivate();
  if (this->IsLit)
  {
    this->Front->Deactivate();
    this->Back->Deactivate();
  }
}

//------------------------------------------------------------------------------
void PreIntegrationTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Front->ReleaseGraphicsResources(window);
  this->Back->ReleaseGraphicsResources(window);
}
