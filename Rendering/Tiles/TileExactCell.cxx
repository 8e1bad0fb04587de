#include "TileExactCell.h"

#include "TileMesh.h"
#include "TileView.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace
{
// Along no face of a tidy mesh.
const glm::dvec3 NudgeDirection(0.6180340, 0.4142136, 0.2360680);
// Of the sum of a plane's terms: what is below is rounding.
constexpr double Rounding = 4e-15;

double ScalarOf(const TileMesh& mesh, int cell, int corner)
{
  if (!mesh.CellScalars.empty())
  {
    return mesh.CellScalars[cell];
  }
  const auto id =
    static_cast<std::size_t>(mesh.Corners[4 * static_cast<std::size_t>(cell) + corner]);
  return mesh.Points[4 * id + 3];
}

// The magnitude of the terms of a product of a matrix row and a vector.
double TermsOf(const glm::dmat4& matrix, int row, const glm::dvec4& v)
{
  return std::abs(matrix[0][row] * v.x) + std::abs(matrix[1][row] * v.y) +
         std::abs(matrix[2][row] * v.z) + std::abs(matrix[3][row] * v.w);
}

// Bounds of points on the screen.
struct ScreenBounds
{
  double Low[2] = { 2e6, 2e6 };
  double High[2] = { -2e6, -2e6 };

  void Add(const glm::dvec4& screen)
  {
    const double inverse = 1.0 / screen.w;
    for (int i = 0; i < 2; ++i)
    {
      const double at = std::min(std::max(screen[i] * inverse, -1e6), 1e6);
      this->Low[i] = std::min(this->Low[i], at);
      this->High[i] = std::max(this->High[i], at);
    }
  }
};

// Where the edges from corner i to those behind it cross the near plane.
void AddCuts(const glm::dvec4 (&corners)[4], const double (&before)[4], int i, ScreenBounds& bounds)
{
  for (int j = i + 1; j < 4; ++j)
  {
    if ((before[i] > 0.0) == (before[j] > 0.0))
    {
      continue;
    }
    const glm::dvec4 cut = glm::mix(corners[i], corners[j], before[i] / (before[i] - before[j]));
    if (cut.w > 0.0)
    {
      bounds.Add(cut);
    }
  }
}
}

//------------------------------------------------------------------------------
TileExactCell::TileExactCell(const TileMesh& mesh, const TileView& view, int cell)
{
  Points points;
  for (int i = 0; i < 4; ++i)
  {
    const auto id = static_cast<std::size_t>(mesh.Corners[4 * static_cast<std::size_t>(cell) + i]);
    points[i] = glm::dvec3(glm::make_vec3(&mesh.Points[4 * id]));
  }
  this->SetPlanes(points, mesh.Orientations[cell] > 0, view);
  const double scalars[4] = { ScalarOf(mesh, cell, 0), ScalarOf(mesh, cell, 1), ScalarOf(mesh, cell, 2),
    ScalarOf(mesh, cell, 3) };
  this->SetScalar(points, scalars, view);
  this->SetBox(points, view);
}

//------------------------------------------------------------------------------
void TileExactCell::SetPlanes(const Points& points, bool positive, const TileView& view)
{
  const double farthest = std::max(view.Width, view.Height);
  for (int f = 0; f < 4; ++f)
  {
    const int* side = TileMesh::FaceCorners[f];
    const glm::dvec3 a = points[side[0]];
    // Of any length: nothing depends on it.
    const glm::dvec3 normal = glm::cross(points[side[1]] - a, points[side[2]] - a);
    const glm::dvec4 inMesh(normal, -glm::dot(normal, a));
    const glm::dvec4 screen = view.PlaneToScreen * inMesh;
    Plane& plane = this->Planes[f];
    plane.A = screen.x;
    plane.B = screen.y;
    plane.E = screen.w;
    const bool edgeOn = std::abs(screen.z) <= Rounding * TermsOf(view.PlaneToScreen, 2, inMesh);
    // Seen edge-on a plane is left anywhere but in itself at the end of the world.
    plane.C = edgeOn ? 1e-200 : screen.z;
    plane.Inverse = -1.0 / plane.C;
    plane.Tolerance = edgeOn ? Rounding * (farthest * (std::abs(screen.x) + std::abs(screen.y)) +
                                            TermsOf(view.PlaneToScreen, 3, inMesh))
                             : 0.0;
    plane.Nudge = glm::dot(normal, NudgeDirection) > 0.0 ? 1e-100 : -1e-100;
    plane.IsEntry = (plane.C < 0.0) == (TileMesh::IsInward(f) == positive);
  }
}

//------------------------------------------------------------------------------
void TileExactCell::SetScalar(const Points& points, const double (&scalars)[4], const TileView& view)
{
  const glm::dvec3 edges[3] = { points[1] - points[0], points[2] - points[0], points[3] - points[0] };
  const glm::dvec3 normals[3] = { glm::cross(edges[1], edges[2]), glm::cross(edges[2], edges[0]),
    glm::cross(edges[0], edges[1]) };
  const double first = scalars[0];
  const double inverse = 1.0 / glm::dot(edges[0], normals[0]);
  glm::dvec3 gradient(0.0);
  for (int i = 0; i < 3; ++i)
  {
    gradient += (scalars[i + 1] - first) * inverse * normals[i];
  }
  // The first scalar apart: differences keep their digits.
  const glm::dvec4 linear = view.PlaneToScreen * glm::dvec4(gradient, -glm::dot(gradient, points[0]));
  this->ScalarA = linear.x;
  this->ScalarB = linear.y;
  this->ScalarC = linear.z + first * view.WeightScale;
  this->ScalarE = linear.w + first * view.WeightOffset;
}

//------------------------------------------------------------------------------
void TileExactCell::SetBox(const Points& points, const TileView& view)
{
  // Before the near plane: h * (NearU - u) >= 0 for points before the eye.
  glm::dvec4 corners[4];
  double before[4];
  int inside = 0;
  ScreenBounds bounds;
  for (int i = 0; i < 4; ++i)
  {
    corners[i] = view.MeshToScreen * glm::dvec4(points[i], 1.0);
    before[i] = corners[i].w * view.NearU - corners[i].z;
    if (before[i] > 0.0 && corners[i].w > 0.0)
    {
      bounds.Add(corners[i]);
      inside += corners[i].z > corners[i].w * view.FarU ? 1 : 0;
    }
  }
  this->IsBetween = inside == 4;
  for (int i = 0; !this->IsBetween && i < 4; ++i)
  {
    AddCuts(corners, before, i, bounds);
  }
  const int size[2] = { view.Width, view.Height };
  for (int i = 0; i < 2; ++i)
  {
    const double margin = 1.0 / 64.0;
    this->Box[i] = static_cast<int>(std::max(std::ceil(bounds.Low[i] - margin), 0.0));
    this->Box[2 + i] =
      static_cast<int>(std::min(std::floor(bounds.High[i] + margin), size[i] - 1.0));
  }
}
