#include "ThreePassRaster.h"

#include "ConvexCellBuffers.h"
#include "CutCells.h"
#include "CutSurfaces.h"
#include "PreparedPolyhedra.h"
#include "PreparedVolume.h"
#include "RasterView.h"
#include "RayUniforms.h"
#include "VTKVersions.h"
#include "ViewRays.h"
#include "cpPassTriangle.h"
#include "cpRayWeights.h"
#include "cpThreePassFragment.h"
#include "cpThreePassVertex.h"
#include "cpTransferFunction.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include CELLPROJECTION_OPENGL_HEADER

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <iterator>

namespace
{
// Behind the near plane by this, in mesh coordinates: GL has nothing left to cut.
constexpr float Behind = 2e-6f;

vtkShaderProgram* ReadyProgram(vtkOpenGLRenderWindow* window, const RasterView& view)
{
  std::string fragment = RayUniforms::WithRay(cpThreePassFragment, view);
  std::string vertex = cpThreePassVertex;
  vtkShaderProgram::Substitute(fragment, "//VTK::TransferFunction::Dec", cpTransferFunction);
  vtkShaderProgram::Substitute(fragment, "//VTK::RayWeights::Dec", cpRayWeights);
  vtkShaderProgram::Substitute(fragment, "//VTK::PassTriangle::Dec", cpPassTriangle);
  vtkShaderProgram::Substitute(vertex, "//VTK::PassTriangle::Dec", cpPassTriangle);
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
  return program && program->GetCompiled() ? program : nullptr;
}
}

//------------------------------------------------------------------------------
bool ThreePassRaster::Check(const TextureBuffer& buffer, bool uploaded)
{
  this->Failure = uploaded ? this->Failure : buffer.GetFailure();
  return uploaded;
}

