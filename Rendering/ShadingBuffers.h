#ifndef ShadingBuffers_h
#define ShadingBuffers_h

#include "DependentColors.h"
#include "TextureBuffer.h"
#include "vtkTimeStamp.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <vector>

class VolumeShading;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;
struct SceneLighting;

/**
 * @class ShadingBuffers
 * @brief A VolumeShading on the GPU: cpGradients.glsl, cpLighting.glsl, cpGradientOpacity.glsl.
 */
class ShadingBuffers
{
public:
  /// What changed since the last time alone is uploaded. False, with the reason in GetFailure,
  /// where the driver has no room for it. The context must be current.
  bool Upload(vtkOpenGLRenderWindow* window, const VolumeShading& shading);
  /// For those who have gradients of their own: all but them.
  void TakeLights(const VolumeShading& shading);

  bool IsLit() const { return this->Lit; }
  bool HasGradientOpacity() const { return this->NumberOfNodes > 0; }
  DependentColors::Kinds GetColors() const { return this->Colors; }
  /// What shades a point: for as many lights as there are, with no more than they need.
  std::string GetPointLightSource() const;

  void Activate(vtkShaderProgram* program);
  /// cpLighting.glsl alone, with what takes gradients to view coordinates.
  void ActivateLights(vtkShaderProgram* program);
  /// For what GetPointLightSource gave, in the same way.
  void ActivatePointLights(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);
  const std::string& GetFailure() const { return this->Failure; }

private:
  bool UploadColors(vtkOpenGLRenderWindow* window, const DependentColors& colors);
  void ActivateColors(vtkShaderProgram* program);
  bool UploadNodes(vtkOpenGLRenderWindow* window, const VolumeShading& shading);
  void PackLights(const SceneLighting& lighting);

  TextureBuffer Gradients;
  TextureBuffer Nodes;
  vtkTimeStamp GradientsUploaded;
  TextureBuffer ColorValues;
  TextureBuffer ColorPositions;
  TextureBuffer CornerColors;
  vtkTimeStamp ColorsUploaded;
  DependentColors::Kinds Colors = DependentColors::None;
  bool ColorsPerCell = false;
  int NumberOfColorNodes = 0;
  int NumberOfNodes = 0;
  bool Lit = false;
  glm::mat3 GradientToView{ 1.0f };
  float GradientScale = 1.0f;
  float GreatestTurn = 1.0f;
  std::vector<glm::vec4> Lights;
  bool AreLightsDistant = true;
  glm::vec3 AmbientLight{ 0.0f };
  glm::vec4 Material{ 0.0f };
  std::string Failure;
};

#endif
