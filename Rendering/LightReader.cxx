#include "LightReader.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkVolumeProperty.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace
{
glm::vec3 Bright(vtkLight* light, const double color[3])
{
  return glm::vec3(light->GetIntensity() * glm::dvec3(glm::make_vec3(color)));
}

std::string Describe(int dark, int tooMany)
{
  std::string text;
  if (dark > 0)
  {
    text += std::to_string(dark) +
            " lights have no direction (their focal point is their position) or attenuation "
            "values of zero: they do not shine. ";
  }
  if (tooMany > 0)
  {
    text += std::to_string(tooMany) + " lights do not shine: the first " +
            std::to_string(LightReader::MaximumLights) + " do; switch some off. ";
  }
  return text;
}
}

//------------------------------------------------------------------------------
SceneLighting LightReader::Read(
  vtkLightCollection* lights, vtkVolumeProperty* property, std::string& problem) const
{
  SceneLighting lighting;
  lighting.Ambient = static_cast<float>(property->GetAmbient());
  lighting.Diffuse = static_cast<float>(property->GetDiffuse());
  lighting.Specular = static_cast<float>(property->GetSpecular());
  lighting.Power = static_cast<float>(property->GetSpecularPower());
  int dark = 0, tooMany = 0;
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    SceneLight read;
    const bool shines = light->GetSwitch() && this->Read(light, read);
    const bool fits = lighting.Lights.size() < MaximumLights;
    dark += light->GetSwitch() && !shines ? 1 : 0;
    tooMany += shines && !fits ? 1 : 0;
    if (shines && fits)
    {
      lighting.Lights.push_back(read);
      lighting.AmbientLight += Bright(light, light->GetAmbientColor());
    }
  }
  problem = Describe(dark, tooMany);
  return lighting;
}

//------------------------------------------------------------------------------
bool LightReader::Read(vtkLight* light, SceneLight& read) const
{
  double position[3], focalPoint[3];
  light->GetTransformedPosition(position);
  light->GetTransformedFocalPoint(focalPoint);
  const glm::dvec3 place = glm::make_vec3(position);
  const glm::dvec3 way = glm::dvec3(glm::make_vec3(focalPoint)) - place;
  read.IsPositional = light->GetPositional() != 0;
  read.Position = glm::vec3(this->WorldToView * glm::dvec4(place, 1.0));
  const glm::dvec3 along(this->WorldToView * glm::dvec4(way, 0.0));
  const double length = glm::length(along);
  read.Direction = glm::vec3(length > 0.0 ? along / length : glm::dvec3(0.0));
  // VTK's cone angle is half of the cone's; from 90 degrees on there is none.
  const bool hasCone = read.IsPositional && light->GetConeAngle() < 90.0;
  if (hasCone)
  {
    read.ConeCosine = static_cast<float>(std::cos(glm::radians(light->GetConeAngle())));
    read.Exponent = static_cast<float>(light->GetExponent());
  }
  read.Attenuation = glm::vec3(glm::make_vec3(light->GetAttenuationValues()));
  read.Diffuse = Bright(light, light->GetDiffuseColor());
  read.Specular = Bright(light, light->GetSpecularColor());
  const bool fades = read.IsPositional && read.Attenuation == glm::vec3(0.0f);
  return !fades && (length > 0.0 || (read.IsPositional && !hasCone));
}
