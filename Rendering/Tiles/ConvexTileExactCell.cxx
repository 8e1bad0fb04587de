#include "ConvexTileExactCell.h"

#include "ConvexTileMesh.h"
#include "ConvexTileRays.h"
#include "TileView.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace
{
// Along no face of a tidy mesh.
const glm::dvec3 NudgeDirection(0.6180340, 0.4142136, 0.2360680);

glm::dvec3 PointOf(const ConvexTileMesh& mesh, int id)
{
  return glm::dvec3(glm::make_vec3(&mesh.Points[4 * static_cast<std::size_t>(id)]));
}

glm::dvec3 Divide(const glm::dvec3& vector, double by)
{
  return by > 0.0 ? vector / by : glm::dvec3(0.0);
}
}

//------------------------------------------------------------------------------
void ConvexTileExactCell::SetUp(const ConvexTileMesh& mesh, int cell)
{
  this->Planes.clear();
  this->Valleys.clear();
  this->Pieces.clear();
  this->HasCellScalar = !mesh.CellScalars.empty();
  this->CellScalar = this->HasCellScalar ? mesh.CellScalars[cell] : 0.0;
  const ConvexCellFaces::Rows& corners = mesh.Corners;
  this->Center = glm::dvec3(0.0);
  for (int i = 0; i < corners.GetSize(cell); ++i)
  {
    this->Center += PointOf(mesh, corners.GetRow(cell)[i]) / double(corners.GetSize(cell));
  }
  const std::vector<int>& offsets = mesh.Faces.Offsets;
  for (int at = offsets[cell]; at < offsets[cell + 1]; ++at)
  {
    this->AddFace(mesh, mesh.Faces.Values[at], mesh.Sides[at] > 0);
  }
}

//------------------------------------------------------------------------------
void ConvexTileExactCell::AddFace(const ConvexTileMesh& mesh, int face, bool isInward)
{
  const FacePieces::Plane& plane = mesh.Pieces->Planes[face];
  const glm::dvec3 anchor(mesh.Pieces->Shapes[mesh.Pieces->Offsets[face]].First);
  const bool isValley = plane.IsWarped && plane.IsRaised != isInward;
  for (int n = 0; n < (plane.IsWarped ? 2 : 1); ++n)
  {
    const glm::dvec3 inward = (isInward ? 1.0 : -1.0) * plane.Normals[n];
    (isValley ? this->Valleys : this->Planes)
      .push_back({ inward, glm::dot(inward, this->Center - anchor),
        glm::dot(inward, NudgeDirection),
        static_cast<int>(this->Pieces.size()) });
  }
  this->AddPieces(mesh, face);
}

//------------------------------------------------------------------------------
void ConvexTileExactCell::AddPieces(const ConvexTileMesh& mesh, int face)
{
  const FacePieces::Plane& plane = mesh.Pieces->Planes[face];
  const glm::dvec3 normal = glm::normalize(plane.Normals[0] + plane.Normals[1]);
  for (int i = mesh.Pieces->Offsets[face]; i < mesh.Pieces->Offsets[face + 1]; ++i)
  {
    const std::array<int, 4>& ids = mesh.Pieces->Corners[i];
    Piece piece;
    piece.First = PointOf(mesh, ids[0]);
    const glm::dvec3 edge1 = PointOf(mesh, ids[1]) - piece.First;
    const glm::dvec3 diagonal = PointOf(mesh, ids[2]) - piece.First;
    const glm::dvec3 edge3 = PointOf(mesh, ids[3]) - piece.First;
    const glm::dvec3 across = glm::cross(normal, diagonal);
    const bool isTriangle = ids[2] == ids[3];
    const double height = isTriangle ? -glm::dot(across, edge1) : glm::dot(across, edge3);
    piece.GradientW = Divide(across, height);
    piece.GradientU = Divide(diagonal, glm::dot(diagonal, diagonal));
    piece.U1 = glm::dot(piece.GradientU, edge1);
    piece.U3 = isTriangle ? 0.0 : glm::dot(piece.GradientU, edge3);
    const double w1 = glm::dot(piece.GradientW, edge1);
    piece.W1 = w1 < 0.0 ? w1 : -1.0;
    for (int k = 0; k < 4; ++k)
    {
      piece.Corners[k] = PointOf(mesh, ids[k]);
      piece.Scalars[k] = mesh.Points[4 * static_cast<std::size_t>(ids[k]) + 3];
    }
    piece.HasTwo = !isTriangle;
    piece.GoesOn = i + 1 < mesh.Pieces->Offsets[face + 1];
    this->Pieces.push_back(piece);
  }
}

