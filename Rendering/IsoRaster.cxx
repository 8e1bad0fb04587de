#include "IsoRaster.h"

#include "ElementBuffers.h"
#include "ElementShaders.h"
#include "RayUniforms.h"
#include "ShadingBuffers.h"
#include "VTKVersions.h"
#include "ViewRays.h"
#include "cpIsoBlend.h"
#include "cpIsoDepth.h"
#include "cpIsoFragment.h"
#include "cpIsoPoint.h"
#include "cpLighting.h"
#include "cpNoLighting.h"
#include "cpPointLight.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <glm/gtc/type_ptr.hpp>

namespace
{
// Behind so many surfaces nothing is looked for.
constexpr int MaximumLayers = 64;

std::string SurfaceSource(bool isLit)
{
  std::string source = ElementShaders::WithElement(cpIsoFragment);
  vtkShaderProgram::Substitute(source, "//VTK::IsoPoint::Dec", isLit ? cpIsoPoint : "");
  vtkShaderProgram::Substitute(source, "//VTK::IsoPoint::Impl",
    isLit ? "beginIsoPoint(at + found.x * slope, base + found.x);" : "");
  vtkShaderProgram::Substitute(source, "//VTK::Lighting::Dec",
    isLit ? std::string(cpLighting) + cpPointLight : cpNoLighting);
  return source;
}
}

//------------------------------------------------------------------------------
bool IsoRaster::Prepare(vtkOpenGLRenderWindow* window, const View& view, bool isLit)
{
  if (!this->Layers.Prepare(window, view.Width, view.Height))
  {
    this->Failure = "the driver cannot render to floats with a float depth";
    return false;
  }
  vtkShaderProgram* blend = this->Blend.Ready(window, cpIsoBlend);
  this->Surfaces = ElementShaders::ReadyProgram(window, view, SurfaceSource(isLit), true);
  if (!blend || !this->Surfaces)
  {
    this->Failure = "the iso-surfaces' shaders did not compile";
  }
  return blend && this->Surfaces;
}

//------------------------------------------------------------------------------
bool IsoRaster::Draw(vtkOpenGLRenderWindow* window, const View& view, ElementBuffers& buffers,
  ShadingBuffers& shading)
{
  if (!this->Prepare(window, view, shading.IsLit()))
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglBlendFuncSeparate function(state);
  const vtkOpenGLState::ScopedglDepthFunc depthFunction(state);
  state->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  view.OpaqueDepth->Activate();
  RayUniforms::Set(this->Surfaces, view);
  buffers.Activate(this->Surfaces);
  if (shading.IsLit())
  {
    shading.Activate(this->Surfaces);
  }
  this->Surfaces->SetUniform1fv(
    "isoValues", static_cast<int>(view.Values.size()), view.Values.data());
  this->Surfaces->SetUniformi("numberOfIsoValues", static_cast<int>(view.Values.size()));
  this->Surfaces->SetUniform2f("isoDepths", view.Depths.data());
  bool found = true;
  for (int layer = 0; found && layer < (view.IsOpaque ? 1 : MaximumLayers); ++layer)
  {
    found = this->DrawLayer(window, view, layer);
    this->BlendLayer(window);
  }
  if (shading.IsLit())
  {
    shading.Deactivate();
  }
  buffers.Deactivate();
  view.OpaqueDepth->Deactivate();
  return true;
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
  this->Layers.ReleaseGraphicsResources(window);
  this->Blend.ReleaseGraphicsResources();
  this->Depth.ReleaseGraphicsResources();
  this->Surfaces = nullptr;
}
