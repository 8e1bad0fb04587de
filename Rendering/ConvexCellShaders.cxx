#include "ConvexCellShaders.h"

#include "RayUniforms.h"
#include "cpCellBounds.h"
#include "cpCellFootprint.h"
#include "cpCellGeometry.h"
#include "cpCellScalars.h"
#include "cpCellVertex.h"
#include "cpConvexCell.h"
#include "cpEmission.h"
#include "cpFaceScalar.h"
#include "cpLongFace.h"
#include "cpMeanEmission.h"
#include "cpOctagon.h"
#include "cpScreenPoint.h"
#include "cpSegment.h"
#include "cpTransferFunction.h"
#include "cpValley.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

#include <string>

namespace
{
std::string GeometrySource()
{
  std::string source = cpCellGeometry;
  vtkShaderProgram::Substitute(source, "//VTK::Footprint::Dec", cpCellFootprint);
  vtkShaderProgram::Substitute(source, "//VTK::Bounds::Dec", cpCellBounds);
  vtkShaderProgram::Substitute(source, "//VTK::ScreenPoint::Dec", cpScreenPoint);
  vtkShaderProgram::Substitute(source, "//VTK::Octagon::Dec", cpOctagon);
  return source;
}

std::string FragmentSource(const char* main, const ConvexCellShaders::Variant& variant)
{
  std::string source = main;
  auto put = [&source](const char* tag, const char* code)
  { vtkShaderProgram::Substitute(source, tag, code); };
  put("//VTK::ConvexCell::Dec", cpConvexCell);
  put("//VTK::Valley::Dec", cpValley);
  put("//VTK::CellScalars::Dec", cpCellScalars);
  put("//VTK::FaceScalar::Dec", cpFaceScalar);
  put("//VTK::LongFace::Dec", variant.HasLongFaces ? cpLongFace : "");
  put("//VTK::LongFace::Impl",
    variant.HasLongFaces ? "piece = pieceAround(piece, center, point);" : "");
  put("//VTK::TransferFunction::Dec", cpTransferFunction);
  put("//VTK::Integral::Dec", cpEmission);
  put("//VTK::Segment::Dec", variant.AverageEmission ? cpMeanEmission : cpSegment);
  return source;
}
}

namespace ConvexCellShaders
{
//------------------------------------------------------------------------------
vtkShaderProgram* ReadyProgram(
  vtkOpenGLRenderWindow* window, const char* main, const RasterView& view, const Variant& variant)
{
  static const std::string geometry = GeometrySource();
  const std::string fragment = RayUniforms::WithRay(FragmentSource(main, variant), view);
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(cpCellVertex, fragment.c_str(), geometry.c_str());
  return program && program->GetCompiled() ? program : nullptr;
}
}
