#include "TetrahedraShaders.h"

#include "RayUniforms.h"
#include "cpAverageSegment.h"
#include "cpCellVertex.h"
#include "cpCornerColours.h"
#include "cpDepthLayer.h"
#include "cpDirectColour.h"
#include "cpFootprint.h"
#include "cpGradientOpacity.h"
#include "cpGradients.h"
#include "cpHull.h"
#include "cpIntegral.h"
#include "cpLayerSearchFragment.h"
#include "cpLightSides.h"
#include "cpLightTurns.h"
#include "cpLighting.h"
#include "cpLitTable.h"
#include "cpNearClip.h"
#include "cpNoGradientOpacity.h"
#include "cpNoLighting.h"
#include "cpOpticalDepth.h"
#include "cpOwnColour.h"
#include "cpScalarColour.h"
#include "cpSegment.h"
#include "cpShadedAverage.h"
#include "cpShadedIntegral.h"
#include "cpShadedPiece.h"
#include "cpShadedTable.h"
#include "cpTableLookUp.h"
#include "cpTableSegment.h"
#include "cpTetrahedraFragment.h"
#include "cpTetrahedraGeometry.h"
#include "cpTetrahedronClip.h"
#include "cpTransferFunction.h"
#include "cpUnlitTable.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

#include <string>

namespace
{
using TetrahedraShaders::Task;
using TetrahedraShaders::Variant;

std::string GeometrySource()
{
  std::string source = cpTetrahedraGeometry;
  vtkShaderProgram::Substitute(source, "//VTK::Footprint::Dec", cpFootprint);
  vtkShaderProgram::Substitute(source, "//VTK::NearClip::Dec", cpNearClip);
  vtkShaderProgram::Substitute(source, "//VTK::Hull::Dec", cpHull);
  return source;
}

std::string TableSource(const Variant& variant)
{
  std::string source = cpTableLookUp;
  source += !variant.IsShaded() ? "" : variant.IsLit ? cpLitTable : cpUnlitTable;
  return source + (variant.IsShaded() ? cpShadedTable : cpTableSegment);
}

std::string SegmentSource(const Variant& variant)
{
  switch (variant.Integration)
  {
    case SegmentIntegration::Table:
      return TableSource(variant);
    case SegmentIntegration::Average:
      return variant.IsShaded() ? cpShadedAverage : cpAverageSegment;
    default:
      return cpSegment;
  }
}

std::string ShadingSource(const Variant& variant)
{
  std::string source = cpGradients;
  source += variant.IsLit ? std::string(cpLighting) + cpLightTurns + cpLightSides : cpNoLighting;
  source += variant.HasGradientOpacity ? cpGradientOpacity : cpNoGradientOpacity;
  source += variant.HasColors() ? cpCornerColours : cpOwnColour;
  source += !variant.HasColors()                            ? ""
            : variant.Colors == DependentColors::Direct ? cpDirectColour
                                                            : cpScalarColour;
  return source;
}

std::string IntegralSource(const Variant& variant)
{
  std::string source = cpOpticalDepth;
  if (variant.Integration == SegmentIntegration::Exact)
  {
    source += variant.IsShaded() ? std::string(cpShadedIntegral) + cpShadedPiece : cpIntegral;
  }
  return source;
}

std::string FragmentSource(Task task, const Variant& variant)
{
  std::string source = task == Task::LayerSearch ? cpLayerSearchFragment : cpTetrahedraFragment;
  const bool isLayer = task == Task::Layer;
  const bool isShaded = variant.IsShaded();
  const std::string begin = std::string("beginShading(cell, c, base);") +
                            (variant.HasColors() ? "\n  beginColours(cell, c);" : "");
  auto put = [&source](const char* tag, const std::string& code)
  { vtkShaderProgram::Substitute(source, tag, code); };
  put("//VTK::Clip::Dec", cpTetrahedronClip);
  put("//VTK::TransferFunction::Dec", cpTransferFunction);
  put("//VTK::Shading::Dec", isShaded ? ShadingSource(variant) : "");
  put("//VTK::Shading::Impl", isShaded ? begin : "");
  put("//VTK::Integral::Dec", IntegralSource(variant));
  put("//VTK::Segment::Dec", SegmentSource(variant));
  put("//VTK::Layer::Dec", isLayer ? cpDepthLayer : "");
  put("//VTK::Layer::Impl", isLayer ? "if (!isInLayer(c.depth.x))\n    discard;" : "");
  return source;
}
}

namespace TetrahedraShaders
{
//------------------------------------------------------------------------------
vtkShaderProgram* ReadyProgram(
  vtkOpenGLRenderWindow* window, const RasterView& view, Task task, const Variant& variant)
{
  static const std::string geometry = GeometrySource();
  const std::string fragment = RayUniforms::WithRay(FragmentSource(task, variant), view);
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(cpCellVertex, fragment.c_str(), geometry.c_str());
  return program && program->GetCompiled() ? program : nullptr;
}
}
