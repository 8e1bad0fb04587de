#include "MaximumRaster.h"

#include "ConvexCellBuffers.h"
#include "ConvexCellShaders.h"
#include "RasterView.h"
#include "RayUniforms.h"
#include "VTKVersions.h"
#include "cpCellVertex.h"
#include "cpExtremumCellFragment.h"
#include "cpFaceFragment.h"
#include "cpFaceGeometry.h"
#include "cpFootprint.h"
#include "cpHull.h"
#include "cpNearClip.h"
#include "cpRay.h"
#include "cpTriangle.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace
{
std::string FaceGeometrySource()
{
  std::string source = cpFaceGeometry;
  vtkShaderProgram::Substitute(source, "//VTK::Footprint::Dec", cpFootprint);
  vtkShaderProgram::Substitute(source, "//VTK::NearClip::Dec", cpNearClip);
  vtkShaderProgram::Substitute(source, "//VTK::Hull::Dec", cpHull);
  return source;
}

std::string FaceFragmentSource()
{
  std::string source = cpFaceFragment;
  vtkShaderProgram::Substitute(source, "//VTK::Ray::Dec", cpRay);
  vtkShaderProgram::Substitute(source, "//VTK::Triangle::Dec", cpTriangle);
  return source;
}

vtkShaderProgram* ReadyFaceProgram(vtkOpenGLRenderWindow* window)
{
  static const std::string geometry = FaceGeometrySource();
  static const std::string fragment = FaceFragmentSource();
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(cpCellVertex, fragment.c_str(), geometry.c_str());
  return program && program->GetCompiled() ? program : nullptr;
}
}

//------------------------------------------------------------------------------
bool MaximumRaster::UploadFaceScalars(
  vtkOpenGLRenderWindow* window, const std::vector<float>& scalars)
{
  this->HasFaceScalars = !scalars.empty();
  const bool good = scalars.empty() || this->FaceScalars.Upload(window, scalars, 4);
  this->Failure = good ? this->Failure : this->FaceScalars.GetFailure();
  return good;
}

//------------------------------------------------------------------------------
void MaximumRaster::DrawFaces(
  vtkShaderProgram* program, const RasterView& view, ConvexCellBuffers& buffers)
{
  RayUniforms::Set(program, view);
  buffers.Activate(program);
  if (this->HasFaceScalars)
  {
    this->FaceScalars.Activate(program, "pieceScalars");
  }
  this->Faces.Draw();
  if (this->HasFaceScalars)
  {
    this->FaceScalars.Deactivate();
  }
  buffers.Deactivate();
}

//------------------------------------------------------------------------------
void MaximumRaster::DrawCells(vtkShaderProgram* program, const RasterView& view,
  ConvexCellBuffers& buffers, NumberedPoints& cells)
{
  RayUniforms::Set(program, view);
  buffers.Activate(program);
  cells.Draw();
  buffers.Deactivate();
}

//------------------------------------------------------------------------------
bool MaximumRaster::FindExtrema(
  vtkOpenGLRenderWindow* window, const RasterView& view, ConvexCellBuffers& buffers, bool findLeast)
{
  static const std::string cellFragment = ConvexCellShaders::FragmentSource(cpExtremumCellFragment);
  vtkShaderProgram* faces = ReadyFaceProgram(window);
  if (!faces)
  {
    return false;
  }
  faces->SetUniformi("findLeast", findLeast ? 1 : 0);
  this->DrawFaces(faces, view, buffers);
  const bool hasOpaque = this->Target.HasOpaque(window, view.OpaqueDepth);
  vtkShaderProgram* cells = ConvexCellShaders::ReadyProgram(window, cellFragment);
  if (!cells)
  {
    return false;
  }
  cells->SetUniformi("findLeast", findLeast ? 1 : 0);
  cells->SetUniformi("onlyBeforeOpaque", 0);
  this->DrawCells(cells, view, buffers, this->Cut);
  if (hasOpaque)
  {
    cells->SetUniformi("onlyBeforeOpaque", 1);
    this->DrawCells(cells, view, buffers, this->Cells);
  }
  return true;
}

//------------------------------------------------------------------------------
bool MaximumRaster::Draw(
  vtkOpenGLRenderWindow* window, const RasterView& view, ConvexCellBuffers& buffers, bool findLeast)
{
  if (!this->Target.Begin(window, view.Width, view.Height, findLeast))
  {
    this->Failure = "the driver cannot render to single floats";
    return false;
  }
  view.OpaqueDepth->Activate();
  const bool found = this->FindExtrema(window, view, buffers, findLeast);
  view.OpaqueDepth->Deactivate();
  this->Target.End(window);
  vtkShaderProgram* colours = found ? this->Target.ReadyColourProgram(window) : nullptr;
  if (!colours)
  {
    this->Failure = "the projection's shaders did not compile";
    return false;
  }
  buffers.Activate(colours);
  this->Target.DrawColours(colours);
  buffers.Deactivate();
  return true;
}

//------------------------------------------------------------------------------
void MaximumRaster::ReleaseGraphicsResources(vtkWindow* window)
{
  this->FaceScalars.ReleaseGraphicsResources(window);
  this->Faces.ReleaseGraphicsResources();
  this->Cells.ReleaseGraphicsResources();
  this->Cut.ReleaseGraphicsResources();
  this->Target.ReleaseGraphicsResources(window);
}
