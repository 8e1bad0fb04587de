#include "ConvexTileMesh.h"

#include "MortonOrder.h"
#include "vtkBoundingBox.h"
#include "vtkSMPTools.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace
{
// Cells that stay together: what they read lies one after the other.
constexpr int Run = 16;
}

//------------------------------------------------------------------------------
void ConvexTileMesh::Build(const std::vector<float>& points, const ConvexCellFaces& cells,
  const FacePieces& pieces, const CellPlanes& planes)
{
  this->Pieces = &pieces;
  this->Points = points;
  this->CellScalars.clear();
  this->OrderCells(cells.Corners);
  CopyRows(cells.Corners, this->Source, this->Corners);
  CopyRows(cells.Faces, this->Source, this->Faces);
  this->FaceKinds.resize(static_cast<std::size_t>(cells.GetNumberOfFaces()));
  this->FindSides(planes);
  this->FindFaceKinds();
  this->FindSteps();
  this->FindEdges();
  this->Drawn.assign(this->Source.size(), 0);
}

//------------------------------------------------------------------------------
void ConvexTileMesh::OrderCells(const ConvexCellFaces::Rows& corners)
{
  const int cells = corners.GetNumberOfRows();
  std::vector<double> middles;
  vtkBoundingBox box;
  for (int first = 0; first < cells; first += Run)
  {
    const int begin = corners.Offsets[first];
    const int end = corners.Offsets[std::min(first + Run, cells)];
    double middle[3] = { 0.0, 0.0, 0.0 };
    for (int at = begin; at < end; ++at)
    {
      const float* point = &this->Points[4 * static_cast<std::size_t>(corners.Values[at])];
      for (int k = 0; k < 3; ++k)
      {
        middle[k] += static_cast<double>(point[k]) / (end - begin);
      }
    }
    middles.insert(middles.end(), middle, middle + 3);
    box.AddPoint(middle);
  }
  this->Source.clear();
  for (const int run : middles.empty() ? std::vector<int>() : MortonOrder::Find(middles, box))
  {
    for (int cell = Run * run; cell < std::min(Run * (run + 1), cells); ++cell)
    {
      this->Source.push_back(cell);
    }
  }
}

//------------------------------------------------------------------------------
void ConvexTileMesh::CopyRows(
  const ConvexCellFaces::Rows& from, const std::vector<int>& rows, ConvexCellFaces::Rows& to)
{
  to.Offsets.assign(1, 0);
  to.Values.clear();
  to.Values.reserve(from.Values.size());
  for (const int row : rows)
  {
    to.Values.insert(to.Values.end(), from.GetRow(row), from.GetRow(row) + from.GetSize(row));
    to.Offsets.push_back(static_cast<int>(to.Values.size()));
  }
}

//------------------------------------------------------------------------------
void ConvexTileMesh::FindSides(const CellPlanes& planes)
{
  this->Sides.resize(this->Faces.Values.size());
  this->IsSolid.resize(this->Source.size());
  vtkSMPTools::For(0, this->GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto cell = static_cast<int>(begin); cell < end; ++cell)
      {
        const auto& header = planes.Headers[this->Source[cell]];
        this->IsSolid[cell] = header[1] != 0 ? 1 : 0;
        const glm::vec3 center(planes.Texels[header[0]]);
        for (int at = this->Faces.Offsets[cell]; at < this->Faces.Offsets[cell + 1]; ++at)
        {
          const int face = this->Faces.Values[at];
          const FacePieces::Plane& plane = this->Pieces->Planes[face];
          const glm::vec3& first = this->Pieces->Shapes[this->Pieces->Offsets[face]].First;
          const double height =
            glm::dot(plane.Normals[0] + plane.Normals[1], glm::dvec3(center - first));
          this->Sides[at] = height > 0.0 ? 1 : -1;
        }
      }
    });
}

//------------------------------------------------------------------------------
void ConvexTileMesh::FindFaceKinds()
{
  for (int face = 0; face < this->GetNumberOfFaces(); ++face)
  {
    const int piece = this->Pieces->Offsets[face];
    const std::array<int, 4>& ids = this->Pieces->Corners[piece];
    this->FaceKinds[face] = static_cast<unsigned char>((ids[2] != ids[3] ? TwoTriangles : 0) |
      (this->Pieces->Planes[face].IsWarped ? Warped : 0) |
      (this->Pieces->Offsets[face + 1] > piece + 1 ? MoreTriangles : 0));
  }
}

//------------------------------------------------------------------------------
void ConvexTileMesh::FindSteps()
{
  const bool mayStep = !this->CellScalars.empty();
  for (unsigned char& kind : this->FaceKinds)
  {
    kind = static_cast<unsigned char>(mayStep ? kind | Step : kind & ~Step);
  }
  // The first cell of a face makes it an end, the second one does not leave it so.
  for (const int face : this->Faces.Values)
  {
    this->FaceKinds[face] ^= mayStep ? 0 : Step;
  }
}

