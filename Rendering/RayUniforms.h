#ifndef RayUniforms_h
#define RayUniforms_h

#include <string>

struct RasterView;
class vtkShaderProgram;

/// The ray of a fragment in a program, and its uniforms.
namespace RayUniforms
{
/// More do not clip.
constexpr int MaximumClippingPlanes = 6;

/// `fragment` with cpRay.glsl in the place of its tag. Without clipping planes the code that clips
/// is left out: it would cost a fragment a sixth of its time to find that there are none. Without
/// an opaque depth rays end at the far plane.
std::string WithRay(const std::string& fragment, const RasterView& view);

/// Also what the footprints need, for a ready program; the view's opaque depth, if any, is bound.
void Set(vtkShaderProgram* program, const RasterView& view);
}

#endif
