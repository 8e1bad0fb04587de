#include "ConvexCellGrid.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace
{
// Of all ways to give a grid its polyhedra this one is the same in every VTK.
void InsertCells(vtkUnstructuredGrid* grid, vtkUnsignedCharArray* types, const vtkIdType* offsets,
  const vtkIdType* ids)
{
  grid->Allocate(types->GetNumberOfValues());
  vtkNew<vtkIdList> list;
  for (vtkIdType cell = 0; cell < types->GetNumberOfValues(); ++cell)
  {
    const vtkIdType begin = offsets[cell], end = offsets[cell + 1];
    list->SetNumberOfIds(end - begin);
    std::copy(ids + begin, ids + end, list->GetPointer(0));
    grid->InsertNextCell(types->GetValue(cell), list);
  }
  grid->Squeeze();
}
}

vtkSmartPointer<vtkUnstructuredGrid> ConvexCellGrid::Make(
  vtkUnsignedCharArray* types, vtkIdTypeArray* offsets, vtkIdTypeArray* ids)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const unsigned char* begin = types->GetPointer(0);
  const unsigned char* end = begin + types->GetNumberOfValues();
  if (std::find(begin, end, VTK_POLYHEDRON) != end)
  {
    InsertCells(grid, types, offsets->GetPointer(0), ids->GetPointer(0));
    return grid;
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, ids);
  grid->SetCells(types, cells);
  return grid;
}
