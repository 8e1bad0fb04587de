#include "RayUniforms.h"

#include "ViewRays.h"
#include "vtkShaderProgram.h"

#include <glm/gtc/type_ptr.hpp>

namespace
{
void SetTriple(vtkShaderProgram* program, const char* name, const glm::vec3& a, const glm::vec3& b,
  const glm::vec3& c)
{
  const glm::vec3 values[3] = { a, b, c };
  program->SetUniform3fv(name, 3, glm::value_ptr(values[0]));
}
}

//------------------------------------------------------------------------------
void RayUniforms::Set(
  vtkShaderProgram* program, const ViewRays& rays, const std::vector<glm::vec4>& clippingPlanes)
{
  program->SetUniform2f("rayPixel", glm::value_ptr(rays.Pixel));
  SetTriple(program, "rayPoint", rays.Point, rays.PointX, rays.PointY);
  SetTriple(program, "rayDirection", rays.Direction, rays.DirectionX, rays.DirectionY);
  const glm::vec4 view[3] = { rays.View, rays.ViewX, rays.ViewY };
  program->SetUniform4fv("rayView", 3, glm::value_ptr(view[0]));
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
