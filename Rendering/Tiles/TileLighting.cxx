#include "TileLighting.h"

#include "VolumeShading.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void TileLighting::Build(
  const VolumeShading& shading, const TileView& view, const TileView::Camera& camera)
{
  this->ScreenToMesh = glm::inverse(view.MeshToScreen);
  this->ScreenToView = camera.MeshToView * this->ScreenToMesh;
  this->GradientToView = shading.GradientToView;
  this->GradientScale = shading.GradientScale;
  this->IsLit = shading.IsLit;
  this->Lights.clear();
  this->HasHighlight = false;
  if (this->IsLit)
  {
    const SceneLighting& lighting = shading.Lighting;
    this->Ambient = lighting.Ambient * lighting.AmbientLight;
    this->Power = lighting.Power;
    for (const SceneLight& light : lighting.Lights)
    {
      this->AddLight(light, shading);
    }
    this->HasGlance = this->HasHighlight && this->Power < 2.0f;
    this->SetGreatestTurn(lighting.Specular);
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
}

//------------------------------------------------------------------------------
void TileLighting::AddLight(const SceneLight& light, const VolumeShading& shading)
{
  const SceneLighting& material = shading.Lighting;
  TileLight added;
  added.IsPositional = light.IsPositional;
  added.Place = light.IsPositional ? light.Position : -light.Direction;
  added.HasCone = light.ConeCosine >= -1.0f;
  added.Axis = light.Direction;
  added.ConeCosine = light.ConeCosine;
  added.Exponent = light.Exponent;
  added.Attenuation = light.Attenuation;
  added.Ambient = material.Ambient * light.Diffuse;
  added.Diffuse = material.Diffuse * light.Diffuse;
  added.Specular = material.Specular * light.Specular;
  this->HasHighlight = this->HasHighlight || added.Specular != glm::vec3(0.0f);
  this->Ambient += light.IsPositional ? glm::vec3(0.0f) : added.Ambient;
  this->Lights.push_back(added);
}

//------------------------------------------------------------------------------
void TileLighting::SetGreatestTurn(float specular)
{
  // Two nodes leave the fourth derivative, which of a highlight grows with the power's square.
  const float sharpness =
    this->HasHighlight ? std::sqrt(std::sqrt(specular) * this->Power) : 0.0f;
  this->GreatestTurn = 0.5f / std::max(sharpness, 1.25f);
}
