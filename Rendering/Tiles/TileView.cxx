#include "TileView.h"

#include "CameraMatrices.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
bool TileView::Camera::operator==(const Camera& other) const
{
  return this->MeshToView == other.MeshToView && this->ViewToClip == other.ViewToClip &&
         this->ViewToWorld == other.ViewToWorld && this->Width == other.Width &&
         this->Height == other.Height;
}

//------------------------------------------------------------------------------
bool TileView::Build(const Camera& camera)
{
  if (!CameraMatrices::IsInvertible(camera.MeshToView) || !CameraMatrices::IsInvertible(camera.ViewToClip))
  {
    return false;
  }
  const glm::dmat4 clipToView = glm::inverse(camera.ViewToClip);
  const double nearDepth = CameraMatrices::DepthOfPlane(clipToView, -1.0);
  const double farDepth = CameraMatrices::DepthOfPlane(clipToView, 1.0);
  if (!std::isfinite(nearDepth) || !std::isfinite(farDepth))
  {
    return false;
  }
  this->ViewToClip = camera.ViewToClip;
  this->Width = camera.Width;
  this->Height = camera.Height;
  this->IsParallel = camera.ViewToClip[2][3] == 0.0;
  this->SetDepths(camera.MeshToView, nearDepth, farDepth);
  this->SetScreen(camera);
  this->SetRays(camera);
  const glm::dvec3 middle =
    this->Ray[0] + 0.5 * this->Width * this->Ray[1] + 0.5 * this->Height * this->Ray[2];
  this->LengthOfExtent = this->Extent * glm::length(middle);
  return CameraMatrices::IsInvertible(this->MeshToScreen);
}

//------------------------------------------------------------------------------
void TileView::SetDepths(const glm::dmat4& meshToView, double nearDepth, double farDepth)
{
  // Mesh coordinates lie within [-1, 1].
  const glm::dvec4 row = glm::row(meshToView, 2);
  const double radius = std::abs(row.x) + std::abs(row.y) + std::abs(row.z);
  const double center = -meshToView[3].z;
  // Of a mesh about the eye a place before it: beside 1 / depth at the eye a float keeps no digit.
  this->Reference = std::min(std::max({ center, 0.5 * radius, nearDepth }), farDepth);
  this->WeightScale = this->IsParallel ? 0.0 : 1.0;
  this->WeightOffset = 1.0;
  if (!this->IsParallel)
  {
    this->WeightOffset = 1.0 / (this->ViewToClip[3][3] - this->ViewToClip[2][3] * this->Reference);
  }
  this->NearU = this->ScreenDepth(nearDepth);
  this->FarU = this->ScreenDepth(farDepth);
  this->Extent = 2.0 * radius;
  const double deepest = std::max(std::min(center + radius, farDepth), nearDepth);
  this->FarWeight = this->WeightScale * this->ScreenDepth(deepest) + this->WeightOffset;
}

//------------------------------------------------------------------------------
void TileView::SetScreen(const Camera& camera)
{
  const glm::dmat4 meshToClip = camera.ViewToClip * camera.MeshToView;
  const glm::dvec4 weight = glm::row(meshToClip, 3);
  const glm::dvec4 one(0.0, 0.0, 0.0, 1.0);
  const glm::dvec4 depth = -glm::row(camera.MeshToView, 2) - this->Reference * one;
  const glm::dvec4 u = this->IsParallel ? -depth : one - this->WeightOffset * weight;
  const glm::dvec4 x = 0.5 * this->Width * (glm::row(meshToClip, 0) + weight) - 0.5 * weight;
  const glm::dvec4 y = 0.5 * this->Height * (glm::row(meshToClip, 1) + weight) - 0.5 * weight;
  this->MeshToScreen = glm::transpose(glm::dmat4(x, y, u, weight));
  this->KeepsOrientation = glm::determinant(this->MeshToScreen) > 0.0;
  this->PlaneToScreen = glm::transpose(glm::inverse(this->MeshToScreen));
  this->ViewPlaneToScreen = this->PlaneToScreen * glm::transpose(camera.MeshToView);
}

//------------------------------------------------------------------------------
void TileView::SetRays(const Camera& camera)
{
  const glm::dmat4 clipToView = glm::inverse(camera.ViewToClip);
  const double perDepth = this->IsParallel ? 1.0 : 1.0 / std::abs(camera.ViewToClip[2][3]);
  // Linear in the pixel: a step over the whole viewport gives the slope to full precision.
  const glm::dvec2 steps[3] = { { 0.0, 0.0 }, { this->Width, 0.0 }, { 0.0, this->Height } };
  for (int i = 0; i < 3; ++i)
  {
    const double x = 2.0 * (steps[i].x + 0.5) / this->Width - 1.0;
    const double y = 2.0 * (steps[i].y + 0.5) / this->Height - 1.0;
    const glm::dvec4 nearPoint = clipToView * glm::dvec4(x, y, -1.0, 1.0);
    const glm::dvec4 farPoint = clipToView * glm::dvec4(x, y, 1.0, 1.0);
    const glm::dvec3 along =
      glm::dvec3(farPoint) / farPoint.w - glm::dvec3(nearPoint) / nearPoint.w;
    const glm::dvec3 direction = along / -along.z;
    this->Ray[i] = perDepth * glm::dvec3(camera.ViewToWorld * glm::dvec4(direction, 0.0));
  }
  this->Ray[1] = (this->Ray[1] - this->Ray[0]) / static_cast<double>(this->Width);
  this->Ray[2] = (this->Ray[2] - this->Ray[0]) / static_cast<double>(this->Height);
}

//------------------------------------------------------------------------------
double TileView::ScreenDepth(double depth) const
{
  if (this->IsParallel)
  {
    return this->Reference - depth;
  }
  const double weight = this->ViewToClip[3][3] - this->ViewToClip[2][3] * depth;
  return weight > 0.0 ? 1.0 / weight - this->WeightOffset : 1e30;
}

//------------------------------------------------------------------------------
TileView::DepthToScreen TileView::GetDepthToScreen() const
{
  if (this->IsParallel)
  {
    return { { { this->Reference, -1.0, 0.0 } }, false };
  }
  return { { { this->ViewToClip[3][3], -this->ViewToClip[2][3], -this->WeightOffset } }, true };
}

//------------------------------------------------------------------------------
double TileView::DepthOfWindow(double z) const
{
  const glm::dmat4& clip = this->ViewToClip;
  const double ndc = 2.0 * z - 1.0;
  return (clip[3][2] - ndc * clip[3][3]) / (clip[2][2] - ndc * clip[2][3]);
}
