#include "ScalarField.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
double ValueAt(vtkDataArray* array, vtkIdType id, int component)
{
  if (component >= 0)
  {
    return array->GetComponent(id, component);
  }
  double squares = 0.0;
  for (int i = 0; i < array->GetNumberOfComponents(); ++i)
  {
    const double value = array->GetComponent(id, i);
    squares += value * value;
  }
  return std::sqrt(squares);
}
}

//------------------------------------------------------------------------------
void ScalarField::FindRange(vtkDataArray* array, int component)
{
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  this->NumberOfNonFiniteValues = 0;
  for (vtkIdType id = 0; id < array->GetNumberOfTuples(); ++id)
  {
    const double value = ValueAt(array, id, component);
    if (std::isfinite(value))
    {
      low = std::min(low, value);
      high = std::max(high, value);
    }
    else
    {
      ++this->NumberOfNonFiniteValues;
    }
  }
  this->Range[0] = low <= high ? low : 0.0;
  this->Range[1] = low <= high ? high : 0.0;
}

//------------------------------------------------------------------------------
void ScalarField::Build(vtkDataArray* array, int component, bool onePerCell, const double limits[2])
{
  this->OnePerCell = onePerCell;
  this->FindRange(array, component);
  this->Normal[0] = std::max(this->Range[0], limits[0]);
  this->Normal[1] = std::min(this->Range[1], limits[1]);
  if (!(this->Normal[0] < this->Normal[1]))
  {
    std::copy_n(this->Range, 2, this->Normal);
  }
  const double low = this->Normal[0];
  const double width = this->Normal[1] - low;
  this->Values.resize(static_cast<size_t>(array->GetNumberOfTuples()));
  vtkSMPTools::For(0, array->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType id = begin; id < end; ++id)
      {
        const double value = ValueAt(array, id, component);
        const double normalised = width > 0.0 ? (value - low) / width : 0.0;
        this->Values[id] = std::isfinite(value) ? static_cast<float>(normalised)
                                                : std::numeric_limits<float>::quiet_NaN();
      }
    });
}

//------------------------------------------------------------------------------
bool ScalarField::FindCellRange(vtkIdType cell, const int* corners, int count, float range[2]) const
{
  range[0] = range[1] = this->Values[this->OnePerCell ? cell : corners[0]];
  bool finite = std::isfinite(range[0]);
  for (int i = 1; i < count && !this->OnePerCell; ++i)
  {
    const float value = this->Values[corners[i]];
    finite = finite && std::isfinite(value);
    range[0] = std::min(range[0], value);
    range[1] = std::max(range[1], value);
  }
  return finite;
}

//------------------------------------------------------------------------------
std::array<float, 2> ScalarField::GetNormalisedRange() const
{
  const double width = this->Normal[1] - this->Normal[0];
  std::array<float, 2> range{ { 0.0f, 0.0f } };
  for (int end = 0; end < 2 && width > 0.0; ++end)
  {
    range[end] = static_cast<float>((this->Range[end] - this->Normal[0]) / width);
  }
  return range;
}
