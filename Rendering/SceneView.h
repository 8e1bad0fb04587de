#ifndef SceneView_h
#define SceneView_h

#include <glm/mat4x4.hpp>

class MeshCoordinates;
class vtkPlaneCollection;
struct CellProjectionFrame;

/// Takes rays and clipping planes from VTK's camera, volume and planes.
namespace SceneView
{
glm::dmat4 GetWorldToView(const CellProjectionFrame& frame);

/// False where a matrix cannot be inverted.
bool SetRays(CellProjectionFrame& frame, const MeshCoordinates& coordinates);

/// The first RayUniforms::MaximumClippingPlanes; `planes`, in world coordinates, may be null.
void SetClippingPlanes(CellProjectionFrame& frame, vtkPlaneCollection* planes);
}

#endif