//------------------------------------------------------------------------------
void ConvexTileExactCell::CutAtPlane(const Plane& plane, Passage& p)
{
  const double slope = glm::dot(plane.Normal, p.Direction);
  const double height = glm::dot(plane.Normal, p.Place) + plane.Offset;
  const double depth = -height / slope;
  if (std::abs(slope) <= p.Parallel)
  {
    // A ray along a face counts as moved a little, all rays to the same side.
    const double side = std::abs(height) > Rounding ? height : plane.Nudge;
    p.Depths[1] = side < 0.0 ? -FarAway : p.Depths[1];
  }
  else if (slope > 0.0 && depth > p.Depths[0])
  {
    p.Depths[0] = depth;
    p.Planes[0] = &plane;
  }
  else if (slope < 0.0 && depth < p.Depths[1])
  {
    p.Depths[1] = depth;
    p.Planes[1] = &plane;
  }
}

//------------------------------------------------------------------------------
void ConvexTileExactCell::CutAtValley(const Plane* planes, Passage& p)
{
  Passage each[2] = { p, p };
  for (int i = 0; i < 2; ++i)
  {
    each[i].Depths[0] = -FarAway;
    each[i].Depths[1] = FarAway;
    CutAtPlane(planes[i], each[i]);
  }
  const bool front[2] = { each[0].Depths[0] > -FarAway, each[1].Depths[0] > -FarAway };
  const double enter = front[0] && front[1] ? std::min(each[0].Depths[0], each[1].Depths[0])
                                            : std::max(each[0].Depths[0], each[1].Depths[0]);
  const double leave = !front[0] && !front[1] ? std::max(each[0].Depths[1], each[1].Depths[1])
                                              : std::min(each[0].Depths[1], each[1].Depths[1]);
  // A ray may leave the cell and enter it again: it reaches from the first to the last point.
  const bool mixed = front[0] != front[1];
  if (mixed ? p.Depths[0] > leave && enter > p.Depths[0] : enter > p.Depths[0])
  {
    p.Depths[0] = enter;
    p.Planes[0] = planes;
  }
  if (mixed ? p.Depths[1] < enter && leave < p.Depths[1] : leave < p.Depths[1])
  {
    p.Depths[1] = leave;
    p.Planes[1] = planes;
  }
}

//------------------------------------------------------------------------------
bool ConvexTileExactCell::FindScalar(const Piece& piece, int second, const glm::dvec3& point,
  const glm::dvec3& direction, double& scalar)
{
  const glm::dvec3 a = piece.Corners[0] - point, b = piece.Corners[second] - point,
                   c = piece.Corners[second + 1] - point;
  // Areas as seen along the ray: right also where the point is off the triangle's plane.
  double weights[3] = { glm::dot(direction, glm::cross(b, c)),
    glm::dot(direction, glm::cross(c, a)), glm::dot(direction, glm::cross(a, b)) };
  const double whole = weights[0] + weights[1] + weights[2];
  double sum = 0.0;
  for (double& weight : weights)
  {
    weight = std::max(whole > 0.0 ? weight : -weight, 0.0);
    sum += weight;
  }
  const double extent = std::max({ glm::dot(a, a), glm::dot(b, b), glm::dot(c, c) });
  scalar = (weights[0] * piece.Scalars[0] + weights[1] * piece.Scalars[second] +
             weights[2] * piece.Scalars[second + 1]) /
           sum;
  return std::abs(whole) > Rounding * extent * glm::length(direction);
}

//------------------------------------------------------------------------------
double ConvexTileExactCell::ScalarOnFace(
  int first, const glm::dvec3& point, const glm::dvec3& direction) const
{
  const glm::dvec3 place = point + this->Center;
  const Piece* piece = &this->Pieces[first];
  double u = glm::dot(piece->GradientU, place - piece->First);
  double w = glm::dot(piece->GradientW, place - piece->First);
  while (piece->GoesOn && w > 0.0 && u < piece->U3 * w)
  {
    ++piece;
    u = glm::dot(piece->GradientU, place - piece->First);
    w = glm::dot(piece->GradientW, place - piece->First);
  }
  const bool beyond = w > 0.0 && piece->HasTwo;
  double scalar;
  if (FindScalar(*piece, beyond ? 2 : 1, place, direction, scalar))
  {
    return scalar;
  }
  // Seen edge-on. Clamped: rounding must not leave the range of the corners' scalars.
  const double side = std::min(std::max(beyond ? w : w / piece->W1, 0.0), 1.0);
  const double end = std::min(std::max(u - (beyond ? piece->U3 : piece->U1) * side, 0.0), 1.0 - side);
  return (1.0 - side - end) * piece->Scalars[0] + end * piece->Scalars[2] +
         side * piece->Scalars[beyond ? 3 : 1];
}

