// One tetrahedron through an installed filter.

#include "vtkConvexCells.h"

#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <iostream>

int main()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, 1, 0);
  points->InsertNextPoint(0, 0, 1);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  const vtkIdType ids[] = { 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_TETRA, 4, ids);

  vtkNew<vtkConvexCells> cells;
  cells->SetInputData(grid);
  cells->Update();
  std::cout << cells->GetClassName() << ": " << cells->GetOutput()->GetNumberOfCells() << " cell\n";
  return cells->GetOutput()->GetNumberOfCells() == 1 ? 0 : 1;
}
