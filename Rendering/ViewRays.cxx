#include "ViewRays.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace
{
// A ray in view coordinates: depth d is at Origin + d Direction, with Direction.z = -1.
struct ViewRay
{
  glm::dvec3 Origin;
  glm::dvec3 Direction;
};

glm::dvec3 Unproject(const glm::dmat4& clipToView, double x, double y, double z)
{
  const glm::dvec4 point = clipToView * glm::dvec4(x, y, z, 1.0);
  return glm::dvec3(point) / point.w;
}

ViewRay RayThrough(const glm::dmat4& clipToView, const glm::dvec2& clip, bool perspective)
{
  const glm::dvec3 nearPoint = Unproject(clipToView, clip.x, clip.y, -1.0);
  if (perspective)
  {
    return { glm::dvec3(0.0), nearPoint / -nearPoint.z };
  }
  const glm::dvec3 farPoint = Unproject(clipToView, clip.x, clip.y, 1.0);
  const glm::dvec3 along = farPoint - nearPoint;
  const glm::dvec3 direction = along / -along.z;
  return { nearPoint + nearPoint.z * direction, direction };
}

bool IsInvertible(const glm::dmat4& matrix)
{
  const double determinant = glm::determinant(matrix);
  return std::isfinite(determinant) && determinant != 0.0;
}
}

//------------------------------------------------------------------------------
bool ViewRays::Build(const Transforms& transforms)
{
  if (!IsInvertible(transforms.DataToWorld) || !IsInvertible(transforms.WorldToView) ||
      !IsInvertible(transforms.ViewToClip))
  {
    return false;
  }
  const glm::dmat4 clipToView = glm::inverse(transforms.ViewToClip);
  this->SetDepths(transforms, clipToView);
  this->SetRays(transforms, clipToView);
  const glm::dmat4 meshToWorld = glm::scale(
    glm::translate(transforms.DataToWorld, transforms.Center), glm::dvec3(transforms.Scale));
  this->MeshToClip = glm::mat4(transforms.ViewToClip * transforms.WorldToView * meshToWorld);
  return true;
}

//------------------------------------------------------------------------------
void ViewRays::SetDepths(const Transforms& transforms, const glm::dmat4& clipToView)
{
  this->Near = -Unproject(clipToView, 0.0, 0.0, -1.0).z;
  this->Far = -Unproject(clipToView, 0.0, 0.0, 1.0).z;
  const glm::dvec4 center =
    transforms.WorldToView * transforms.DataToWorld * glm::dvec4(transforms.Center, 1.0);
  this->Reference = std::min(std::max(-center.z, this->Near), this->Far);

  // clip z = (-p22 d + p23), clip w = (-p32 d + p33) at depth d; window z = (clip z / clip w + 1)
  // / 2.
  const glm::dmat4& p = transforms.ViewToClip;
  const double p22 = p[2][2], p23 = p[3][2], p32 = p[2][3], p33 = p[3][3];
  const glm::dvec2 numerator(p23 + p33, -2.0 * p33);
  const glm::dvec2 denominator(p22 + p32, -2.0 * p32);
  const glm::dvec2 shifted = numerator - this->Reference * denominator;
  this->DepthFromWindow = glm::vec4(shifted, denominator);
}

//------------------------------------------------------------------------------
void ViewRays::SetRays(const Transforms& transforms, const glm::dmat4& clipToView)
{
  const bool perspective = transforms.ViewToClip[2][3] != 0.0;
  const glm::dvec2 size(transforms.Width, transforms.Height);
  const glm::dvec2 middle = glm::floor(0.5 * size);
  auto rayAt = [&](const glm::dvec2& pixel)
  { return RayThrough(clipToView, 2.0 * pixel / size - 1.0, perspective); };
  const ViewRay ray = rayAt(middle);
  // Rays are linear in the pixel, so a step over the whole viewport gives the slope to full
  // precision.
  const ViewRay rayX = rayAt(middle + glm::dvec2(size.x, 0.0));
  const ViewRay rayY = rayAt(middle + glm::dvec2(0.0, size.y));

  const glm::dmat4 viewToData = glm::inverse(transforms.WorldToView * transforms.DataToWorld);
  auto pointOf = [&](const ViewRay& r) { return r.Origin + this->Reference * r.Direction; };
  auto meshPoint = [&](const ViewRay& r)
  {
    const glm::dvec3 data(viewToData * glm::dvec4(pointOf(r), 1.0));
    return (data - transforms.Center) / transforms.Scale;
  };
  auto meshDirection = [&](const ViewRay& r)
  { return glm::dvec3(viewToData * glm::dvec4(r.Direction, 0.0)) / transforms.Scale; };
  auto view = [&](const ViewRay& r)
  { return glm::dvec4(glm::dvec2(pointOf(r)), glm::dvec2(r.Direction)); };

  this->Pixel = glm::vec2(middle);
  this->Point = glm::vec3(meshPoint(ray));
  this->PointX = glm::vec3((meshPoint(rayX) - meshPoint(ray)) / size.x);
  this->PointY = glm::vec3((meshPoint(rayY) - meshPoint(ray)) / size.y);
  this->Direction = glm::vec3(meshDirection(ray));
  this->DirectionX = glm::vec3((meshDirection(rayX) - meshDirection(ray)) / size.x);
  this->DirectionY = glm::vec3((meshDirection(rayY) - meshDirection(ray)) / size.y);
  this->View = glm::vec4(view(ray));
  this->ViewX = glm::vec4((view(rayX) - view(ray)) / size.x);
  this->ViewY = glm::vec4((view(rayY) - view(ray)) / size.y);
}
