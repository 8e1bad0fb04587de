#include "CellPlanes.h"

#include "vtkSMPTools.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <atomic>

namespace
{
glm::vec3 CenterOf(const std::vector<float>& points, const int* corners, int count)
{
  glm::dvec3 sum(0.0);
  for (int i = 0; i < count; ++i)
  {
    sum += glm::dvec3(glm::make_vec3(&points[4 * static_cast<size_t>(corners[i])]));
  }
  return glm::vec3(sum / static_cast<double>(count));
}

float RadiusOf(
  const std::vector<float>& points, const int* corners, int count, const glm::vec3& center)
{
  float radius = 0.0f;
  for (int i = 0; i < count; ++i)
  {
    const glm::vec3 corner = glm::make_vec3(&points[4 * static_cast<size_t>(corners[i])]);
    radius = std::max(radius, glm::distance(corner, center));
  }
  return radius;
}

// Writes the planes of one cell's faces, single ones from the front, then the pairs.
class PlaneWriter
{
public:
  PlaneWriter(glm::vec4* texels, int* pieces, const glm::dvec3& center)
    : Texels(texels)
    , Pieces(pieces)
    , Center(center)
  {
  }

  void Write(
    const FacePieces::Plane& plane, int normal, const glm::vec3& anchor, double side, int piece)
  {
    // Rounded before its offset is taken: the plane goes through its point all the same.
    const glm::vec3 inward(side * plane.Normals[normal]);
    const double offset = glm::dot(glm::dvec3(inward), this->Center - glm::dvec3(anchor));
    *this->Texels++ = glm::vec4(inward, static_cast<float>(offset));
    *this->Pieces++ = piece;
  }

private:
  glm::vec4* Texels;
  int* Pieces;
  const glm::dvec3 Center;
};
}

//------------------------------------------------------------------------------
struct CellPlanes::Side
{
  Side(const FacePieces::Plane& plane, const glm::vec3& anchor, const glm::vec3& center)
  {
    const double heights[2] = { glm::dot(plane.Normals[0], glm::dvec3(center - anchor)),
      glm::dot(plane.Normals[1], glm::dvec3(center - anchor)) };
    this->Sign = heights[0] + heights[1] > 0.0 ? 1.0 : heights[0] + heights[1] < 0.0 ? -1.0 : 0.0;
    this->IsValley = plane.IsWarped && plane.IsRaised != this->Sign > 0.0;
  }
  double Sign;
  bool IsValley;
};

//------------------------------------------------------------------------------
int CellPlanes::CountPlanes(int cell, const ConvexCellFaces& cells, const FacePieces& pieces) const
{
  int planes = 0;
  for (int i = 0; i < cells.Faces.GetSize(cell); ++i)
  {
    planes += pieces.Planes[cells.Faces.GetRow(cell)[i]].IsWarped ? 2 : 1;
  }
  return planes;
}

//------------------------------------------------------------------------------
bool CellPlanes::SetUpCell(int cell, const std::vector<float>& points, const ConvexCellFaces& cells,
  const FacePieces& pieces)
{
  std::array<int, 4>& header = this->Headers[cell];
  const int* corners = cells.Corners.GetRow(cell);
  const glm::vec3 center = CenterOf(points, corners, header[3]);
  this->Texels[header[0]] = glm::vec4(center, RadiusOf(points, corners, header[3], center));
  PlaneWriter writer(&this->Texels[header[0] + 1], &this->Pieces[header[0] + 1], center);
  int planes[2] = { 0, 0 };
  bool isFlat = cells.Faces.GetSize(cell) < 4;
  for (const bool valleys : { false, true })
  {
    for (int i = 0; i < cells.Faces.GetSize(cell); ++i)
    {
      const int face = cells.Faces.GetRow(cell)[i];
      const FacePieces::Plane& plane = pieces.Planes[face];
      const int piece = pieces.Offsets[face];
      const glm::vec3& anchor = pieces.Shapes[piece].First;
      const Side side(plane, anchor, center);
      isFlat = isFlat || side.Sign == 0.0;
      for (int n = 0; n < (plane.IsWarped ? 2 : 1) && side.IsValley == valleys; ++n)
      {
        writer.Write(plane, n, anchor, side.Sign, piece);
        ++planes[valleys ? 1 : 0];
      }
    }
  }
  header[1] = isFlat ? 0 : planes[0] + 65536 * (planes[1] / 2);
  return !isFlat;
}

//------------------------------------------------------------------------------
void CellPlanes::Build(
  const std::vector<float>& points, const ConvexCellFaces& cells, const FacePieces& pieces)
{
  const int count = cells.GetNumberOfCells();
  this->Headers.resize(static_cast<size_t>(count));
  int texels = 0;
  for (int cell = 0; cell < count; ++cell)
  {
    this->Headers[cell] = { { texels, 0, cells.Corners.Offsets[cell],
      cells.Corners.GetSize(cell) } };
    texels += 1 + this->CountPlanes(cell, cells, pieces);
  }
  this->Texels.assign(static_cast<size_t>(texels), glm::vec4(0.0f));
  this->Pieces.assign(static_cast<size_t>(texels), 0);
  std::atomic<int> flat{ 0 };
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto cell = static_cast<int>(begin); cell < end; ++cell)
      {
        flat += this->SetUpCell(cell, points, cells, pieces) ? 0 : 1;
      }
    });
  this->NumberOfFlatCells = flat;
}