//------------------------------------------------------------------------------
bool ThreePassRaster::Update(vtkOpenGLRenderWindow* window, const PreparedPolyhedra& polyhedra)
{
  if (this->WholeTime < polyhedra.SelectionTime)
  {
    const ConvexCellBuffers& buffers = polyhedra.Buffers;
    this->Whole.Build(
      buffers.GetCells(), buffers.GetPieces(), buffers.GetPlanes(), polyhedra.Selection);
    this->WholeTime.Modified();
  }
  if (this->WholeUploaded < this->WholeTime && !this->Whole.Triangles.empty())
  {
    const std::vector<PassTriangles::Triangle>& triangles = this->Whole.Triangles;
    if (!this->Check(this->WholeTriangles,
          this->WholeTriangles.Upload(window, triangles[0].data(), 4 * triangles.size(), 4)))
    {
      return false;
    }
    this->WholeUploaded.Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
bool ThreePassRaster::Cut(vtkOpenGLRenderWindow* window, const RasterView& view,
  const PreparedVolume& prepared, const PreparedPolyhedra& polyhedra)
{
  const ConvexCellBuffers& buffers = polyhedra.Buffers;
  const std::vector<float>& points = prepared.Coordinates.Points;
  const ConvexCellFaces::Rows& corners = buffers.GetCells().Corners;
  glm::vec4 nearPlane = CutCells::Planes(*view.Rays, {})[0];
  const std::vector<unsigned int> cut =
    CutCells::Find(points, corners, polyhedra.Selection, { nearPlane });
  this->WholeRanges = this->FindWholeCells(
    cut, CutCells::FindBehind(points, corners, polyhedra.Selection, nearPlane));
  this->CutRanges = Ranges();
  nearPlane.w -= Behind;
  CutSurfaces surfaces;
  surfaces.Build(cut, nearPlane, this->Whole, buffers.GetPieces(), prepared);
  if (surfaces.Vertices.empty())
  {
    // The shader names them all the same.
    surfaces.Vertices.emplace_back();
  }
  else
  {
    const std::vector<PassTriangles::Triangle>& triangles = surfaces.Passes.Triangles;
    this->CutRanges = { { 0 }, { 3 * static_cast<int>(triangles.size()) } };
    if (!this->Check(this->CutTriangles,
          this->CutTriangles.Upload(window, triangles[0].data(), 4 * triangles.size(), 4)))
    {
      return false;
    }
  }
  const float* vertices = glm::value_ptr(surfaces.Vertices[0][0]);
  return this->Check(this->CutVertices,
    this->CutVertices.Upload(window, vertices, 12 * surfaces.Vertices.size(), 4));
}

//------------------------------------------------------------------------------
ThreePassRaster::Ranges ThreePassRaster::FindWholeCells(
  const std::vector<unsigned int>& cut, const std::vector<unsigned int>& behind) const
{
  // GL does not clip at the near plane here: around the eye a cell behind it would lose its front.
  std::vector<unsigned int> others;
  std::merge(cut.begin(), cut.end(), behind.begin(), behind.end(), std::back_inserter(others));
  Ranges ranges;
  int first = 0;
  auto append = [&](int end)
  {
    if (end > first)
    {
      ranges.First.push_back(3 * first);
      ranges.Count.push_back(3 * (end - first));
    }
  };
  for (const unsigned int cell : others)
  {
    const int at = this->Whole.Find(static_cast<int>(cell));
    if (at >= 0)
    {
      append(this->Whole.Offsets[at]);
      first = this->Whole.Offsets[at + 1];
    }
  }
  append(this->Whole.Offsets.back());
  return ranges;
}

//------------------------------------------------------------------------------
void ThreePassRaster::SetUniforms(vtkShaderProgram* program, const RasterView& view)
{
  RayUniforms::Set(program, view);
  const glm::dvec4 viewZ = glm::row(view.Rays->MeshToView, 2);
  const glm::vec4 depth(-viewZ - glm::dvec4(0.0, 0.0, 0.0, view.Rays->Reference));
  program->SetUniform4f("meshToDepth", glm::value_ptr(depth));
  // The camera's own transform may mirror as well. Eye coordinates are right-handed, clip ones
  // left-.
  const bool isMirrored = glm::determinant(glm::dmat4(view.Rays->MeshToClip)) > 0.0;
  program->SetUniformi("isMirrored", isMirrored ? 1 : 0);
}

//------------------------------------------------------------------------------
void ThreePassRaster::DrawRanges(
  vtkShaderProgram* program, TextureBuffer& triangles, const Ranges& ranges)
{
  if (ranges.First.empty())
  {
    return;
  }
  triangles.Activate(program, "passTriangles");
  this->VertexArray.Bind();
  glMultiDrawArrays(
    GL_TRIANGLES, ranges.First.data(), ranges.Count.data(), static_cast<int>(ranges.First.size()));
  EmptyVertexArray::Release();
  triangles.Deactivate();
}

//------------------------------------------------------------------------------
bool ThreePassRaster::Draw(vtkOpenGLRenderWindow* window, const RasterView& view,
  const PreparedVolume& prepared, PreparedPolyhedra& polyhedra)
{
  if (!this->Update(window, polyhedra) || !this->Cut(window, view, prepared, polyhedra))
  {
    return false;
  }
  vtkShaderProgram* program = ReadyProgram(window, view);
  if (!program)
  {
    this->Failure = "the projection's shaders did not compile";
    return false;
  }
  view.OpaqueDepth->Activate();
  SetUniforms(program, view);
  polyhedra.Buffers.Activate(program);
  window->GetState()->vtkglBlendFuncSeparate(GL_DST_ALPHA, GL_ONE, GL_ONE, GL_ONE);
  this->CutVertices.Activate(program, "cutVertices");
  // A back face beyond the far plane ends its cell all the same: there the fragment does.
  glEnable(GL_DEPTH_CLAMP);
  this->DrawRanges(program, this->WholeTriangles, this->WholeRanges);
  this->DrawRanges(program, this->CutTriangles, this->CutRanges);
  glDisable(GL_DEPTH_CLAMP);
  this->CutVertices.Deactivate();
  polyhedra.Buffers.Deactivate();
  view.OpaqueDepth->Deactivate();
  this->ClearAlpha(window);
  return true;
}

//------------------------------------------------------------------------------
void ThreePassRaster::ClearAlpha(vtkOpenGLRenderWindow* window)
{
  // What rounding left of lengths that were added and taken back.
  const vtkOpenGLState::ScopedglColorMask mask(window->GetState());
  window->GetState()->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 0, nothing);
}

//------------------------------------------------------------------------------
void ThreePassRaster::ReleaseGraphicsResources(vtkWindow* window)
{
  this->WholeTriangles.ReleaseGraphicsResources(window);
  this->CutTriangles.ReleaseGraphicsResources(window);
  this->CutVertices.ReleaseGraphicsResources(window);
  this->VertexArray.ReleaseGraphicsResources();
  this->WholeUploaded = vtkTimeStamp();
}
