#include "TransferredData.h"

#include "CarriedData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace
{
// The points of the mesh that the output has, in their order.
std::vector<vtkIdType> KeptPoints(const TetrahedraOutput& tetrahedra, vtkIdType count)
{
  std::vector<char> used(static_cast<size_t>(count), tetrahedra.UsedPointsOnly ? 0 : 1);
  for (const std::array<int, 4>& corners : tetrahedra.Tetrahedra)
  {
    for (const int corner : corners)
    {
      if (corner < count)
      {
        used[corner] = 1;
      }
    }
  }
  std::vector<vtkIdType> kept;
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (used[i])
    {
      kept.push_back(i);
    }
  }
  return kept;
}

void FillPoints(const std::vector<NewPoint>& added, const std::vector<vtkIdType>& kept,
  vtkUnstructuredGrid* mesh, vtkUnstructuredGrid* output)
{
  const auto count = static_cast<vtkIdType>(kept.size());
  vtkNew<vtkPoints> points;
  // Floats would move new points, by less than a tetrahedron is thick or by more.
  points->SetDataType(added.empty() ? mesh->GetPoints()->GetDataType() : VTK_DOUBLE);
  points->SetNumberOfPoints(count + static_cast<vtkIdType>(added.size()));
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, mesh->GetPoint(kept[i]));
  }
  vtkPointData* data = output->GetPointData();
  const auto whole = CarriedData::WholeArrays(mesh->GetPointData(), mesh->GetNumberOfPoints());
  CarriedData::CopyTuples(whole, data, kept.data(), count);
  vtkNew<vtkIdList> ids;
  for (size_t i = 0; i < added.size(); ++i)
  {
    const vtkIdType id = count + static_cast<vtkIdType>(i);
    points->SetPoint(id, added[i].Position.data());
    ids->Reset();
    std::for_each(added[i].Ids.begin(), added[i].Ids.end(),
      [&ids](vtkIdType source) { ids->InsertNextId(source); });
    if (ids->GetNumberOfIds() > 0)
    {
      data->InterpolatePoint(whole, id, ids, const_cast<double*>(added[i].Weights.data()));
    }
    else
    {
      data->NullData(id);
    }
  }
  output->SetPoints(points);
}

void FillCells(const TetrahedraOutput& tetrahedra, const std::vector<vtkIdType>& kept,
  vtkIdType meshPoints, vtkUnstructuredGrid* output)
{
  std::vector<vtkIdType> number(static_cast<size_t>(meshPoints), -1);
  for (size_t i = 0; i < kept.size(); ++i)
  {
    number[kept[i]] = static_cast<vtkIdType>(i);
  }
  const vtkIdType shift = static_cast<vtkIdType>(kept.size()) - meshPoints;
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(static_cast<vtkIdType>(tetrahedra.Tetrahedra.size()),
    4 * static_cast<vtkIdType>(tetrahedra.Tetrahedra.size()));
  for (const std::array<int, 4>& corners : tetrahedra.Tetrahedra)
  {
    vtkIdType ids[4];
    std::transform(corners.begin(), corners.end(), ids,
      [&](int corner) { return corner < meshPoints ? number[corner] : corner + shift; });
    cells->InsertNextCell(4, ids);
  }
  output->SetCells(VTK_TETRA, cells);
}

void FillCellData(
  const std::vector<vtkIdType>& sources, vtkDataSetAttributes* cells, vtkDataSetAttributes* output)
{
  const auto count = static_cast<vtkIdType>(sources.size());
  std::vector<vtkIdType> present = sources;
  std::replace(present.begin(), present.end(), vtkIdType(-1), vtkIdType(0));
  CarriedData::CopyTuples(cells, output, present.data(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (sources[i] < 0)
    {
      output->NullData(i);
    }
  }
  // One cell's global id is not for many.
  output->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
  vtkNew<vtkIdTypeArray> array;
  array->SetName("SourceCell");
  array->SetNumberOfValues(count);
  std::copy(sources.begin(), sources.end(), array->GetPointer(0));
  output->AddArray(array);
}
}

namespace TransferredData
{
//------------------------------------------------------------------------------
void Fill(const TetrahedraOutput& tetrahedra, vtkUnstructuredGrid* mesh,
  vtkDataSetAttributes* cells, vtkUnstructuredGrid* output)
{
  const std::vector<vtkIdType> kept = KeptPoints(tetrahedra, mesh->GetNumberOfPoints());
  FillPoints(tetrahedra.NewPoints, kept, mesh, output);
  FillCells(tetrahedra, kept, mesh->GetNumberOfPoints(), output);
  FillCellData(tetrahedra.SourceCells, cells, output->GetCellData());
  output->GetFieldData()->ShallowCopy(mesh->GetFieldData());
}
}
