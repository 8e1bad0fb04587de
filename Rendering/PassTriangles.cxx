#include "PassTriangles.h"

#include "CellPlanes.h"
#include "ConvexCellFaces.h"
#include "ConvexCellSelection.h"
#include "FacePieces.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace
{
constexpr int SecondHalf = 4;
constexpr int Turned = 8;

// The triangles of one cell's faces, pass 0.
std::vector<PassTriangles::Triangle> SurfaceOf(
  int cell, const glm::vec3& center, const ConvexCellFaces& cells, const FacePieces& pieces)
{
  std::vector<PassTriangles::Triangle> surface;
  for (int i = 0; i < cells.Faces.GetSize(cell); ++i)
  {
    const int face = cells.Faces.GetRow(cell)[i];
    const glm::vec3 inward = center - pieces.Shapes[pieces.Offsets[face]].First;
    const FacePieces::Plane& plane = pieces.Planes[face];
    const bool isTurned = glm::dot(plane.Normals[0] + plane.Normals[1], glm::dvec3(inward)) > 0.0;
    for (int piece = pieces.Offsets[face]; piece < pieces.Offsets[face + 1]; ++piece)
    {
      const int code = isTurned ? Turned : 0;
      surface.push_back({ { piece, cell, code, 0 } });
      if (pieces.Corners[piece][2] != pieces.Corners[piece][3])
      {
        surface.push_back({ { piece, cell, code + SecondHalf, 0 } });
      }
    }
  }
  return surface;
}
}

//------------------------------------------------------------------------------
void PassTriangles::AppendPasses(int cell, const std::vector<Triangle>& once)
{
  for (const int pass : { Length, Emission, Reset })
  {
    for (Triangle triangle : once)
    {
      triangle[2] += pass;
      this->Triangles.push_back(triangle);
    }
  }
  this->Cells.push_back(cell);
  this->Offsets.push_back(static_cast<int>(this->Triangles.size()));
}

//------------------------------------------------------------------------------
void PassTriangles::AppendExplicit(int cell, int count)
{
  std::vector<Triangle> once;
  for (int i = 0; i < count; ++i)
  {
    once.push_back({ { -1 - this->NumberOfExplicitTriangles, cell, 0, 0 } });
    ++this->NumberOfExplicitTriangles;
  }
  this->AppendPasses(cell, once);
}

//------------------------------------------------------------------------------
int PassTriangles::CornerOfPiece(const Triangle& triangle, int corner)
{
  const int half = (triangle[2] / SecondHalf) % 2;
  const bool isTurned = triangle[2] >= Turned;
  return corner == 0 ? 0 : half + (isTurned ? 3 - corner : corner);
}

//------------------------------------------------------------------------------
int PassTriangles::Find(int cell) const
{
  const auto at = std::lower_bound(this->Cells.begin(), this->Cells.end(), cell);
  return at != this->Cells.end() && *at == cell ? static_cast<int>(at - this->Cells.begin()) : -1;
}

//------------------------------------------------------------------------------
void PassTriangles::Build(const ConvexCellFaces& cells, const FacePieces& pieces,
  const CellPlanes& planes, const ConvexCellSelection& selection)
{
  *this = PassTriangles();
  for (const unsigned int drawn : selection.DrawnCells)
  {
    const int cell = static_cast<int>(drawn);
    const std::array<int, 4>& header = planes.Headers[cell];
    if (header[1] != 0)
    {
      this->AppendPasses(cell, SurfaceOf(cell, glm::vec3(planes.Texels[header[0]]), cells, pieces));
    }
  }
}
