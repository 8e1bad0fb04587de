#include "MeshTime.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

namespace
{
vtkMTimeType TimeOf(vtkObject* object)
{
  return object ? object->GetMTime() : 0;
}
}

//------------------------------------------------------------------------------
MeshTime MeshTimeOf(vtkDataSet* input)
{
  MeshTime times{};
  times[0] = TimeOf(input->GetCellData()->GetArray("Imaginary"));
  times[1] = TimeOf(input->GetFieldData()->GetAbstractArray("ImaginaryContacts"));
  auto* grid = vtkUnstructuredGrid::SafeDownCast(input);
  if (!grid || !grid->GetPoints())
  {
    times[2] = input->GetMTime();
    return times;
  }
  // The arrays may be modified without a word to what holds them.
  times[2] = TimeOf(grid->GetPoints());
  times[3] = TimeOf(grid->GetPoints()->GetData());
  times[4] = TimeOf(grid->GetCells());
  times[5] = TimeOf(grid->GetCells()->GetConnectivityArray());
  return times;
}
