#include "ShadingBuffers.h"

#include "VolumeShading.h"
#include "cpDistantLights.h"
#include "cpLighting.h"
#include "cpNoLighting.h"
#include "cpPointLight.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void ShadingBuffers::TakeLights(const VolumeShading& shading)
{
  this->Lit = shading.IsLit;
  this->GradientToView = shading.GradientToView;
  this->GradientScale = shading.GradientScale;
  this->PackLights(shading.Lighting);
}

//------------------------------------------------------------------------------
bool ShadingBuffers::Upload(vtkOpenGLRenderWindow* window, const VolumeShading& shading)
{
  this->TakeLights(shading);
  if (this->GradientsUploaded < shading.GradientsTime)
  {
    if (!this->Gradients.Upload(window, shading.Gradients.Values, 4))
    {
      this->Failure = this->Gradients.GetFailure();
      return false;
    }
    this->GradientsUploaded.Modified();
  }
  return this->UploadNodes(window, shading) && this->UploadColors(window, shading.Colors);
}

//------------------------------------------------------------------------------
bool ShadingBuffers::UploadColors(vtkOpenGLRenderWindow* window, const DependentColors& colors)
{
  this->Colors = colors.Kind;
  this->ColorsPerCell = colors.OnePerCell;
  if (colors.Kind == DependentColors::None || this->ColorsUploaded > colors.Time)
  {
    return true;
  }
  const TransferFunction& function = colors.Function;
  this->NumberOfColorNodes = function.GetNumberOfNodes();
  const bool good = this->CornerColors.Upload(window, colors.Values, 4) &&
                    (colors.Kind == DependentColors::Direct ||
                      (this->ColorPositions.Upload(window, function.GetPositions(), 1) &&
                        this->ColorValues.Upload(window, function.GetValues(), 4)));
  if (good)
  {
    this->ColorsUploaded.Modified();
  }
  else
  {
    this->Failure = this->CornerColors.GetFailure() + this->ColorValues.GetFailure();
  }
  return good;
}

//------------------------------------------------------------------------------
void ShadingBuffers::ActivateColors(vtkShaderProgram* program)
{
  if (this->Colors != DependentColors::None)
  {
    this->CornerColors.Activate(program, "cornerColours");
    program->SetUniformi("coloursPerCell", this->ColorsPerCell ? 1 : 0);
  }
  if (this->Colors == DependentColors::Scalar)
  {
    this->ColorPositions.Activate(program, "colourPositions");
    this->ColorValues.Activate(program, "colourValues");
    program->SetUniformi("numberOfColourNodes", this->NumberOfColorNodes);
  }
}

//------------------------------------------------------------------------------
bool ShadingBuffers::UploadNodes(vtkOpenGLRenderWindow* window, const VolumeShading& shading)
{
  this->NumberOfNodes = 0;
  if (!shading.HasGradientOpacity)
  {
    return true;
  }
  const TransferFunction& opacity = shading.GradientOpacity;
  std::vector<float> nodes;
  for (int i = 0; i < opacity.GetNumberOfNodes(); ++i)
  {
    nodes.push_back(opacity.GetPositions()[i]);
    nodes.push_back(opacity.GetValues()[4 * static_cast<size_t>(i) + 3]);
  }
  if (!this->Nodes.Upload(window, nodes, 1))
  {
    this->Failure = this->Nodes.GetFailure();
    return false;
  }
  this->NumberOfNodes = opacity.GetNumberOfNodes();
  return true;
}

//------------------------------------------------------------------------------
void ShadingBuffers::PackLights(const SceneLighting& lighting)
{
  this->Lights.clear();
  this->AreLightsDistant = true;
  for (const SceneLight& light : lighting.Lights)
  {
    const glm::vec3 place = light.IsPositional ? light.Position : -light.Direction;
    this->Lights.emplace_back(place, light.IsPositional ? 1.0f : 0.0f);
    this->AreLightsDistant = this->AreLightsDistant && !light.IsPositional;
    this->Lights.emplace_back(light.Direction, light.ConeCosine);
    this->Lights.emplace_back(light.Attenuation, light.Exponent);
    this->Lights.emplace_back(light.Diffuse, 0.0f);
    this->Lights.emplace_back(light.Specular, 0.0f);
  }
  this->AmbientLight = lighting.AmbientLight;
  this->Material =
    glm::vec4(lighting.Ambient, lighting.Diffuse, lighting.Specular, lighting.Power);
  // A highlight of power p is about 1 / sqrt(p) wide.
  this->GreatestTurn = std::min(0.5f, 1.0f / std::sqrt(std::max(lighting.Power, 1.0f)));
}

