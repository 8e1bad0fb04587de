#include "RayUniforms.h"

#include "RasterView.h"
#include "ViewRays.h"
#include "cpRay.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <glm/gtc/type_ptr.hpp>

//------------------------------------------------------------------------------
std::string RayUniforms::WithRay(const std::string& fragment, const RasterView& view)
{
  std::string source = fragment;
  vtkShaderProgram::Substitute(source, "//VTK::Ray::Dec", cpRay);
  vtkShaderProgram::Substitute(source, "//VTK::OpaqueDepth::Impl",
    view.OpaqueDepth ? "stopAtOpaque(ray.limits);" : "");
  vtkShaderProgram::Substitute(source, "//VTK::ClipRay::Impl",
    view.ClippingPlanes->empty() ? "" : "clipRay(view, ray.limits);");
  return source;
}

//------------------------------------------------------------------------------
void RayUniforms::Set(vtkShaderProgram* program, const RasterView& view)
{
  const ViewRays& rays = *view.Rays;
  const std::vector<glm::vec4>& clippingPlanes = *view.ClippingPlanes;
  const float size[2] = { static_cast<float>(view.Width), static_cast<float>(view.Height) };
  program->SetUniform2f("viewportSize", size);
  glm::mat4 meshToClip = rays.MeshToClip;
  program->SetUniformMatrix4x4("meshToClip", glm::value_ptr(meshToClip));
  if (view.OpaqueDepth)
  {
    program->SetUniformi("opaqueDepth", view.OpaqueDepth->GetTextureUnit());
  }
  program->SetUniform2f("rayPixel", glm::value_ptr(rays.Pixel));
  program->SetUniform3fv("rayPoint", 3, glm::value_ptr(rays.Point[0]));
  program->SetUniform3fv("rayDirection", 3, glm::value_ptr(rays.Direction[0]));
  program->SetUniform3fv("rayWorld", 3, glm::value_ptr(rays.World[0]));
  program->SetUniform4fv("rayView", 3, glm::value_ptr(rays.View[0]));
  const glm::vec3 depths(rays.Reference, rays.Near - rays.Reference, rays.Far - rays.Reference);
  program->SetUniform3f("rayDepths", glm::value_ptr(depths));
  program->SetUniform4f("depthFromWindow", glm::value_ptr(rays.DepthFromWindow));
  const int planes = static_cast<int>(clippingPlanes.size());
  program->SetUniformi("numberOfClippingPlanes", planes);
  if (planes > 0)
  {
    program->SetUniform4fv("clippingPlanes", planes, glm::value_ptr(clippingPlanes[0]));
  }
}
