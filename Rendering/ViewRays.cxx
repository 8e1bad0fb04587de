#include "ViewRays.h"

#include "CameraMatrices.h"

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

ViewRay RayThrough(const glm::dmat4& clipToView, const glm::dvec2& clip)
{
  const glm::dvec3 nearPoint = Unproject(clipToView, clip.x, clip.y, -1.0);
  // Where all rays meet; stereo and shear move it away from the view's origin.
  const glm::dvec4 eye = clipToView * glm::dvec4(0.0, 0.0, 1.0, 0.0);
  if (eye.w != 0.0)
  {
    const glm::dvec3 origin = glm::dvec3(eye) / eye.w;
    const glm::dvec3 along = nearPoint - origin;
    const glm::dvec3 direction = along / -along.z;
    return { origin + origin.z * direction, direction };
  }
  const glm::dvec3 farPoint = Unproject(clipToView, clip.x, clip.y, 1.0);
  const glm::dvec3 along = farPoint - nearPoint;
  const glm::dvec3 direction = along / -along.z;
  return { nearPoint + nearPoint.z * direction, direction };
}

// What the shaders need of the ray through one pixel.
struct RayAt
{
  glm::dvec3 Point;
  glm::dvec3 Direction;
  glm::dvec3 World;
  glm::dvec4 View;
};

template <class Single, class Double>
void SetLinear(Single (&linear)[3], const Double& here, const Double& right, const Double& above,
  const glm::dvec2& size)
{
  linear[0] = Single(here);
  linear[1] = Single((right - here) / size.x);
  linear[2] = Single((above - here) / size.y);
}
}

//------------------------------------------------------------------------------
bool ViewRays::Build(const Transforms& transforms)
{
  if (!CameraMatrices::IsInvertible(transforms.DataToWorld) ||
    !CameraMatrices::IsInvertible(transforms.WorldToView) ||
    !CameraMatrices::IsInvertible(transforms.ViewToClip))
  {
    return false;
  }
  const glm::dmat4 clipToView = glm::inverse(transforms.ViewToClip);
  this->SetDepths(transforms, clipToView);
  if (!std::isfinite(this->Near) || !std::isfinite(this->Far))
  {
    return false;
  }
  this->SetRays(transforms, clipToView);
  this->Size = { transforms.Width, transforms.Height };
  this->MeshToWorld = glm::scale(
    glm::translate(transforms.DataToWorld, transforms.Center), glm::dvec3(transforms.Scale));
  this->MeshToView = transforms.WorldToView * this->MeshToWorld;
  this->MeshToClip = glm::mat4(transforms.ViewToClip * this->MeshToView);
  this->ViewToClip = transforms.ViewToClip;
  this->ViewToWorld = glm::inverse(transforms.WorldToView);
  this->SetEye(clipToView);
  return true;
}

//------------------------------------------------------------------------------
void ViewRays::SetEye(const glm::dmat4& clipToView)
{
  const glm::dvec4 eye = clipToView * glm::dvec4(0.0, 0.0, 1.0, 0.0);
  const bool isParallel = eye.w == 0.0;
  this->EyeDepth = (isParallel ? 0.0 : -eye.z / eye.w) - this->Reference;
  this->Eye = glm::inverse(this->MeshToView) * (isParallel ? eye : eye / eye.w);
}

//------------------------------------------------------------------------------
void ViewRays::SetDepths(const Transforms& transforms, const glm::dmat4& clipToView)
{
  this->Near = CameraMatrices::DepthOfPlane(clipToView, -1.0);
  this->Far = CameraMatrices::DepthOfPlane(clipToView, 1.0);
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
  const glm::dvec2 size(transforms.Width, transforms.Height);
  const glm::dvec2 middle = glm::floor(0.5 * size);
  // Rays are linear in the pixel, so a step over the whole viewport gives the slope to full
  // precision.
  const glm::dvec2 pixels[3] = { middle, middle + glm::dvec2(size.x, 0.0),
    middle + glm::dvec2(0.0, size.y) };
  const glm::dmat4 viewToWorld = glm::inverse(transforms.WorldToView);
  const glm::dmat4 viewToData = glm::inverse(transforms.WorldToView * transforms.DataToWorld);
  this->Pixel = glm::vec2(middle);
  RayAt at[3];
  for (int i = 0; i < 3; ++i)
  {
    const ViewRay ray = RayThrough(clipToView, 2.0 * pixels[i] / size - 1.0);
    const glm::dvec3 point = ray.Origin + this->Reference * ray.Direction;
    const glm::dvec3 data(viewToData * glm::dvec4(point, 1.0));
    at[i].Point = (data - transforms.Center) / transforms.Scale;
    at[i].Direction = glm::dvec3(viewToData * glm::dvec4(ray.Direction, 0.0)) / transforms.Scale;
    at[i].World = glm::dvec3(viewToWorld * glm::dvec4(ray.Direction, 0.0));
    at[i].View = glm::dvec4(glm::dvec2(point), glm::dvec2(ray.Direction));
  }
  SetLinear(this->Point, at[0].Point, at[1].Point, at[2].Point, size);
  SetLinear(this->Direction, at[0].Direction, at[1].Direction, at[2].Direction, size);
  SetLinear(this->World, at[0].World, at[1].World, at[2].World, size);
  SetLinear(this->View, at[0].View, at[1].View, at[2].View, size);
}
