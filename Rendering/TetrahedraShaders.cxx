#include "TetrahedraShaders.h"

#include "RayUniforms.h"
#include "cpAverageSegment.h"
#include "cpCellVertex.h"
#include "cpDepthLayer.h"
#include "cpFootprint.h"
#include "cpHull.h"
#include "cpIntegral.h"
#include "cpLayerSearchFragment.h"
#include "cpNearClip.h"
#include "cpSegment.h"
#include "cpTableSegment.h"
#include "cpTetrahedraFragment.h"
#include "cpTetrahedraGeometry.h"
#include "cpTetrahedronClip.h"
#include "cpTransferFunction.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

#include <string>

namespace
{
using TetrahedraShaders::Task;

std::string GeometrySource()
{
  std::string source = cpTetrahedraGeometry;
  vtkShaderProgram::Substitute(source, "//VTK::Footprint::Dec", cpFootprint);
  vtkShaderProgram::Substitute(source, "//VTK::NearClip::Dec", cpNearClip);
  vtkShaderProgram::Substitute(source, "//VTK::Hull::Dec", cpHull);
  return source;
}

const char* SegmentSource(SegmentIntegration integration)
{
  switch (integration)
  {
    case SegmentIntegration::Table:
      return cpTableSegment;
    case SegmentIntegration::Average:
      return cpAverageSegment;
    default:
      return cpSegment;
  }
}

std::string FragmentSource(Task task, SegmentIntegration integration)
{
  std::string source = task == Task::LayerSearch ? cpLayerSearchFragment : cpTetrahedraFragment;
  const bool isLayer = task == Task::Layer;
  auto put = [&source](const char* tag, const char* code)
  { vtkShaderProgram::Substitute(source, tag, code); };
  put("//VTK::Clip::Dec", cpTetrahedronClip);
  put("//VTK::TransferFunction::Dec", cpTransferFunction);
  put("//VTK::Integral::Dec", integration == SegmentIntegration::Exact ? cpIntegral : "");
  put("//VTK::Segment::Dec", SegmentSource(integration));
  put("//VTK::Layer::Dec", isLayer ? cpDepthLayer : "");
  put("//VTK::Layer::Impl", isLayer ? "if (!isInLayer(c.depth.x))\n    discard;" : "");
  return source;
}
}

namespace TetrahedraShaders
{
//------------------------------------------------------------------------------
vtkShaderProgram* ReadyProgram(
  vtkOpenGLRenderWindow* window, const RasterView& view, Task task, SegmentIntegration integration)
{
  static const std::string geometry = GeometrySource();
  const std::string fragment = RayUniforms::WithRay(FragmentSource(task, integration), view);
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(cpCellVertex, fragment.c_str(), geometry.c_str());
  return program && program->GetCompiled() ? program : nullptr;
}
}
