#ifndef RayUniforms_h
#define RayUniforms_h

#include <glm/vec4.hpp>

#include <vector>

class ViewRays;
class vtkShaderProgram;

/// The uniforms of cpRay.glsl but the depth texture. `clippingPlanes`: normal and offset in view
/// coordinates, MaximumClippingPlanes at most, the positive side stays.
namespace RayUniforms
{
constexpr int MaximumClippingPlanes = 6;

void Set(
  vtkShaderProgram* program, const ViewRays& rays, const std::vector<glm::vec4>& clippingPlanes);
}

#endif
