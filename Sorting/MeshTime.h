#ifndef MeshTime_h
#define MeshTime_h

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

/// When points or cells changed last: new scalars move no cell. Other data sets than unstructured
/// grids have one time for everything.
inline vtkMTimeType MeshTimeOf(vtkDataSet* input)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(input);
  if (!grid || !grid->GetPoints())
  {
    return input->GetMTime();
  }
  // The arrays may be modified without a word to what holds them.
  const vtkMTimeType arrays = std::max(
    grid->GetPoints()->GetData()->GetMTime(), grid->GetCells()->GetConnectivityArray()->GetMTime());
  return std::max({ grid->GetPoints()->GetMTime(), grid->GetCells()->GetMTime(), arrays });
}

#endif
