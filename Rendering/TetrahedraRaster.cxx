#include "TetrahedraRaster.h"

#include "RayUniforms.h"
#include "TransferFunction.h"
#include "VTKVersions.h"
#include "ViewRays.h"
#include "cpFootprint.h"
#include "cpHull.h"
#include "cpIntegral.h"
#include "cpNearClip.h"
#include "cpRay.h"
#include "cpSegment.h"
#include "cpTetrahedraFragment.h"
#include "cpTetrahedraGeometry.h"
#include "cpTetrahedraVertex.h"
#include "cpTetrahedronClip.h"
#include "cpTransferFunction.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <glm/gtc/type_ptr.hpp>

namespace
{
std::string GeometrySource()
{
  std::string source = cpTetrahedraGeometry;
  vtkShaderProgram::Substitute(source, "//VTK::Footprint::Dec", cpFootprint);
  vtkShaderProgram::Substitute(source, "//VTK::NearClip::Dec", cpNearClip);
  vtkShaderProgram::Substitute(source, "//VTK::Hull::Dec", cpHull);
  return source;
}

std::string FragmentSource()
{
  std::string source = cpTetrahedraFragment;
  vtkShaderProgram::Substitute(source, "//VTK::Ray::Dec", cpRay);
  vtkShaderProgram::Substitute(source, "//VTK::Clip::Dec", cpTetrahedronClip);
  vtkShaderProgram::Substitute(source, "//VTK::TransferFunction::Dec", cpTransferFunction);
  vtkShaderProgram::Substitute(source, "//VTK::Integral::Dec", cpIntegral);
  vtkShaderProgram::Substitute(source, "//VTK::Segment::Dec", cpSegment);
  return source;
}
}

//------------------------------------------------------------------------------
bool TetrahedraRaster::Check(const TextureBuffer& buffer, bool uploaded)
{
  if (!uploaded)
  {
    this->Failure = buffer.GetFailure();
  }
  return uploaded;
}

//------------------------------------------------------------------------------
bool TetrahedraRaster::UploadPoints(vtkOpenGLRenderWindow* window, const std::vector<float>& points)
{
  return this->Check(this->Points, this->Points.Upload(window, points, 4));
}

//------------------------------------------------------------------------------
bool TetrahedraRaster::UploadCorners(vtkOpenGLRenderWindow* window, const std::vector<int>& corners)
{
  return this->Check(this->Corners, this->Corners.Upload(window, corners, 4));
}

//------------------------------------------------------------------------------
bool TetrahedraRaster::UploadPlanes(vtkOpenGLRenderWindow* window, const std::vector<float>& planes)
{
  return this->Check(this->Planes, this->Planes.Upload(window, planes, 4));
}

//------------------------------------------------------------------------------
bool TetrahedraRaster::UploadScalars(
  vtkOpenGLRenderWindow* window, const std::vector<float>& scalars)
{
  return this->Check(this->Scalars, this->Scalars.Upload(window, scalars, 4));
}

//------------------------------------------------------------------------------
bool TetrahedraRaster::UploadTransferFunction(
  vtkOpenGLRenderWindow* window, const TransferFunction& function)
{
  this->NumberOfNodes = function.GetNumberOfNodes();
  return this->Check(
           this->NodePositions, this->NodePositions.Upload(window, function.GetPositions(), 1)) &&
         this->Check(this->NodeValues, this->NodeValues.Upload(window, function.GetValues(), 4));
}

//------------------------------------------------------------------------------
bool TetrahedraRaster::UploadOrder(const std::vector<unsigned int>& order)
{
  this->NumberOfDrawnCells = static_cast<int>(order.size());
  return order.empty() || this->Order->Upload(order, vtkOpenGLBufferObject::ElementArrayBuffer);
}

//------------------------------------------------------------------------------
vtkShaderProgram* TetrahedraRaster::ReadyProgram(vtkOpenGLRenderWindow* window)
{
  // VTK's cache finds the compiled program by its source again: nothing to keep here.
  static const std::string geometry = GeometrySource();
  static const std::string fragment = FragmentSource();
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    cpTetrahedraVertex, fragment.c_str(), geometry.c_str());
  return program && program->GetCompiled() ? program : nullptr;
}

//------------------------------------------------------------------------------
void TetrahedraRaster::SetUniforms(vtkShaderProgram* program, const View& view)
{
  RayUniforms::Set(program, *view.Rays, *view.ClippingPlanes);
  const float size[2] = { static_cast<float>(view.Width), static_cast<float>(view.Height) };
  program->SetUniform2f("viewportSize", size);
  glm::mat4 meshToClip = view.Rays->MeshToClip;
  program->SetUniformMatrix4x4("meshToClip", glm::value_ptr(meshToClip));
  program->SetUniformi("numberOfNodes", this->NumberOfNodes);
  program->SetUniformi("opaqueDepth", view.OpaqueDepth->GetTextureUnit());
}

//------------------------------------------------------------------------------
bool TetrahedraRaster::Draw(vtkOpenGLRenderWindow* window, const View& view)
{
  if (this->NumberOfDrawnCells == 0)
  {
    return true;
  }
  vtkShaderProgram* program = this->ReadyProgram(window);
  if (!program)
  {
    this->Failure = "the projection's shaders did not compile";
    return false;
  }
  view.OpaqueDepth->Activate();
  for (const NamedBuffer& named : this->GetBuffers())
  {
    named.Buffer->Activate(program, named.Sampler);
  }
  this->SetUniforms(program, view);
  this->DrawCells();
  for (const NamedBuffer& named : this->GetBuffers())
  {
    named.Buffer->Deactivate();
  }
  view.OpaqueDepth->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
std::array<TetrahedraRaster::NamedBuffer, 6> TetrahedraRaster::GetBuffers()
{
  return { { { &this->Points, "points" }, { &this->Corners, "cornerIds" },
    { &this->Planes, "cellPlanes" }, { &this->Scalars, "cellScalars" },
    { &this->NodePositions, "nodePositions" }, { &this->NodeValues, "nodeValues" } } };
}

//------------------------------------------------------------------------------
void TetrahedraRaster::DrawCells()
{
  // A core profile draws from a vertex array object only, though ours has no attributes.
  if (this->VertexArray == 0)
  {
    glGenVertexArrays(1, &this->VertexArray);
  }
  glBindVertexArray(this->VertexArray);
  this->Order->Bind();
  glDrawElements(GL_POINTS, this->NumberOfDrawnCells, GL_UNSIGNED_INT, nullptr);
  this->Order->Release();
  glBindVertexArray(0);
}

//------------------------------------------------------------------------------
void TetrahedraRaster::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const NamedBuffer& named : this->GetBuffers())
  {
    named.Buffer->ReleaseGraphicsResources(window);
  }
  this->Order->ReleaseGraphicsResources();
  if (this->VertexArray != 0)
  {
    glDeleteVertexArrays(1, &this->VertexArray);
    this->VertexArray = 0;
  }
}
