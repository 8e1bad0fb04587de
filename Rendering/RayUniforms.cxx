#include "RayUniforms.h"

#include "ViewRays.h"
#include "vtkShaderProgram.h"

#include <glm/gtc/type_ptr.hpp>

//------------------------------------------------------------------------------
void RayUniforms::Set(
  vtkShaderProgram* program, const ViewRays& rays, const std::vector<glm::vec4>& clippingPlanes)
{
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
