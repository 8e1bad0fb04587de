#include "IsoRaster.h"

#include "ElementBuffers.h"
#include "ElementShaders.h"
#include "RayUniforms.h"
#include "ShadingBuffers.h"
#include "VTKVersions.h"
#include "ViewRays.h"
#include "cpElementGradient.h"
#include "cpGradientOpacity.h"
#include "cpIsoBlend.h"
#include "cpIsoDepth.h"
#include "cpIsoFragment.h"
#include "cpIsoPoint.h"
#include "cpNoGradientOpacity.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <glm/gtc/type_ptr.hpp>
#include <glm/vec2.hpp>

namespace
{
// Behind so many surfaces nothing is looked for.
constexpr int MaximumLayers = 64;

std::string SurfaceSource(const ShadingBuffers& shading)
{
  const bool needsGradient = shading.IsLit() || shading.HasGradientOpacity();
  std::string source = ElementShaders::WithElement(cpIsoFragment);
  vtkShaderProgram::Substitute(source, "//VTK::IsoPoint::Dec", needsGradient ? std::string(cpElementGradient) + cpIsoPoint : "");
  vtkShaderProgram::Substitute(source, "//VTK::GradientOpacity::Dec",
    shading.HasGradientOpacity() ? cpGradientOpacity : cpNoGradientOpacity);
  vtkShaderProgram::Substitute(source, "//VTK::IsoPoint::Impl",
    needsGradient ? "beginIsoPoint(gradientOfElement(at + found.x * slope), base + found.x);" : "");
  vtkShaderProgram::Substitute(source, "//VTK::Lighting::Dec", shading.GetPointLightSource());
  return source;
}
}

//------------------------------------------------------------------------------
bool IsoRaster::Prepare(
  vtkOpenGLRenderWindow* window, const View& view, const ShadingBuffers& shading)
{
  if (!this->Layers.Prepare(window, view.Width, view.Height))
  {
    this->Failure = "the driver cannot render to floats with a float depth";
    return false;
  }
  if (view.Triangles && !this->Triangles.Prepare(window, view, *view.Triangles, shading))
  {
    this->Failure = this->Triangles.GetFailure();
    return false;
  }
  this->Surfaces = view.Triangles
                     ? nullptr
                     : ElementShaders::ReadyProgram(
                         window, view, SurfaceSource(shading), true);
  const bool isReady =
    this->Blend.Ready(window, cpIsoBlend) && (view.Triangles || this->Surfaces);
  this->Failure = isReady ? "" : "the iso-surfaces' shaders did not compile";
  return isReady;
}

