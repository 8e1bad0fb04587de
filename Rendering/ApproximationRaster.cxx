#include "ApproximationRaster.h"

#include "ApproximationTriangles.h"
#include "RasterView.h"
#include "RayUniforms.h"
#include "VTKVersions.h"
#include "cpApproximationFragment.h"
#include "cpApproximationVertex.h"
#include "cpExponentialOpacity.h"
#include "cpLinearOpacity.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <cstddef>

namespace
{
vtkShaderProgram* ReadyProgram(
  vtkOpenGLRenderWindow* window, const RasterView& view, bool isExponential)
{
  std::string fragment = RayUniforms::WithRay(cpApproximationFragment, view);
  vtkShaderProgram::Substitute(
    fragment, "//VTK::Opacity::Dec", isExponential ? cpExponentialOpacity : cpLinearOpacity);
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(cpApproximationVertex, fragment.c_str(), "");
  return program && program->GetCompiled() ? program : nullptr;
}
}

//------------------------------------------------------------------------------
bool ApproximationRaster::Upload(const ApproximationTriangles& triangles)
{
  const bool good =
    this->Vertices->Upload(triangles.Vertices, vtkOpenGLBufferObject::ArrayBuffer) &&
    this->Indices->Upload(triangles.Indices, vtkOpenGLBufferObject::ElementArrayBuffer);
  if (!good)
  {
    this->Failure = "the driver has no room for their triangles";
  }
  return good;
}

//------------------------------------------------------------------------------
bool ApproximationRaster::BindVertices(vtkShaderProgram* program)
{
  using Vertex = ApproximationTriangles::Vertex;
  this->VertexArray->ShaderProgramChanged();
  this->VertexArray->Bind();
  const bool good = this->VertexArray->AddAttributeArray(program, this->Vertices, "place",
                      offsetof(Vertex, Screen), sizeof(Vertex), VTK_FLOAT, 4, false) &&
                    this->VertexArray->AddAttributeArray(program, this->Vertices, "value",
                      offsetof(Vertex, Value), sizeof(Vertex), VTK_FLOAT, 4, false);
  if (!good)
  {
    this->Failure = "the driver does not take their vertices";
  }
  return good;
}

//------------------------------------------------------------------------------
bool ApproximationRaster::Draw(vtkOpenGLRenderWindow* window, const RasterView& view,
  const ApproximationTriangles& triangles, bool isExponential)
{
  if (triangles.Indices.empty())
  {
    return true;
  }
  vtkShaderProgram* program = ReadyProgram(window, view, isExponential);
  if (!program)
  {
    this->Failure = "the projection's shaders did not compile";
    return false;
  }
  if (!this->Upload(triangles) || !this->BindVertices(program))
  {
    return false;
  }
  view.OpaqueDepth->Activate();
  RayUniforms::Set(program, view);
  this->Indices->Bind();
  glDrawElements(
    GL_TRIANGLES, static_cast<int>(triangles.Indices.size()), GL_UNSIGNED_INT, nullptr);
  this->Indices->Release();
  this->VertexArray->Release();
  view.OpaqueDepth->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
void ApproximationRaster::ReleaseGraphicsResources()
{
  this->Vertices->ReleaseGraphicsResources();
  this->Indices->ReleaseGraphicsResources();
  this->VertexArray->ReleaseGraphicsResources();
}
