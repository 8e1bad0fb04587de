#include "IsoTriangleRaster.h"

#include "FrameStatistics.h"
#include "IsoTriangles.h"
#include "NumberedTriangles.h"
#include "RayUniforms.h"
#include "ShadingBuffers.h"
#include "VTKVersions.h"
#include "ViewRays.h"
#include "cpIsoPoint.h"
#include "cpIsoTriangleFragment.h"
#include "cpIsoTriangleGradient.h"
#include "cpIsoTriangleVertex.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace
{
std::string VertexSource(bool isLit)
{
  std::string source = cpIsoTriangleVertex;
  vtkShaderProgram::Substitute(
    source, "//VTK::Gradient::Dec", isLit ? cpIsoTriangleGradient : "");
  vtkShaderProgram::Substitute(
    source, "//VTK::Gradient::Impl", isLit ? "takeGradient(ids.z);" : "");
  return source;
}

std::string FragmentSource(const ShadingBuffers& shading)
{
  const bool isLit = shading.IsLit();
  std::string source = cpIsoTriangleFragment;
  vtkShaderProgram::Substitute(
    source, "//VTK::Gradient::Dec", isLit ? "in vec3 gradientVSOutput;" : "");
  vtkShaderProgram::Substitute(source, "//VTK::IsoPoint::Dec", isLit ? cpIsoPoint : "");
  vtkShaderProgram::Substitute(
    source, "//VTK::IsoPoint::Impl", isLit ? "beginIsoPoint(gradientVSOutput, depth);" : "");
  vtkShaderProgram::Substitute(source, "//VTK::Lighting::Dec", shading.GetPointLightSource());
  return source;
}
}

//------------------------------------------------------------------------------
bool IsoTriangleRaster::Send(vtkOpenGLRenderWindow* window, TextureBuffer& buffer,
  const std::vector<float>& values, vtkTimeStamp& uploaded)
{
  if (!buffer.Upload(window, values, 4))
  {
    this->Failure = buffer.GetFailure();
    return false;
  }
  uploaded.Modified();
  this->UploadedBytes += sizeof(float) * values.size();
  return true;
}

//------------------------------------------------------------------------------
bool IsoTriangleRaster::SendTriangles(
  vtkOpenGLRenderWindow* window, const IsoTriangles& triangles)
{
  const NumberedTriangles numbered(triangles.Triangles, triangles.Vertices.size() / 4);
  this->VertexArray.Bind();
  const bool isSent =
    this->Indices->Upload(numbered.Indices, vtkOpenGLBufferObject::ElementArrayBuffer);
  EmptyVertexArray::Release();
  if (!isSent || !this->Corners.Upload(window, numbered.Corners, 4))
  {
    this->Failure = isSent ? this->Corners.GetFailure() : "the driver refused the triangles";
    return false;
  }
  this->TrianglesUploaded.Modified();
  this->TriangleBytes = sizeof(int) * (numbered.Indices.size() + numbered.Corners.size());
  this->UploadedBytes += this->TriangleBytes;
  return true;
}

//------------------------------------------------------------------------------
bool IsoTriangleRaster::Upload(vtkOpenGLRenderWindow* window, const Source& source, bool isLit)
{
  FrameStatistics::Timer timer(this->UploadSeconds);
  const IsoTriangles& triangles = *source.Triangles;
  if (this->TrianglesUploaded < source.CutTime && !this->SendTriangles(window, triangles))
  {
    return false;
  }
  this->NumberOfBytes = this->TriangleBytes +
    sizeof(float) * (triangles.Vertices.size() + (isLit ? triangles.Gradients.size() : 0));
  return (this->VerticesUploaded > source.VerticesTime ||
           this->Send(window, this->Vertices, triangles.Vertices, this->VerticesUploaded)) &&
         (!isLit || this->GradientsUploaded > source.GradientsTime ||
           this->Send(window, this->Gradients, triangles.Gradients, this->GradientsUploaded));
}

//------------------------------------------------------------------------------
bool IsoTriangleRaster::Prepare(vtkOpenGLRenderWindow* window, const RasterView& view,
  const Source& source, const ShadingBuffers& shading)
{
  const bool isLit = shading.IsLit();
  // The driver has no buffer of nothing.
  this->UploadedBytes = this->NumberOfBytes = 0;
  this->UploadSeconds = 0.0;
  if (!source.Triangles->Triangles.empty() && !this->Upload(window, source, isLit))
  {
    return false;
  }
  const std::string fragment = RayUniforms::WithRay(FragmentSource(shading), view);
  this->Program = window->GetShaderCache()->ReadyShaderProgram(
    VertexSource(isLit).c_str(), fragment.c_str(), "");
  if (!this->Program || !this->Program->GetCompiled())
  {
    this->Failure = "the iso-surfaces' shaders did not compile";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void IsoTriangleRaster::Draw(vtkOpenGLRenderWindow* window, const RasterView& view,
  const Source& source, ShadingBuffers& shading, const glm::vec4& fragmentDepth)
{
  if (source.Triangles->Triangles.empty())
  {
    return;
  }
  window->GetShaderCache()->ReadyShaderProgram(this->Program);
  RayUniforms::Set(this->Program, view);
  this->Vertices.Activate(this->Program, "trianglePoints");
  this->Corners.Activate(this->Program, "triangleCorners");
  if (shading.IsLit())
  {
    this->Gradients.Activate(this->Program, "triangleGradients");
    shading.ActivatePointLights(this->Program);
  }
  glm::dvec4 meshToDepth = -glm::row(view.Rays->MeshToView, 2);
  meshToDepth.w -= view.Rays->Reference;
  const glm::vec4 rounded(meshToDepth);
  this->Program->SetUniform4f("meshToDepth", glm::value_ptr(rounded));
  this->Program->SetUniform4f("fragmentDepth", glm::value_ptr(fragmentDepth));
  this->VertexArray.Bind();
  this->Indices->Bind();
  for (size_t i = 0; i < source.Triangles->Surfaces.size(); ++i)
  {
    const IsoTriangles::Surface& surface = source.Triangles->Surfaces[i];
    this->Program->SetUniform3f("isoColour", glm::value_ptr(source.Colors[i]));
    const size_t count = surface.EndTriangle - surface.FirstTriangle;
    glDrawElements(GL_TRIANGLES, static_cast<int>(3 * count), GL_UNSIGNED_INT,
      reinterpret_cast<const void*>(3 * sizeof(int) * surface.FirstTriangle));
  }
  EmptyVertexArray::Release();
  this->Indices->Release();
  this->Corners.Deactivate();
  this->Vertices.Deactivate();
  if (shading.IsLit())
  {
    this->Gradients.Deactivate();
  }
}

//------------------------------------------------------------------------------
void IsoTriangleRaster::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Vertices.ReleaseGraphicsResources(window);
  this->Gradients.ReleaseGraphicsResources(window);
  this->Corners.ReleaseGraphicsResources(window);
  this->Indices->ReleaseGraphicsResources();
  this->VerticesUploaded = this->GradientsUploaded = this->TrianglesUploaded = vtkTimeStamp();
  this->VertexArray.ReleaseGraphicsResources();
  this->Program = nullptr;
}