//------------------------------------------------------------------------------
bool ConvexTileExactCell::Cross(
  const ConvexTileRays& rays, double x, double y, Segment& segment) const
{
  Passage p;
  p.Direction = rays.DirectionAt(x, y);
  const glm::dvec3 offset = rays.PointAt(x, y) - this->Center;
  const double square = glm::dot(p.Direction, p.Direction);
  const double depth = -glm::dot(offset, p.Direction) / square;
  p.Place = offset + depth * p.Direction;
  p.Parallel = Rounding * std::sqrt(square);
  p.Depths[0] = -FarAway;
  p.Depths[1] = FarAway;
  p.Planes[0] = p.Planes[1] = nullptr;
  for (const Plane& plane : this->Planes)
  {
    CutAtPlane(plane, p);
  }
  // Twice: an end that a later face moves may come to lie in the gap of an earlier one.
  for (std::size_t i = 0; i < 2 * this->Valleys.size(); i += 2)
  {
    CutAtValley(&this->Valleys[i % this->Valleys.size()], p);
  }
  const double begin = std::max(p.Depths[0], rays.Near - depth);
  const double end = std::min(p.Depths[1], rays.Far - depth);
  if (!(begin < end) || !p.Planes[0] || !p.Planes[1])
  {
    return false;
  }
  double scalars[2] = { this->CellScalar, this->CellScalar };
  for (int i = 0; i < 2 && !this->HasCellScalar; ++i)
  {
    scalars[i] = this->ScalarOnFace(
      p.Planes[i]->Piece, p.Place + p.Depths[i] * p.Direction, p.Direction);
  }
  const double change = (scalars[1] - scalars[0]) / (p.Depths[1] - p.Depths[0]);
  segment.Entry = depth + begin;
  segment.Exit = depth + end;
  segment.ScalarIn = scalars[0] + (begin - p.Depths[0]) * change;
  segment.ScalarOut = scalars[1] - (p.Depths[1] - end) * change;
  return true;
}

//------------------------------------------------------------------------------
std::array<int, 4> ConvexTileExactCell::FindBox(
  const ConvexTileMesh& mesh, const TileView& view, int cell)
{
  const int* ids = mesh.Corners.GetRow(cell);
  const int count = mesh.Corners.GetSize(cell);
  double low[2] = { 2e6, 2e6 }, high[2] = { -2e6, -2e6 };
  auto add = [&](const glm::dvec4& screen)
  {
    for (int i = 0; i < 2 && screen.w > 0.0; ++i)
    {
      const double at = std::min(std::max(screen[i] / screen.w, -1e6), 1e6);
      low[i] = std::min(low[i], at);
      high[i] = std::max(high[i], at);
    }
  };
  auto project = [&](int i)
  { return view.MeshToScreen * glm::dvec4(PointOf(mesh, ids[i]), 1.0); };
  // Before the near plane: h * (NearU - u) >= 0 for points before the eye.
  auto before = [&](const glm::dvec4& screen) { return screen.w * view.NearU - screen.z; };
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec4 corner = project(i);
    const double height = before(corner);
    if (height > 0.0)
    {
      add(corner);
      continue;
    }
    // A line between two corners is cut once at most: all of them give the cell's cut, and more.
    for (int j = 0; j < count; ++j)
    {
      const glm::dvec4 other = project(j);
      if (before(other) > 0.0)
      {
        add(glm::mix(corner, other, height / (height - before(other))));
      }
    }
  }
  return { { static_cast<int>(std::max(std::ceil(low[0] - Margin), 0.0)),
    static_cast<int>(std::max(std::ceil(low[1] - Margin), 0.0)),
    static_cast<int>(std::min(std::floor(high[0] + Margin), view.Width - 1.0)),
    static_cast<int>(std::min(std::floor(high[1] + Margin), view.Height - 1.0)) } };
}
