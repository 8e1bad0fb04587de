// Changes to meshes, as grids of their own.
#include "SortMeshes.h"

#include "vtkAppendFilter.h"
#include "vtkCellArray.h"
#include "vtkConvexCells.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

namespace
{
using SortMeshes::Grid;
using Position = std::function<void(double p[3])>;

Grid WithPoints(vtkUnstructuredGrid* grid, int type, const Position& change)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double p[3];
    grid->GetPoint(id, p);
    change(p);
    points->InsertNextPoint(p);
  }
  auto changed = Grid::New();
  changed->DeepCopy(grid);
  changed->SetPoints(points);
  return changed;
}

// Every cell as cells of `type`, whose corners are those of the hexahedron with these numbers.
template <std::size_t Count>
Grid Divide(vtkUnstructuredGrid* grid, int type, const std::vector<std::array<int, Count>>& parts)
{
  auto divided = Grid::New();
  divided->SetPoints(grid->GetPoints());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    for (const auto& part : parts)
    {
      vtkIdType corners[Count];
      for (std::size_t i = 0; i < Count; ++i)
      {
        corners[i] = ids->GetId(part[i]);
      }
      divided->InsertNextCell(type, static_cast<vtkIdType>(Count), corners);
    }
  }
  return divided;
}
}

//------------------------------------------------------------------------------
Grid SortMeshes::Kuhn(vtkUnstructuredGrid* hexahedra)
{
  return Divide<4>(hexahedra, VTK_TETRA,
    { { 0, 1, 2, 6 }, { 0, 2, 3, 6 }, { 0, 3, 7, 6 }, { 0, 7, 4, 6 }, { 0, 4, 5, 6 },
      { 0, 5, 1, 6 } });
}

//------------------------------------------------------------------------------
Grid SortMeshes::Wedges(vtkUnstructuredGrid* hexahedra)
{
  return Divide<6>(hexahedra, VTK_WEDGE, { { 0, 2, 1, 4, 6, 5 }, { 0, 3, 2, 4, 7, 6 } });
}

//------------------------------------------------------------------------------
Grid SortMeshes::Tetrahedra(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkConvexCells> cells;
  cells->SetInputData(grid);
  cells->TetrahedraOnlyOn();
  cells->Update();
  auto copy = Grid::New();
  copy->SetPoints(cells->GetOutput()->GetPoints());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < cells->GetOutput()->GetNumberOfCells(); ++cell)
  {
    cells->GetOutput()->GetCellPoints(cell, ids);
    copy->InsertNextCell(VTK_TETRA, ids);
  }
  return copy;
}

//------------------------------------------------------------------------------
Grid SortMeshes::Scaled(vtkUnstructuredGrid* grid, double x, double y, double z)
{
  return WithPoints(grid, VTK_DOUBLE,
    [=](double p[3])
    {
      p[0] *= x;
      p[1] *= y;
      p[2] *= z;
    });
}

//------------------------------------------------------------------------------
Grid SortMeshes::Moved(vtkUnstructuredGrid* grid, double x, double y, double z)
{
  return WithPoints(grid, VTK_DOUBLE,
    [=](double p[3])
    {
      p[0] += x;
      p[1] += y;
      p[2] += z;
    });
}

//------------------------------------------------------------------------------
Grid SortMeshes::AsFloat(vtkUnstructuredGrid* grid)
{
  return WithPoints(grid, VTK_FLOAT, [](double*) {});
}

//------------------------------------------------------------------------------
Grid SortMeshes::Shuffled(vtkUnstructuredGrid* grid, unsigned int seed)
{
  std::mt19937 random(seed);
  std::vector<vtkIdType> names(grid->GetNumberOfPoints());
  std::vector<vtkIdType> cells(grid->GetNumberOfCells());
  std::iota(names.begin(), names.end(), vtkIdType{ 0 });
  std::iota(cells.begin(), cells.end(), vtkIdType{ 0 });
  std::shuffle(names.begin(), names.end(), random);
  std::shuffle(cells.begin(), cells.end(), random);
  vtkNew<vtkPoints> points;
  points->SetDataType(grid->GetPoints()->GetDataType());
  points->SetNumberOfPoints(grid->GetNumberOfPoints());
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    points->SetPoint(names[id], grid->GetPoint(id));
  }
  auto shuffled = Grid::New();
  shuffled->SetPoints(points);
  vtkNew<vtkIdList> ids;
  for (const vtkIdType cell : cells)
  {
    grid->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      ids->SetId(i, names[ids->GetId(i)]);
    }
    shuffled->InsertNextCell(grid->GetCellType(cell), ids);
  }
  return shuffled;
}

//------------------------------------------------------------------------------
Grid SortMeshes::Select(vtkUnstructuredGrid* grid, const std::function<bool(vtkIdType)>& keeps)
{
  // Points that no cell uses would widen the hull for those who do not look.
  std::vector<vtkIdType> names(grid->GetNumberOfPoints(), -1);
  vtkNew<vtkPoints> points;
  points->SetDataType(grid->GetPoints()->GetDataType());
  auto selected = Grid::New();
  selected->SetPoints(points);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (!keeps(cell))
    {
      continue;
    }
    grid->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      vtkIdType& name = names[ids->GetId(i)];
      name = name < 0 ? points->InsertNextPoint(grid->GetPoint(ids->GetId(i))) : name;
      ids->SetId(i, name);
    }
    selected->InsertNextCell(grid->GetCellType(cell), ids);
  }
  return selected;
}

//------------------------------------------------------------------------------
Grid SortMeshes::Join(vtkUnstructuredGrid* first, vtkUnstructuredGrid* second)
{
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(first);
  append->AddInputData(second);
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  append->Update();
  return append->GetOutput();
}

//------------------------------------------------------------------------------
void SortMeshes::AddScalar(vtkUnstructuredGrid* grid)
{
  double bounds[6];
  grid->GetBounds(bounds);
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("scalar");
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double value = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double length = bounds[2 * axis + 1] - bounds[2 * axis];
      const double at = grid->GetPoint(id)[axis] - bounds[2 * axis];
      value += std::sin((5.0 + axis) * (length > 0.0 ? at / length : 0.0)) / 6.0;
    }
    scalars->InsertNextValue(0.5 + value);
  }
  grid->GetPointData()->SetScalars(scalars);
}
