#include "ConvexTileMesh.h"

#include "vtkSMPTools.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>

//------------------------------------------------------------------------------
void ConvexTileMesh::Build(const std::vector<float>& points, const ConvexCellFaces& cells,
  const FacePieces& pieces, const CellPlanes& planes)
{
  this->Cells = &cells;
  this->Pieces = &pieces;
  this->Points = points;
  this->CellScalars.clear();
  this->FindSides(planes);
  this->FindSteps();
  this->Drawn.assign(static_cast<std::size_t>(cells.GetNumberOfCells()), 0);
}

//------------------------------------------------------------------------------
void ConvexTileMesh::FindSides(const CellPlanes& planes)
{
  const ConvexCellFaces& cells = *this->Cells;
  this->Sides.resize(cells.Faces.Values.size());
  this->IsSolid.resize(static_cast<std::size_t>(cells.GetNumberOfCells()));
  vtkSMPTools::For(0, cells.GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto cell = static_cast<int>(begin); cell < end; ++cell)
      {
        this->IsSolid[cell] = planes.Headers[cell][1] != 0 ? 1 : 0;
        const glm::vec3 center(planes.Texels[planes.Headers[cell][0]]);
        for (int at = cells.Faces.Offsets[cell]; at < cells.Faces.Offsets[cell + 1]; ++at)
        {
          const int face = cells.Faces.Values[at];
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
void ConvexTileMesh::FindSteps()
{
  if (!this->CellScalars.empty())
  {
    this->Steps.assign(static_cast<std::size_t>(this->Cells->GetNumberOfFaces()), 1);
    return;
  }
  // The first cell of a face makes it an end, the second one does not leave it so.
  this->Steps.assign(static_cast<std::size_t>(this->Cells->GetNumberOfFaces()), 0);
  for (const int face : this->Cells->Faces.Values)
  {
    this->Steps[face] ^= 1;
  }
}

//------------------------------------------------------------------------------
void ConvexTileMesh::SetScalars(const std::vector<float>& values, bool onePerCell, float sign)
{
  this->CellScalars.resize(onePerCell ? values.size() : 0);
  this->FindSteps();
  for (std::size_t i = 0; i < this->CellScalars.size(); ++i)
  {
    this->CellScalars[i] = sign * values[i];
  }
  for (std::size_t i = 3; i < this->Points.size(); i += 4)
  {
    this->Points[i] = onePerCell ? 0.0f : sign * values[i / 4];
  }
}

//------------------------------------------------------------------------------
void ConvexTileMesh::SetDrawn(const std::vector<unsigned int>& cells)
{
  std::fill(this->Drawn.begin(), this->Drawn.end(), static_cast<unsigned char>(0));
  for (const unsigned int cell : cells)
  {
    this->Drawn[cell] = this->IsSolid[cell];
  }
}

//------------------------------------------------------------------------------
float ConvexTileMesh::FindGreatest(int cell) const
{
  if (!this->CellScalars.empty())
  {
    return this->CellScalars[cell];
  }
  const int* corners = this->Cells->Corners.GetRow(cell);
  float greatest = this->Points[4 * static_cast<std::size_t>(corners[0]) + 3];
  for (int i = 1; i < this->Cells->Corners.GetSize(cell); ++i)
  {
    greatest = std::max(greatest, this->Points[4 * static_cast<std::size_t>(corners[i]) + 3]);
  }
  return greatest;
}

//------------------------------------------------------------------------------
std::size_t ConvexTileMesh::GetMemorySize() const
{
  return 4 * (this->Points.size() + this->CellScalars.size()) + this->Sides.size() +
         this->Steps.size() + this->Drawn.size() + this->IsSolid.size();
}
