#ifndef LightReader_h
#define LightReader_h

#include "SceneLighting.h"

#include <glm/mat4x4.hpp>

#include <string>

class vtkLight;
class vtkLightCollection;
class vtkVolumeProperty;

/**
 * @class LightReader
 * @brief Takes lights of any kind from a renderer, coefficients from a property.
 */
class LightReader
{
public:
  /// More do not shine.
  static constexpr int MaximumLights = 16;

  explicit LightReader(const glm::dmat4& worldToView)
    : WorldToView(worldToView)
  {
  }

  /// What cannot shine is left out; `problem` names it, and is empty where there is none.
  SceneLighting Read(
    vtkLightCollection* lights, vtkVolumeProperty* property, std::string& problem) const;

private:
  bool Read(vtkLight* light, SceneLight& read) const;

  glm::dmat4 WorldToView;
};

#endif
