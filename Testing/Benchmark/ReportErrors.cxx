#include "ReportErrors.h"

#include "vtkCellProjectionOracle.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void ReportErrors::Add(vtkCellProjectionOracle* compared, bool isInside)
{
  const auto pixels = static_cast<double>(compared->GetNumberOfCoveredPixels());
  const double error = compared->GetRootMeanSquareError();
  for (Sum* sum : { &this->All, &this->Outside })
  {
    if (sum == &this->All || !isInside)
    {
      sum->Squares += pixels * error * error;
      sum->AboveHalfLevel += pixels * compared->GetShareAboveHalfLevel();
      sum->Pixels += pixels;
    }
  }
  this->Percentile = std::max(this->Percentile, compared->GetPercentileError());
  this->Maximum = std::max(this->Maximum, compared->GetMaximumError());
  if (isInside)
  {
    this->MaximumInside = std::max(this->MaximumInside, compared->GetMaximumError());
  }
}

//------------------------------------------------------------------------------
double ReportErrors::GetRootMeanSquare() const
{
  return this->All.Pixels > 0.0 ? std::sqrt(this->All.Squares / this->All.Pixels) : 0.0;
}

//------------------------------------------------------------------------------
double ReportErrors::GetRootMeanSquareOutside() const
{
  return this->Outside.Pixels > 0.0 ? std::sqrt(this->Outside.Squares / this->Outside.Pixels) : 0.0;
}

//------------------------------------------------------------------------------
double ReportErrors::GetShare() const
{
  return this->All.Pixels > 0.0 ? this->All.AboveHalfLevel / this->All.Pixels : 0.0;
}
