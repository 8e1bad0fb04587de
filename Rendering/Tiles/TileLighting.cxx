#include "TileLighting.h"

#include "VolumeShading.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace
{
// Whether a matrix is a rotation, or a reflection, times one scale.
bool KeepsAngles(const glm::dmat3& matrix)
{
  const glm::dmat3 product = glm::transpose(matrix) * matrix;
  const double square = product[0][0];
  double greatest = 0.0;
  for (int i = 0; i < 9; ++i)
  {
    const double expected = i % 4 == 0 ? square : 0.0;
    greatest = std::max(greatest, std::abs(product[i / 3][i % 3] - expected));
  }
  return greatest <= 1e-6 * square;
}

bool IsGrey(const glm::vec3& light)
{
  return light.x == light.y && light.y == light.z;
}
}

//------------------------------------------------------------------------------
void TileLighting::Build(
  const VolumeShading& shading, const TileView& view, const TileView::Camera& camera)
{
  this->ScreenToMesh = glm::inverse(view.MeshToScreen);
  this->IsLit = shading.IsLit;
  this->Lights.clear();
  this->HasHighlight = false;
  this->Specular = 0.0f;
  if (this->IsLit)
  {
    const SceneLighting& lighting = shading.Lighting;
    this->Ambient = lighting.Ambient * lighting.AmbientLight;
    this->Power = lighting.Power;
    for (const SceneLight& light : lighting.Lights)
    {
      this->AddLight(light, shading);
    }
    this->IsGrey = this->HasGreyLights();
    this->HasGlance = this->HasHighlight && this->Power < 2.0f;
    this->SetGreatestTurn();
  }
  this->HasOpacity = shading.HasGradientOpacity;
  if (this->HasOpacity)
  {
    this->Opacity.Build(shading.GradientOpacity, 0.0);
  }
  const DependentColors::Kinds kind = shading.Colors.Kind;
  this->ColorKind = kind == DependentColors::None    ? OwnColor
                    : kind == DependentColors::Scalar ? ScalarColor
                                                      : DirectColor;
  if (this->ColorKind == ScalarColor)
  {
    this->ColorFunction.Build(shading.Colors.Function, 0.0);
  }
  this->AllowsThin = this->SetRays(view, camera) && this->HasThinLights();
  this->SetSpace(shading, camera);
}

//------------------------------------------------------------------------------
bool TileLighting::SetRays(const TileView& view, const TileView::Camera& camera)
{
  const glm::dmat3 worldToView = glm::inverse(glm::dmat3(camera.ViewToWorld));
  glm::dvec3 rays[3];
  for (int i = 0; i < 3; ++i)
  {
    rays[i] = worldToView * view.Ray[i];
  }
  const double along = rays[0].z;
  this->Rays.LengthPerWay = glm::length(view.Ray[0]) / glm::length(rays[0] / along);
  for (int k = 0; k < 2; ++k)
  {
    this->Rays.ToEye[k] = rays[0][k] / along;
    this->Rays.PerPixel[k] = rays[k + 1][k] / along;
  }
  // Columns change x alone, rows y.
  const double across = std::abs(rays[1].y) + std::abs(rays[1].z) + std::abs(rays[2].x) +
                        std::abs(rays[2].z);
  const double pixels = view.Width + view.Height;
  return along < 0.0 && pixels * across <= -1e-6 * along &&
         KeepsAngles(glm::dmat3(camera.ViewToWorld));
}

//------------------------------------------------------------------------------
bool TileLighting::HasThinLights() const
{
  const bool isWhole = this->Power == std::floor(this->Power) && this->Power <= 1024.0f;
  return this->IsLit && this->IsGrey && !this->HasOpacity && this->ColorKind == OwnColor &&
         !this->HasGlance && (isWhole || !this->HasHighlight) &&
         std::none_of(this->Lights.begin(), this->Lights.end(),
           [](const TileLight& light) { return light.IsPositional; });
}

//------------------------------------------------------------------------------
bool TileLighting::HasGreyLights() const
{
  return ::IsGrey(this->Ambient) &&
         std::all_of(this->Lights.begin(), this->Lights.end(),
           [](const TileLight& light)
           { return ::IsGrey(light.Ambient) && ::IsGrey(light.Diffuse) && ::IsGrey(light.Specular); });
}

//------------------------------------------------------------------------------
void TileLighting::AddLight(const SceneLight& light, const VolumeShading& shading)
{
  const SceneLighting& material = shading.Lighting;
  TileLight added;
  added.IsPositional = light.IsPositional;
  added.Place = light.IsPositional ? light.Position : -light.Direction;
  added.Towards = -light.Direction;
  added.IsAlongView = glm::length(glm::vec2(added.Towards)) <= 1e-6f && added.Towards.z > 0.0f;
  added.HasCone = light.ConeCosine >= -1.0f;
  added.Axis = light.Direction;
  added.ConeCosine = light.ConeCosine;
  added.Exponent = light.Exponent;
  added.Attenuation = light.Attenuation;
  added.Ambient = material.Ambient * light.Diffuse;
  added.Diffuse = material.Diffuse * light.Diffuse;
  added.Specular = material.Specular * light.Specular;
  this->HasHighlight = this->HasHighlight || added.Specular != glm::vec3(0.0f);
  this->Specular += std::max({ added.Specular.x, added.Specular.y, added.Specular.z, 0.0f });
  this->Ambient += light.IsPositional ? glm::vec3(0.0f) : added.Ambient;
  this->Lights.push_back(added);
}

//------------------------------------------------------------------------------
void TileLighting::SetSpace(const VolumeShading& shading, const TileView::Camera& camera)
{
  const glm::dmat4& meshToView = camera.MeshToView;
  this->IsInView = this->AllowsThin || !KeepsAngles(glm::dmat3(meshToView));
  this->HasOneScale = !this->IsInView && KeepsAngles(glm::dmat3(camera.ViewToWorld));
  this->GradientToView = shading.GradientToView;
  this->GradientScale = shading.GradientScale;
  this->ScreenToLights = this->IsInView ? meshToView * this->ScreenToMesh : this->ScreenToMesh;
  if (!this->IsInView)
  {
    this->GradientScale *= glm::length(shading.GradientToView[0]);
    const double scale = glm::length(glm::dvec3(meshToView[0]));
    this->MoveLights(glm::inverse(meshToView), static_cast<float>(scale));
  }
}

//------------------------------------------------------------------------------
void TileLighting::MoveLights(const glm::dmat4& viewToMesh, float scale)
{
  auto turn = [&](const glm::vec3& way)
  { return glm::vec3(static_cast<double>(scale) * (glm::dmat3(viewToMesh) * glm::dvec3(way))); };
  for (TileLight& light : this->Lights)
  {
    light.Place = light.IsPositional
                    ? glm::vec3(viewToMesh * glm::dvec4(glm::dvec3(light.Place), 1.0))
                    : turn(light.Place);
    light.Axis = turn(light.Axis);
    light.Attenuation *= glm::vec3(1.0f, scale, scale * scale);
  }
}

//------------------------------------------------------------------------------
void TileLighting::SetGreatestTurn()
{
  // Two nodes leave the fourth derivative, which of a highlight grows with the power's square.
  const float sharpness = std::sqrt(std::sqrt(this->Specular) * this->Power);
  this->GreatestTurn = 0.25f / std::max(sharpness, 1.25f);
}
