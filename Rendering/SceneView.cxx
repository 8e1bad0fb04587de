#include "SceneView.h"

#include "CellProjectionFrame.h"
#include "MeshCoordinates.h"
#include "RayUniforms.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace
{
glm::dmat4 ToGLM(vtkMatrix4x4* matrix)
{
  // VTK stores rows, GLM columns.
  return glm::transpose(glm::make_mat4(matrix->GetData()));
}
}

//------------------------------------------------------------------------------
glm::dmat4 SceneView::GetWorldToView(const CellProjectionFrame& frame)
{
  return ToGLM(frame.Renderer->GetActiveCamera()->GetModelViewTransformMatrix());
}

//------------------------------------------------------------------------------
bool SceneView::SetRays(CellProjectionFrame& frame, const MeshCoordinates& coordinates)
{
  vtkCamera* camera = frame.Renderer->GetActiveCamera();
  const double aspect = frame.Renderer->GetTiledAspectRatio();
  ViewRays::Transforms transforms;
  transforms.DataToWorld = ToGLM(frame.Volume->GetMatrix());
  transforms.WorldToView = GetWorldToView(frame);
  transforms.ViewToClip = ToGLM(camera->GetProjectionTransformMatrix(aspect, -1, 1));
  transforms.Center = glm::make_vec3(coordinates.Center.data());
  transforms.Scale = coordinates.Scale;
  transforms.Width = frame.Size[0];
  transforms.Height = frame.Size[1];
  return frame.Rays.Build(transforms);
}

//------------------------------------------------------------------------------
void SceneView::SetClippingPlanes(CellProjectionFrame& frame, vtkPlaneCollection* planes)
{
  const glm::dmat4 viewToWorld = glm::inverse(GetWorldToView(frame));
  const int count = planes ? planes->GetNumberOfItems() : 0;
  for (int i = 0; i < std::min(count, RayUniforms::MaximumClippingPlanes); ++i)
  {
    vtkPlane* plane = planes->GetItem(i);
    const glm::dvec3 normal = glm::make_vec3(plane->GetNormal());
    const double offset = -glm::dot(normal, glm::dvec3(glm::make_vec3(plane->GetOrigin())));
    // A plane is a row vector: it is carried by the inverse of what carries points.
    frame.ClippingPlanes.emplace_back(glm::dvec4(normal, offset) * viewToWorld);
  }
}
