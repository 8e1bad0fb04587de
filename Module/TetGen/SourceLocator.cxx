#include "SourceLocator.h"

#include "vtkCellData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkStaticCellLocator.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

//------------------------------------------------------------------------------
SourceLocator::SourceLocator(vtkUnstructuredGrid* split)
  : Split(split)
  , Sources(vtkIdTypeArray::SafeDownCast(split->GetCellData()->GetArray("SourceCell")))
{
  if (split->GetNumberOfCells() > 0)
  {
    this->Locator = vtkSmartPointer<vtkStaticCellLocator>::New();
    this->Locator->SetDataSet(split);
    this->Locator->BuildLocator();
  }
}

//------------------------------------------------------------------------------
SourceLocator::~SourceLocator() = default;

//------------------------------------------------------------------------------
vtkIdType SourceLocator::FindCell(const double x[3], double weights[4]) const
{
  if (!this->Locator)
  {
    return -1;
  }
  // vtkStaticCellLocator::FindCell takes the first cell within a thousandth of its size.
  double bounds[6] = { x[0], x[0], x[1], x[1], x[2], x[2] };
  vtkNew<vtkIdList> cells;
  this->Locator->FindCellsWithinBounds(bounds, cells);
  vtkIdType found = -1;
  double largest = -1e-9;
  vtkNew<vtkGenericCell> cell;
  for (const vtkIdType id : *cells)
  {
    double closest[3], inside[3], distance, here[4];
    int part;
    this->Split->GetCell(id, cell);
    cell->EvaluatePosition(x, closest, part, inside, distance, here);
    const double least = *std::min_element(here, here + 4);
    if (least > largest)
    {
      largest = least;
      found = id;
      std::copy_n(here, 4, weights);
    }
  }
  return found;
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> SourceLocator::FindSources(const TetGenMesh& mesh) const
{
  std::vector<vtkIdType> sources;
  for (const std::array<int, 4>& tetrahedron : mesh.Tetrahedra)
  {
    double middle[3] = { 0.0, 0.0, 0.0 }, weights[4];
    for (int i = 0; i < 12; ++i)
    {
      middle[i % 3] += 0.25 * mesh.Points[3 * static_cast<size_t>(tetrahedron[i / 3]) + i % 3];
    }
    const vtkIdType found = this->FindCell(middle, weights);
    sources.push_back(found < 0 ? -1 : this->Sources->GetValue(found));
  }
  return sources;
}

//------------------------------------------------------------------------------
std::vector<NewPoint> SourceLocator::FindNewPoints(const TetGenMesh& mesh) const
{
  std::vector<NewPoint> points;
  const auto first = 3 * static_cast<size_t>(this->Split->GetNumberOfPoints());
  for (size_t i = first; i < mesh.Points.size(); i += 3)
  {
    points.push_back(this->FindNewPoint(&mesh.Points[i]));
  }
  return points;
}

//------------------------------------------------------------------------------
NewPoint SourceLocator::FindNewPoint(const double x[3]) const
{
  NewPoint point;
  std::copy_n(x, 3, point.Position.begin());
  double weights[4];
  vtkIdType found = this->FindCell(x, weights);
  if (found < 0 && this->Locator)
  {
    // Beside a boundary face, by rounding.
    double closest[3], distance;
    int part;
    vtkNew<vtkGenericCell> cell;
    this->Locator->FindClosestPoint(x, closest, cell, found, part, distance);
    found = this->FindCell(closest, weights);
  }
  if (found >= 0)
  {
    vtkNew<vtkIdList> ids;
    this->Split->GetCellPoints(found, ids);
    point.Ids.assign(ids->begin(), ids->end());
    point.Weights.assign(weights, weights + 4);
  }
  return point;
}