//------------------------------------------------------------------------------
bool IsoRaster::Draw(vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers,
  ShadingBuffers& shading)
{
  if (!this->Prepare(window, view, shading))
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglBlendFuncSeparate function(state);
  const vtkOpenGLState::ScopedglDepthFunc depthFunction(state);
  state->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  view.OpaqueDepth->Activate();
  if (view.Triangles)
  {
    this->DrawTriangles(window, view, shading);
  }
  else
  {
    this->DrawElements(window, view, buffers, shading);
  }
  view.OpaqueDepth->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
void IsoRaster::DrawTriangles(
  vtkOpenGLRenderWindow* window, const View& view, ShadingBuffers& shading)
{
  const glm::vec4 shareOfMesh(-view.Depths[0], 1.0f, view.Depths[1], 0.0f);
  this->Layers.BeginLayer(window, true);
  this->Triangles.Draw(window, view, *view.Triangles, shading, shareOfMesh);
  this->Layers.EndLayer(window);
  this->BlendLayer(window);
}

//------------------------------------------------------------------------------
bool IsoRaster::DrawIntoWindow(vtkOpenGLRenderWindow* window, const View& view,
  const int origin[2], ShadingBuffers& shading)
{
  ViewRays rays = *view.Rays;
  rays.Pixel += glm::vec2(origin[0], origin[1]);
  RasterView inWindow = view;
  inWindow.Rays = &rays;
  inWindow.OpaqueDepth = nullptr;
  if (!this->Triangles.Prepare(window, inWindow, *view.Triangles, shading))
  {
    this->Failure = this->Triangles.GetFailure();
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglDepthMask mask(state);
  const vtkOpenGLState::ScopedglDepthFunc function(state);
  const vtkOpenGLState::ScopedglEnableDisable test(state, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  const vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
  const glm::vec4& z = rays.DepthFromWindow;
  this->Triangles.Draw(
    window, inWindow, *view.Triangles, shading, glm::vec4(z.x, -z.z, -z.y, z.w));
  return true;
}

//------------------------------------------------------------------------------
void IsoRaster::DrawElements(vtkOpenGLRenderWindow* window, const View& view,
  ElementBuffers& buffers, ShadingBuffers& shading)
{
  window->GetShaderCache()->ReadyShaderProgram(this->Surfaces);
  RayUniforms::Set(this->Surfaces, view);
  buffers.Activate(this->Surfaces);
  const bool needsGradient = shading.IsLit() || shading.HasGradientOpacity();
  if (needsGradient)
  {
    shading.Activate(this->Surfaces);
    shading.ActivatePointLights(this->Surfaces);
  }
  this->Surfaces->SetUniform1fv(
    "isoValues", static_cast<int>(view.Values.size()), view.Values.data());
  this->Surfaces->SetUniformi("numberOfIsoValues", static_cast<int>(view.Values.size()));
  this->Surfaces->SetUniform2f("isoDepths", view.Depths.data());
  bool found = true;
  for (int layer = 0; found && layer < MaximumLayers; ++layer)
  {
    found = this->DrawLayer(window, view, layer);
    this->BlendLayer(window);
  }
  if (needsGradient)
  {
    shading.Deactivate();
  }
  buffers.Deactivate();
}

//------------------------------------------------------------------------------
bool IsoRaster::DrawLayer(vtkOpenGLRenderWindow* window, const View& view, int layer)
{
  this->Layers.BeginLayer(window, layer == 0);
  window->GetShaderCache()->ReadyShaderProgram(this->Surfaces);
  this->Layers.GetLastDepth()->Activate();
  this->Surfaces->SetUniformi("lastLayer", this->Layers.GetLastDepth()->GetTextureUnit());
  this->Surfaces->SetUniformi("isFirstLayer", layer == 0 ? 1 : 0);
  this->Vertices.Draw(*view.Vertices, this->Surfaces);
  this->Layers.GetLastDepth()->Deactivate();
  this->Layers.EndLayer(window);
  return this->Layers.WasAnyDrawn();
}

//------------------------------------------------------------------------------
void IsoRaster::BlendLayer(vtkOpenGLRenderWindow* window)
{
  vtkShaderProgram* program = this->Blend.Ready(window, cpIsoBlend);
  this->Layers.GetColor()->Activate();
  program->SetUniformi("layer", this->Layers.GetColor()->GetTextureUnit());
  this->Blend.Draw();
  this->Layers.GetColor()->Deactivate();
}

//------------------------------------------------------------------------------
void IsoRaster::DrawDepth(vtkOpenGLRenderWindow* window, const View& view, const int origin[2])
{
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(state);
  const vtkOpenGLState::ScopedglDepthMask mask(state);
  const vtkOpenGLState::ScopedglDepthFunc function(state);
  const vtkOpenGLState::ScopedglColorMask colors(state);
  const vtkOpenGLState::ScopedglEnableDisable test(state, GL_DEPTH_TEST);
  state->vtkglViewport(origin[0], origin[1], view.Width, view.Height);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  vtkShaderProgram* program = this->Depth.Ready(window, cpIsoDepth);
  if (!program)
  {
    return;
  }
  this->Layers.GetFirstColor()->Activate();
  this->Layers.GetFirstDepth()->Activate();
  program->SetUniformi("layer", this->Layers.GetFirstColor()->GetTextureUnit());
  program->SetUniformi("layerDepth", this->Layers.GetFirstDepth()->GetTextureUnit());
  program->SetUniform2f("isoDepths", view.Depths.data());
  program->SetUniform4f("depthFromWindow", glm::value_ptr(view.Rays->DepthFromWindow));
  this->Depth.Draw();
  this->Layers.GetFirstDepth()->Deactivate();
  this->Layers.GetFirstColor()->Deactivate();
}

//------------------------------------------------------------------------------
void IsoRaster::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Vertices.ReleaseGraphicsResources();
  this->Triangles.ReleaseGraphicsResources(window);
  this->Layers.ReleaseGraphicsResources(window);
  this->Blend.ReleaseGraphicsResources();
  this->Depth.ReleaseGraphicsResources();
  this->Surfaces = nullptr;
}
