#include "ConvexCellShaders.h"

#include "cpCellBounds.h"
#include "cpCellFootprint.h"
#include "cpCellGeometry.h"
#include "cpCellScalars.h"
#include "cpCellVertex.h"
#include "cpConvexCell.h"
#include "cpEmission.h"
#include "cpFaceScalar.h"
#include "cpOctagon.h"
#include "cpRay.h"
#include "cpScreenPoint.h"
#include "cpSegment.h"
#include "cpTransferFunction.h"
#include "cpValley.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

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
}

namespace ConvexCellShaders
{
//------------------------------------------------------------------------------
std::string FragmentSource(const char* main)
{
  std::string source = main;
  vtkShaderProgram::Substitute(source, "//VTK::Ray::Dec", cpRay);
  vtkShaderProgram::Substitute(source, "//VTK::ConvexCell::Dec", cpConvexCell);
  vtkShaderProgram::Substitute(source, "//VTK::FaceScalar::Dec", cpFaceScalar);
  vtkShaderProgram::Substitute(source, "//VTK::Valley::Dec", cpValley);
  vtkShaderProgram::Substitute(source, "//VTK::CellScalars::Dec", cpCellScalars);
  vtkShaderProgram::Substitute(source, "//VTK::TransferFunction::Dec", cpTransferFunction);
  vtkShaderProgram::Substitute(source, "//VTK::Integral::Dec", cpEmission);
  vtkShaderProgram::Substitute(source, "//VTK::Segment::Dec", cpSegment);
  return source;
}

//------------------------------------------------------------------------------
vtkShaderProgram* ReadyProgram(vtkOpenGLRenderWindow* window, const std::string& fragment)
{
  static const std::string geometry = GeometrySource();
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(cpCellVertex, fragment.c_str(), geometry.c_str());
  return program && program->GetCompiled() ? program : nullptr;
}
}