//------------------------------------------------------------------------------
void ConvexTileMesh::FindEdges()
{
  this->Edges = EdgeRows();
  for (int cell = 0; cell < this->GetNumberOfCells(); ++cell)
  {
    if (this->Corners.GetSize(cell) <= MostCorners)
    {
      this->AddEdges(cell);
    }
    this->Edges.Offsets.push_back(static_cast<int>(this->Edges.Ends.size()));
  }
}

//------------------------------------------------------------------------------
void ConvexTileMesh::AddEdges(int cell)
{
  const int* ids = this->Corners.GetRow(cell);
  const int corners = this->Corners.GetSize(cell);
  const auto first = static_cast<std::size_t>(this->Edges.Offsets.back());
  // Bit b of the a-th.
  std::array<std::uint32_t, MostCorners> joined{};
  bool areCorners = true;
  const auto join = [&](int one, int other)
  {
    const auto a = std::find(ids, ids + corners, one) - ids;
    const auto b = std::find(ids, ids + corners, other) - ids;
    areCorners = areCorners && std::max(a, b) < corners;
    if (areCorners && a != b && (joined[std::min(a, b)] >> std::max(a, b) & 1u) == 0)
    {
      this->Edges.Ends.push_back({ static_cast<unsigned char>(a), static_cast<unsigned char>(b) });
      joined[std::min(a, b)] |= 1u << std::max(a, b);
    }
  };
  for (int at = this->Faces.Offsets[cell]; at < this->Faces.Offsets[cell + 1]; ++at)
  {
    const int face = this->Faces.Values[at];
    for (int piece = this->Pieces->Offsets[face]; piece < this->Pieces->Offsets[face + 1]; ++piece)
    {
      const std::array<int, 4>& loop = this->Pieces->Corners[piece];
      for (std::size_t i = 0; i < 4; ++i)
      {
        join(loop[i], loop[(i + 1) % 4]);
      }
    }
  }
  // Of too many, or where a face has a point that the cell does not name, none: then whole rows are looked at.
  const bool areKept = areCorners && this->Edges.Ends.size() <= first + MostEdges;
  this->Edges.Ends.resize(areKept ? this->Edges.Ends.size() : first);
}

//------------------------------------------------------------------------------
void ConvexTileMesh::SetScalars(const std::vector<float>& values, bool onePerCell, float sign)
{
  this->CellScalars.resize(onePerCell ? values.size() : 0);
  this->FindSteps();
  for (std::size_t i = 0; i < this->CellScalars.size(); ++i)
  {
    this->CellScalars[i] = sign * values[this->Source[i]];
  }
  for (std::size_t i = 3; i < this->Points.size(); i += 4)
  {
    this->Points[i] = onePerCell ? 0.0f : sign * values[i / 4];
  }
}

//------------------------------------------------------------------------------
bool ConvexTileMesh::SetDrawn(const std::vector<unsigned int>& cells)
{
  std::vector<unsigned char> given(this->Drawn.size(), 0);
  for (const unsigned int cell : cells)
  {
    given[cell] = 1;
  }
  std::vector<unsigned char> drawn(given.size());
  for (std::size_t cell = 0; cell < drawn.size(); ++cell)
  {
    drawn[cell] = given[this->Source[cell]] & this->IsSolid[cell];
  }
  const bool isNew = drawn != this->Drawn;
  this->Drawn.swap(drawn);
  return isNew;
}

//------------------------------------------------------------------------------
float ConvexTileMesh::FindGreatest(int cell) const
{
  if (!this->CellScalars.empty())
  {
    return this->CellScalars[cell];
  }
  const int* corners = this->Corners.GetRow(cell);
  float greatest = this->Points[4 * static_cast<std::size_t>(corners[0]) + 3];
  for (int i = 1; i < this->Corners.GetSize(cell); ++i)
  {
    greatest = std::max(greatest, this->Points[4 * static_cast<std::size_t>(corners[i]) + 3]);
  }
  return greatest;
}

//------------------------------------------------------------------------------
std::size_t ConvexTileMesh::GetMemorySize() const
{
  return 4 * (this->Points.size() + this->CellScalars.size()) + this->Sides.size() + this->FaceKinds.size() +
         this->Drawn.size() + this->IsSolid.size() + 2 * this->Edges.Ends.size() +
         4 * (this->Edges.Offsets.size() + this->Source.size() + this->Corners.Offsets.size() +
               this->Corners.Values.size() + this->Faces.Offsets.size() + this->Faces.Values.size());
}
