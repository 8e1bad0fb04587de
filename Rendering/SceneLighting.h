#ifndef SceneLighting_h
#define SceneLighting_h

#include <glm/vec3.hpp>

#include <vector>

/**
 * @class SceneLight
 * @brief One light, in view coordinates; its colours include its intensity.
 *
 * A directional light shines along Direction; a positional one from Position, weakened by
 * 1 / (a + b d + c d d) at the distance d and, inside its cone, by cosine^Exponent.
 */
struct SceneLight
{
  bool IsPositional = false;
  glm::vec3 Position{ 0.0f };
  glm::vec3 Direction{ 0.0f, 0.0f, -1.0f };
  /// Below -1 where there is no cone.
  float ConeCosine = -2.0f;
  float Exponent = 0.0f;
  glm::vec3 Attenuation{ 1.0f, 0.0f, 0.0f };
  glm::vec3 Diffuse{ 1.0f };
  glm::vec3 Specular{ 1.0f };
};

/**
 * @class SceneLighting
 * @brief What lights a volume: lights and the coefficients of its property.
 *
 *     kappa (Ambient sum(light) + Diffuse sum(light |n.l|)) + Specular sum(light (r.v)^Power)
 */
struct SceneLighting
{
  std::vector<SceneLight> Lights;
  /// The lights' own ambient colours, which are the same everywhere.
  glm::vec3 AmbientLight{ 0.0f };
  float Ambient = 0.1f;
  float Diffuse = 0.7f;
  float Specular = 0.2f;
  float Power = 10.0f;
};

#endif
