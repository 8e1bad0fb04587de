#include "OracleGridReader.h"

#include "vtkCell.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <utility>

namespace
{
OracleColors FindColors(int components, bool areIndependent)
{
  if (areIndependent || (components != 2 && components != 4))
  {
    return OracleColors::OfScalar;
  }
  return components == 2 ? OracleColors::OfOwnScalar : OracleColors::Direct;
}
}

//------------------------------------------------------------------------------
OracleGridReader::OracleGridReader(vtkUnstructuredGrid* grid, vtkDataArray* scalars,
  bool cellScalars, bool independentComponents, const std::array<double, 16>& dataToWorld)
  : Grid(grid)
  , Scalars(scalars)
  , CellScalars(cellScalars)
  , Colors(FindColors(scalars->GetNumberOfComponents(), independentComponents))
  , Matrix(dataToWorld)
{
  double center[3];
  grid->GetCenter(center);
  this->DataCenter = { center[0], center[1], center[2] };
}

//------------------------------------------------------------------------------
OracleVector OracleGridReader::GetCenter() const
{
  const OracleVector translation = { this->Matrix[3], this->Matrix[7], this->Matrix[11] };
  return this->Transform(this->DataCenter) + translation;
}

//------------------------------------------------------------------------------
OracleCells OracleGridReader::Read(bool withGradients) const
{
  OracleCells cells;
  const OracleGradients gradients = withGradients ? this->ReadGradients() : OracleGradients();
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType cellId = 0; cellId < this->Grid->GetNumberOfCells(); ++cellId)
  {
    this->Grid->GetCell(cellId, cell);
    if (!this->IsDrawn(cell, cellId))
    {
      continue;
    }
    std::vector<OracleVertex> vertices = this->ReadVertices(cell, cellId);
    for (OracleVertex& vertex : vertices)
    {
      vertex.Gradient = gradients.GetGradient(vertex.Id);
    }
    if (cell->GetCellType() == VTK_TETRA)
    {
      cells.AddTetrahedron(vertices);
    }
    else
    {
      cells.AddPolyhedron(vertices, ReadFaces(cell));
    }
  }
  return cells;
}

//------------------------------------------------------------------------------
OracleGradients OracleGridReader::ReadGradients() const
{
  OracleGradients gradients;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType cellId = 0; cellId < this->Grid->GetNumberOfCells(); ++cellId)
  {
    this->Grid->GetCell(cellId, cell);
    if (this->IsDrawn(cell, cellId))
    {
      const std::vector<OracleVertex> vertices = this->ReadVertices(cell, cellId);
      if (OracleCells::IsSolid(vertices))
      {
        gradients.AddTetrahedron(vertices);
      }
    }
  }
  return gradients;
}

//------------------------------------------------------------------------------
bool OracleGridReader::HasTetrahedraOnly() const
{
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType cellId = 0; cellId < this->Grid->GetNumberOfCells(); ++cellId)
  {
    this->Grid->GetCell(cellId, cell);
    if (this->IsDrawn(cell, cellId) && cell->GetCellType() != VTK_TETRA)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool OracleGridReader::IsDrawn(vtkCell* cell, vtkIdType cellId) const
{
  vtkUnsignedCharArray* ghosts = this->Grid->GetCellGhostArray();
  const int hidden = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  const bool isHidden = ghosts && (ghosts->GetValue(cellId) & hidden) != 0;
  // A convex point set lists no faces, only a triangulation of its own.
  const bool hasFaces = cell->IsLinear() && cell->GetCellType() != VTK_CONVEX_POINT_SET;
  return cell->GetCellDimension() == 3 && hasFaces && !isHidden;
}

//------------------------------------------------------------------------------
std::vector<OracleVertex> OracleGridReader::ReadVertices(vtkCell* cell, vtkIdType cellId) const
{
  std::vector<OracleVertex> vertices;
  for (vtkIdType corner = 0; corner < cell->GetNumberOfPoints(); ++corner)
  {
    const vtkIdType pointId = cell->GetPointId(corner);
    double p[3];
    cell->GetPoints()->GetPoint(corner, p);
    const OracleVector position = OracleVector{ p[0], p[1], p[2] } - this->DataCenter;
    const vtkIdType tuple = this->CellScalars ? cellId : pointId;
    const bool isOne = this->Colors == OracleColors::OfScalar;
    const double scalar =
      this->Scalars->GetComponent(tuple, isOne ? 0 : this->Scalars->GetNumberOfComponents() - 1);
    vertices.push_back(
      { pointId, this->Transform(position), scalar, OracleVector(), this->ReadColor(tuple) });
  }
  return vertices;
}

//------------------------------------------------------------------------------
OracleVector OracleGridReader::ReadColor(vtkIdType tuple) const
{
  vtkDataArray* a = this->Scalars;
  if (this->Colors == OracleColors::Direct)
  {
    const double unit = a->GetDataType() == VTK_UNSIGNED_CHAR ? 1.0 / 255.0 : 1.0;
    return OracleVector{ a->GetComponent(tuple, 0), a->GetComponent(tuple, 1),
             a->GetComponent(tuple, 2) } *
      unit;
  }
  return { a->GetComponent(tuple, 0), 0.0, 0.0 };
}

//------------------------------------------------------------------------------
std::vector<std::vector<int>> OracleGridReader::ReadFaces(vtkCell* cell)
{
  std::vector<std::vector<int>> faces;
  for (int faceId = 0; faceId < cell->GetNumberOfFaces(); ++faceId)
  {
    vtkCell* face = cell->GetFace(faceId);
    std::vector<int> loop;
    for (vtkIdType corner = 0; corner < face->GetNumberOfPoints(); ++corner)
    {
      loop.push_back(static_cast<int>(cell->GetPointIds()->IsId(face->GetPointId(corner))));
    }
    // A pixel, the face of a voxel, lists its points row by row.
    if (face->GetCellType() == VTK_PIXEL)
    {
      std::swap(loop[2], loop[3]);
    }
    faces.push_back(loop);
  }
  return faces;
}

//------------------------------------------------------------------------------
OracleVector OracleGridReader::Transform(const OracleVector& v) const
{
  const std::array<double, 16>& m = this->Matrix;
  return { m[0] * v.X + m[1] * v.Y + m[2] * v.Z, m[4] * v.X + m[5] * v.Y + m[6] * v.Z,
    m[8] * v.X + m[9] * v.Y + m[10] * v.Z };
}