//------------------------------------------------------------------------------
std::string ShadingBuffers::GetPointLightSource() const
{
  if (!this->Lit)
  {
    return cpNoLighting;
  }
  if (!this->AreLightsDistant)
  {
    return std::string(cpLighting) + cpPointLight;
  }
  return "const int numberOfLights = " + std::to_string(this->Lights.size() / 5) +
         ";\nconst bool hasHighlights = " + (this->Material.z > 0.0f ? "true" : "false") + ";\n" +
         cpDistantLights;
}

//------------------------------------------------------------------------------
void ShadingBuffers::Activate(vtkShaderProgram* program)
{
  this->ActivateColors(program);
  this->Gradients.Activate(program, "pointGradients");
  if (this->HasGradientOpacity())
  {
    this->Nodes.Activate(program, "gradientNodes");
    program->SetUniformi("numberOfGradientNodes", this->NumberOfNodes);
    program->SetUniformf("gradientScale", this->GradientScale);
  }
  this->ActivateLights(program);
}

//------------------------------------------------------------------------------
void ShadingBuffers::ActivateLights(vtkShaderProgram* program)
{
  program->SetUniformMatrix3x3("gradientToView", glm::value_ptr(this->GradientToView));
  if (this->Lit)
  {
    const int lights = static_cast<int>(this->Lights.size());
    program->SetUniformi("numberOfLights", lights / 5);
    program->SetUniform3f("ambientLight", glm::value_ptr(this->AmbientLight));
    program->SetUniform4f("material", glm::value_ptr(this->Material));
    program->SetUniformf("greatestTurn", this->GreatestTurn);
    if (lights > 0)
    {
      program->SetUniform4fv("lights", lights, glm::value_ptr(this->Lights[0]));
    }
  }
}

//------------------------------------------------------------------------------
void ShadingBuffers::ActivatePointLights(vtkShaderProgram* program)
{
  if (!this->Lit || !this->AreLightsDistant)
  {
    this->ActivateLights(program);
    return;
  }
  std::vector<glm::vec3> lights;
  glm::vec3 ambient = this->AmbientLight;
  for (size_t i = 0; i < this->Lights.size(); i += 5)
  {
    ambient += glm::vec3(this->Lights[i + 3]);
    lights.emplace_back(this->Lights[i]);
    lights.push_back(this->Material.y * glm::vec3(this->Lights[i + 3]));
    lights.push_back(this->Material.z * glm::vec3(this->Lights[i + 4]));
  }
  ambient *= this->Material.x;
  program->SetUniformMatrix3x3("gradientToView", glm::value_ptr(this->GradientToView));
  program->SetUniform3f("distantAmbient", glm::value_ptr(ambient));
  program->SetUniformf("distantPower", this->Material.w);
  if (!lights.empty())
  {
    program->SetUniform3fv(
      "distantLights", static_cast<int>(lights.size()), glm::value_ptr(lights[0]));
  }
}

//------------------------------------------------------------------------------
void ShadingBuffers::Deactivate()
{
  this->Gradients.Deactivate();
  if (this->HasGradientOpacity())
  {
    this->Nodes.Deactivate();
  }
  if (this->Colors != DependentColors::None)
  {
    this->CornerColors.Deactivate();
  }
  if (this->Colors == DependentColors::Scalar)
  {
    this->ColorPositions.Deactivate();
    this->ColorValues.Deactivate();
  }
}

//------------------------------------------------------------------------------
void ShadingBuffers::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Gradients.ReleaseGraphicsResources(window);
  this->Nodes.ReleaseGraphicsResources(window);
  this->ColorValues.ReleaseGraphicsResources(window);
  this->ColorPositions.ReleaseGraphicsResources(window);
  this->CornerColors.ReleaseGraphicsResources(window);
  this->GradientsUploaded = vtkTimeStamp();
  this->ColorsUploaded = vtkTimeStamp();
}
