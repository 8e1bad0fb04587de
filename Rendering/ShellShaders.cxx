#include "ShellShaders.h"

#include "ElementShaders.h"
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
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

namespace
{
using ShellShaders::Variant;

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
  vtkShaderProgram::Substitute(source, "//VTK::Samples::Dec", cpShellSamples);
  vtkShaderProgram::Substitute(source, "//VTK::Shell::Dec", cpShell);
  vtkShaderProgram::Substitute(source, "//VTK::SliceDepths::Dec", cpSliceDepths);
  vtkShaderProgram::Substitute(source, "//VTK::SlabEnd::Dec", cpSlabEnd);
  return ElementShaders::WithElement(source, variant.IsTextured);
}
}

namespace ShellShaders
{
//------------------------------------------------------------------------------
vtkShaderProgram* ReadyElements(
  vtkOpenGLRenderWindow* window, const RasterView& view, const Variant& variant)
{
  return ElementShaders::ReadyProgram(window, view, FragmentSource(variant), variant.IsTextured);
}

//------------------------------------------------------------------------------
std::string BlendSource(const Variant& variant)
{
  std::string source =
    WithTargets(variant.IsPreIntegrated ? cpShellSlabBlend : cpShellPointBlend, variant);
  vtkShaderProgram::Substitute(source, "//VTK::Slices::Dec", cpSlices);
  vtkShaderProgram::Substitute(source, "//VTK::SlabEnd::Dec", cpSlabEnd);
  return ElementShaders::WithElement(source);
}

//------------------------------------------------------------------------------
const std::string& OpenSource()
{
  static const std::string source = cpShellOpenFragment;
  return source;
}
}
