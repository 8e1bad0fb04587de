#ifndef RayUniforms_h
#define RayUniforms_h

struct RasterView;
class vtkShaderProgram;

/// The uniforms of cpRay.glsl and of the footprints, for a ready program; the view's opaque depth
/// is bound. At most MaximumClippingPlanes clip.
namespace RayUniforms
{
constexpr int MaximumClippingPlanes = 6;

void Set(vtkShaderProgram* program, const RasterView& view);
}

#endif
