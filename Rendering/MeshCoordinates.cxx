#include "MeshCoordinates.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
// Points that no cell uses (cut-off parts, values that are not numbers) must not move the centre.
std::vector<unsigned char> FindUsedPoints(vtkUnstructuredGrid* mesh)
{
  std::vector<unsigned char> used(static_cast<size_t>(mesh->GetNumberOfPoints()), 0);
  auto cell = vtk::TakeSmartPointer(mesh->GetCells()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      used[ids[i]] = 1;
    }
  }
  return used;
}
}

//------------------------------------------------------------------------------
void MeshCoordinates::Build(vtkUnstructuredGrid* mesh)
{
  double bounds[6];
  vtkBoundingBox::ComputeBounds(mesh->GetPoints(), FindUsedPoints(mesh).data(), bounds);
  const vtkBoundingBox box(bounds);
  box.GetCenter(this->Center.data());
  const double size = 0.5 * box.GetMaxLength();
  this->Scale = size > 0.0 ? std::exp2(std::ceil(std::log2(size))) : 1.0;

  for (int i = 0; i < 3; ++i)
  {
    this->HalfLengths[i] = 0.5 * box.GetLength(i) / this->Scale;
  }
  this->Points.assign(4 * static_cast<size_t>(mesh->GetNumberOfPoints()), 0.0f);
  vtkSMPTools::For(0, mesh->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType id = begin; id < end; ++id)
      {
        double point[3];
        mesh->GetPoint(id, point);
        for (int i = 0; i < 3; ++i)
        {
          this->Points[4 * id + i] = static_cast<float>((point[i] - this->Center[i]) / this->Scale);
        }
      }
    });
}
