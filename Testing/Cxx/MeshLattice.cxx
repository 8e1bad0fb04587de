#include "MeshLattice.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <map>

//------------------------------------------------------------------------------
MeshLattice::MeshLattice(int cellsX, int cellsY, int cellsZ)
  : Cells{ cellsX, cellsY, cellsZ }
  , Keeps([](int, int, int) { return true; })
  , Bend(
      [](const double u[3], double p[3])
      {
        p[0] = u[0];
        p[1] = u[1];
        p[2] = u[2];
      })
{
}

//------------------------------------------------------------------------------
void MeshLattice::InsertPoint(vtkUnstructuredGrid* grid, const int index[3]) const
{
  const double u[3] = { double(index[0]), double(index[1]), double(index[2]) };
  double p[3];
  this->Bend(u, p);
  grid->GetPoints()->InsertNextPoint(p);
}

//------------------------------------------------------------------------------
void MeshLattice::AddTo(vtkUnstructuredGrid* grid) const
{
  if (!grid->GetPoints())
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    grid->SetPoints(points);
  }
  static const int corners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
    { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  std::map<int, vtkIdType> known;
  for (int cell = 0; cell < this->Cells[0] * this->Cells[1] * this->Cells[2]; ++cell)
  {
    const int at[3] = { cell % this->Cells[0], cell / this->Cells[0] % this->Cells[1],
      cell / this->Cells[0] / this->Cells[1] };
    if (!this->Keeps(at[0], at[1], at[2]))
    {
      continue;
    }
    vtkIdType ids[8];
    for (int corner = 0; corner < 8; ++corner)
    {
      int index[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        index[axis] = at[axis] + corners[corner][axis];
        index[axis] %= this->Wraps[axis] ? this->Cells[axis] : this->Cells[axis] + 1;
      }
      const int name =
        index[0] + (this->Cells[0] + 1) * (index[1] + (this->Cells[1] + 1) * index[2]);
      const auto found = known.emplace(name, grid->GetNumberOfPoints());
      if (found.second)
      {
        this->InsertPoint(grid, index);
      }
      ids[corner] = found.first->second;
    }
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
  }
}

//------------------------------------------------------------------------------
MeshLattice::Grid MeshLattice::Make() const
{
  auto grid = Grid::New();
  this->AddTo(grid);
  return grid;
}
