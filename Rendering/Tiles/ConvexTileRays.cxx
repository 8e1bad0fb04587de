#include "ConvexTileRays.h"

#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

namespace
{
glm::dvec3 Unproject(const glm::dmat4& clipToView, double x, double y, double z)
{
  const glm::dvec4 point = clipToView * glm::dvec4(x, y, z, 1.0);
  return glm::dvec3(point) / point.w;
}
}

//------------------------------------------------------------------------------
void ConvexTileRays::Build(const TileView::Camera& camera)
{
  const glm::dmat4 clipToView = glm::inverse(camera.ViewToClip);
  const glm::dmat4 viewToMesh = glm::inverse(camera.MeshToView);
  this->Reference = -camera.MeshToView[3].z;
  this->Near = -Unproject(clipToView, 0.0, 0.0, -1.0).z - this->Reference;
  this->Far = -Unproject(clipToView, 0.0, 0.0, 1.0).z - this->Reference;
  // Linear in the pixel: a step over the whole viewport gives the slope to full precision.
  const double steps[3][2] = { { 0.0, 0.0 }, { double(camera.Width), 0.0 },
    { 0.0, double(camera.Height) } };
  for (int i = 0; i < 3; ++i)
  {
    const double x = 2.0 * (steps[i][0] + 0.5) / camera.Width - 1.0;
    const double y = 2.0 * (steps[i][1] + 0.5) / camera.Height - 1.0;
    const glm::dvec3 nearPoint = Unproject(clipToView, x, y, -1.0);
    const glm::dvec3 along = Unproject(clipToView, x, y, 1.0) - nearPoint;
    const glm::dvec3 direction = along / -along.z;
    const glm::dvec3 point = nearPoint + (this->Reference + nearPoint.z) * direction;
    this->Point[i] = glm::dvec3(viewToMesh * glm::dvec4(point, 1.0));
    this->Direction[i] = glm::dvec3(viewToMesh * glm::dvec4(direction, 0.0));
  }
  const double size[2] = { double(camera.Width), double(camera.Height) };
  for (int i = 1; i < 3; ++i)
  {
    this->Point[i] = (this->Point[i] - this->Point[0]) / size[i - 1];
    this->Direction[i] = (this->Direction[i] - this->Direction[0]) / size[i - 1];
  }
}
