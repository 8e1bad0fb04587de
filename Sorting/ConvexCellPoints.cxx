#include "ConvexCellPoints.h"

#include "CarriedData.h"
#include "CoincidentPoints.h"

#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
// In place of a point's canonical id.
constexpr vtkIdType NonFinitePoint = -1;
constexpr vtkIdType HiddenPoint = -2;

// Null where there is none that fits.
const unsigned char* GhostBits(vtkDataSetAttributes* data, vtkIdType count)
{
  auto* array =
    vtkUnsignedCharArray::SafeDownCast(data->GetArray(vtkDataSetAttributes::GhostArrayName()));
  const bool fits = array && array->GetNumberOfValues() == count;
  return fits && count > 0 ? array->GetPointer(0) : nullptr;
}
}

ConvexCellPoints::ConvexCellPoints(vtkPointSet* input)
  : Ghosts(GhostBits(input->GetPointData(), input->GetNumberOfPoints()))
  , NumberOfPoints(input->GetNumberOfPoints())
  , DataType(input->GetPoints() ? input->GetPoints()->GetDataType() : VTK_DOUBLE)
  , Source(input->GetPoints() ? input->GetPoints()->GetData() : nullptr)
{
}

ConvexCellPoints::~ConvexCellPoints() = default;

void ConvexCellPoints::Merge()
{
  this->Canonical.resize(this->NumberOfPoints);
  vtkSMPTools::For(0, this->NumberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      double x[3];
      for (vtkIdType point = begin; point < end; ++point)
      {
        this->Source.Get(point, x);
        const bool finite = std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
        const bool hidden =
          this->Ghosts && (this->Ghosts[point] & vtkDataSetAttributes::HIDDENPOINT);
        this->Canonical[point] = hidden ? HiddenPoint : finite ? 0 : NonFinitePoint;
      }
    });
  CoincidentPoints::Merge(this->Source, this->NumberOfPoints, this->Canonical.data());
}

ConvexCellPlan::FateType ConvexCellPoints::FateOf(const vtkIdType* ids, vtkIdType count)
{
  const vtkIdType smallest = count > 0 ? *std::min_element(ids, ids + count) : 0;
  return smallest == HiddenPoint      ? ConvexCellPlan::Hidden
         : smallest == NonFinitePoint ? ConvexCellPlan::NonFinite
                                      : ConvexCellPlan::Whole;
}

ConvexCellPoints::Coordinates ConvexCellPoints::Round(const Coordinates& x) const
{
  Coordinates rounded = x;
  for (double& coordinate : rounded)
  {
    coordinate = this->DataType == VTK_FLOAT ? static_cast<float>(coordinate) : coordinate;
  }
  return rounded;
}

vtkIdType ConvexCellPoints::Add(const Coordinates& x, const Origin& origin)
{
  this->Added.push_back(this->Round(x));
  this->Origins.push_back(origin);
  return this->GetNumberOfIds() - 1;
}

void ConvexCellPoints::Get(vtkIdType id, double x[3]) const
{
  if (id < this->NumberOfPoints)
  {
    this->Source.Get(id, x);
    return;
  }
  std::copy_n(this->Added[id - this->NumberOfPoints].data(), 3, x);
}

void ConvexCellPoints::Get(const vtkIdType* ids, int count, double (*x)[3]) const
{
  for (int i = 0; i < count; ++i)
  {
    this->Get(ids[i], x[i]);
  }
}

void ConvexCellPoints::NumberOutput()
{
  vtkIdType removed = 0;
  for (vtkIdType point = 0; point < this->NumberOfPoints; ++point)
  {
    removed += this->Canonical[point] < 0;
    this->NumberOfMergedPoints += this->Canonical[point] >= 0 && this->Canonical[point] != point;
  }
  removed += this->NumberOfMergedPoints;
  if (removed == 0 && this->Added.empty())
  {
    return;
  }
  this->OutputIds.assign(this->GetNumberOfIds(), -1);
  this->SourcePoints.reserve(this->NumberOfPoints - removed);
  for (vtkIdType point = 0; point < this->NumberOfPoints; ++point)
  {
    if (this->Canonical[point] == point)
    {
      this->OutputIds[point] = static_cast<vtkIdType>(this->SourcePoints.size());
      this->SourcePoints.push_back(point);
    }
  }
  std::iota(this->OutputIds.begin() + this->NumberOfPoints, this->OutputIds.end(),
    static_cast<vtkIdType>(this->SourcePoints.size()));
}

void ConvexCellPoints::MakeOutputPoints(vtkPointSet* input)
{
  const auto count = static_cast<vtkIdType>(this->SourcePoints.size());
  this->OutputPoints = vtkSmartPointer<vtkPoints>::New();
  this->OutputPoints->SetDataType(this->DataType);
  this->OutputPoints->SetNumberOfPoints(count + this->GetNumberOfAddedPoints());
  vtkNew<vtkIdList> from, to;
  from->SetNumberOfIds(count);
  to->SetNumberOfIds(count);
  std::copy(this->SourcePoints.begin(), this->SourcePoints.end(), from->GetPointer(0));
  std::iota(to->GetPointer(0), to->GetPointer(0) + count, vtkIdType{ 0 });
  this->OutputPoints->InsertPoints(to, from, input->GetPoints());
  for (vtkIdType added = 0; added < this->GetNumberOfAddedPoints(); ++added)
  {
    this->OutputPoints->SetPoint(count + added, this->Added[added].data());
  }
}

void ConvexCellPoints::Fill(
  vtkPointSet* input, vtkUnstructuredGrid* output, const Interpolation& interpolate)
{
  const auto data = CarriedData::WholeArrays(input->GetPointData(), this->NumberOfPoints);
  if (this->OutputIds.empty())
  {
    output->SetPoints(input->GetPoints());
    output->GetPointData()->PassData(data);
    return;
  }
  if (!this->OutputPoints)
  {
    this->MakeOutputPoints(input);
  }
  output->SetPoints(this->OutputPoints);
  const auto first = static_cast<vtkIdType>(this->SourcePoints.size());
  CarriedData::CopyTuples(data, output->GetPointData(), this->SourcePoints.data(), first,
    this->GetNumberOfAddedPoints());
  vtkNew<vtkIdList> ids;
  std::vector<double> weights;
  for (vtkIdType added = 0; added < this->GetNumberOfAddedPoints(); ++added)
  {
    interpolate(this->Origins[added], ids, weights);
    output->GetPointData()->InterpolatePoint(data, first + added, ids, weights.data());
  }
}

void ConvexCellPoints::ReleaseWorkingMemory()
{
  std::vector<vtkIdType>().swap(this->Canonical);
}
