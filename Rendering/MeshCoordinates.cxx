#include "MeshCoordinates.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkArrayDispatch.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArrayRange.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
using PointArrays =
  vtkTypeList::Create<vtkAOSDataArrayTemplate<float>, vtkAOSDataArrayTemplate<double>>;

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

// Zero where a used point is not finite.
std::vector<unsigned char> WithoutNonFinite(
  vtkUnstructuredGrid* mesh, std::vector<unsigned char> used)
{
  for (size_t id = 0; id < used.size(); ++id)
  {
    double point[3];
    mesh->GetPoint(static_cast<vtkIdType>(id), point);
    used[id] = used[id] != 0 && std::isfinite(point[0] + point[1] + point[2]) ? 1 : 0;
  }
  return used;
}
}

//------------------------------------------------------------------------------
void MeshCoordinates::Build(vtkUnstructuredGrid* mesh)
{
  this->UsedPoints = FindUsedPoints(mesh);
  this->Move(mesh);
}

//------------------------------------------------------------------------------
void MeshCoordinates::SetExtent(const double bounds[6])
{
  const vtkBoundingBox box(bounds);
  box.GetCenter(this->Center.data());
  const double size = 0.5 * box.GetMaxLength();
  this->Scale = size > 0.0 ? std::exp2(std::ceil(std::log2(size))) : 1.0;
  for (int i = 0; i < 3; ++i)
  {
    this->HalfLengths[i] = 0.5 * box.GetLength(i) / this->Scale;
  }
}

//------------------------------------------------------------------------------
void MeshCoordinates::Move(vtkUnstructuredGrid* mesh)
{
  double bounds[6];
  vtkBoundingBox::ComputeBounds(mesh->GetPoints(), this->UsedPoints.data(), bounds);
  if (!std::isfinite(std::accumulate(bounds, bounds + 6, 0.0)))
  {
    vtkBoundingBox::ComputeBounds(
      mesh->GetPoints(), WithoutNonFinite(mesh, this->UsedPoints).data(), bounds);
  }
  this->SetExtent(bounds);
  this->Points.resize(4 * static_cast<size_t>(mesh->GetNumberOfPoints()));
  vtkDataArray* points = mesh->GetPoints()->GetData();
  const auto take = [this](auto* array) { this->TakePoints(array); };
  if (!vtkArrayDispatch::DispatchByArray<PointArrays>::Execute(points, take))
  {
    this->TakePoints(points);
  }
}

//------------------------------------------------------------------------------
template <class Array>
void MeshCoordinates::TakePoints(Array* array)
{
  const auto points = vtk::DataArrayTupleRange<3>(array);
  vtkSMPTools::For(0, points.size(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType id = begin; id < end; ++id)
      {
        const auto point = points[id];
        for (int i = 0; i < 3; ++i)
        {
          const double offset = static_cast<double>(point[i]) - this->Center[i];
          this->Points[4 * id + i] = static_cast<float>(offset / this->Scale);
        }
        this->Points[4 * id + 3] = 0.0f;
      }
    });
}
