#include "ShellShaders.h"

#include "RayUniforms.h"
#include "cpElement.h"
#include "cpElementGeometry.h"
#include "cpElementInverse.h"
#include "cpElementPassage.h"
#include "cpElementVertex.h"
#include "cpFootprint.h"
#include "cpHull.h"
#include "cpIntegral.h"
#include "cpNearClip.h"
#include "cpOpticalDepth.h"
#include "cpSegment.h"
#include "cpShell.h"
#include "cpShellOpenFragment.h"
#include "cpShellPointBlend.h"
#include "cpShellPointFragment.h"
#include "cpShellSamples.h"
#include "cpShellSlabBlend.h"
#include "cpShellSlabFragment.h"
#include "cpSlabEnd.h"
#include "cpSliceDepths.h"
#include "cpSlices.h"
#include "cpTransferFunction.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

namespace
{
using ShellShaders::Variant;

std::string GeometrySource()
{
  std::string source = cpElementGeometry;
  vtkShaderProgram::Substitute(source, "//VTK::Footprint::Dec", cpFootprint);
  vtkShaderProgram::Substitute(source, "//VTK::NearClip::Dec", cpNearClip);
  vtkShaderProgram::Substitute(source, "//VTK::Hull::Dec", cpHull);
  vtkShaderProgram::Substitute(source, "//VTK::Inverse::Dec", cpElementInverse);
  return source;
}

std::string WithTargets(const char* main, const Variant& variant)
{
  std::string source = main;
  vtkShaderProgram::Substitute(
    source, "NUMBER_OF_TARGETS", std::to_string(variant.NumberOfTargets));
  return source;
}

std::string FragmentSource(const Variant& variant)
{
  std::string source =
    WithTargets(variant.IsPreIntegrated ? cpShellSlabFragment : cpShellPointFragment, variant);
  vtkShaderProgram::Substitute(source, "//VTK::Element::Dec", cpElement);
  vtkShaderProgram::Substitute(source, "//VTK::Passage::Dec", cpElementPassage);
  vtkShaderProgram::Substitute(source, "//VTK::Samples::Dec", cpShellSamples);
  vtkShaderProgram::Substitute(source, "//VTK::Shell::Dec", cpShell);
  vtkShaderProgram::Substitute(source, "//VTK::SliceDepths::Dec", cpSliceDepths);
  vtkShaderProgram::Substitute(source, "//VTK::SlabEnd::Dec", cpSlabEnd);
  return source;
}
}

namespace ShellShaders
{
//------------------------------------------------------------------------------
vtkShaderProgram* ReadyElements(
  vtkOpenGLRenderWindow* window, const RasterView& view, const Variant& variant)
{
  static const std::string geometry = GeometrySource();
  const std::string fragment = RayUniforms::WithRay(FragmentSource(variant), view);
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    cpElementVertex, fragment.c_str(), geometry.c_str());
  return program && program->GetCompiled() ? program : nullptr;
}

//------------------------------------------------------------------------------
std::string BlendSource(const Variant& variant)
{
  std::string source =
    WithTargets(variant.IsPreIntegrated ? cpShellSlabBlend : cpShellPointBlend, variant);
  auto put = [&source](const char* tag, const char* code)
  { vtkShaderProgram::Substitute(source, tag, code); };
  put("//VTK::Slices::Dec", cpSlices);
  put("//VTK::SlabEnd::Dec", cpSlabEnd);
  put("//VTK::TransferFunction::Dec", cpTransferFunction);
  static const std::string integral = std::string(cpOpticalDepth) + cpIntegral;
  put("//VTK::Integral::Dec", integral.c_str());
  put("//VTK::Segment::Dec", cpSegment);
  return source;
}

//------------------------------------------------------------------------------
const std::string& OpenSource()
{
  static const std::string source = cpShellOpenFragment;
  return source;
}
}
