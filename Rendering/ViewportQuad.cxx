#include "ViewportQuad.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

ViewportQuad::ViewportQuad() = default;
ViewportQuad::~ViewportQuad() = default;

//------------------------------------------------------------------------------
vtkShaderProgram* ViewportQuad::Ready(vtkOpenGLRenderWindow* window, const std::string& fragment)
{
  if (!this->Quad || this->Source != fragment)
  {
    this->Quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, fragment.c_str(), nullptr);
    this->Source = fragment;
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  vtkShaderProgram* program = this->Quad->Program;
  return program && program->GetCompiled() ? program : nullptr;
}

//------------------------------------------------------------------------------
void ViewportQuad::Draw()
{
  this->Quad->Render();
}

//------------------------------------------------------------------------------
void ViewportQuad::ReleaseGraphicsResources()
{
  this->Quad.reset();
}
