#include "ElementShaders.h"

#include "RayUniforms.h"
#include "cpElement.h"
#include "cpElementCrossing.h"
#include "cpElementGeometry.h"
#include "cpElementInverse.h"
#include "cpElementPassage.h"
#include "cpElementVertex.h"
#include "cpFootprint.h"
#include "cpHull.h"
#include "cpIntegral.h"
#include "cpNearClip.h"
#include "cpOpticalDepth.h"
#include "cpPointScalar.h"
#include "cpSegment.h"
#include "cpTextureScalar.h"
#include "cpTransferFunction.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

namespace
{
std::string GeometrySource(bool withIds)
{
  std::string source = cpElementGeometry;
  auto put = [&source](const char* tag, const char* code)
  { vtkShaderProgram::Substitute(source, tag, code); };
  put("//VTK::Footprint::Dec", cpFootprint);
  put("//VTK::NearClip::Dec", cpNearClip);
  put("//VTK::Hull::Dec", cpHull);
  put("//VTK::Inverse::Dec", cpElementInverse);
  put("//VTK::Attributes::Dec", withIds ? "flat out ivec4 elementIds;" : "");
  put("//VTK::Attributes::Impl", withIds ? "elementIds = ids;" : "");
  return source;
}
}

namespace ElementShaders
{
//------------------------------------------------------------------------------
std::string WithElement(const std::string& fragment, bool isTextured)
{
  std::string source = fragment;
  auto put = [&source](const char* tag, const std::string& code)
  { vtkShaderProgram::Substitute(source, tag, code); };
  put("//VTK::Element::Dec", cpElement);
  put("//VTK::Scalar::Dec", isTextured ? cpTextureScalar : cpPointScalar);
  put("//VTK::Passage::Dec", cpElementPassage);
  put("//VTK::Crossing::Dec", cpElementCrossing);
  put("//VTK::TransferFunction::Dec", cpTransferFunction);
  put("//VTK::Integral::Dec", std::string(cpOpticalDepth) + cpIntegral);
  put("//VTK::Segment::Dec", cpSegment);
  return source;
}

//------------------------------------------------------------------------------
vtkShaderProgram* ReadyProgram(vtkOpenGLRenderWindow* window, const RasterView& view,
  const std::string& fragment, bool withIds)
{
  static const std::string geometry[2] = { GeometrySource(false), GeometrySource(true) };
  const std::string source = RayUniforms::WithRay(fragment, view);
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    cpElementVertex, source.c_str(), geometry[withIds ? 1 : 0].c_str());
  return program && program->GetCompiled() ? program : nullptr;
}
}
