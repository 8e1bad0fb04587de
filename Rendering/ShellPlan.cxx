#include "ShellPlan.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
double ShellPlan::CountSlices(const double range[2], double spacing)
{
  return std::max(std::ceil((range[1] - range[0]) / spacing), 0.0);
}

//------------------------------------------------------------------------------
void ShellPlan::Build(
  const double range[2], double spacing, int samplesPerShell, bool withEnds)
{
  this->Spacing = spacing;
  this->SamplesPerShell = samplesPerShell;
  this->Margin = (withEnds ? 1.01 : 0.01) * spacing;
  this->FirstSlice = std::floor((range[0] - this->Margin) / spacing);
  const double last = std::ceil((range[1] + this->Margin) / spacing);
  this->NumberOfShells =
    range[0] <= range[1] ? static_cast<int>((last - this->FirstSlice) / samplesPerShell) + 1 : 0;
}

//------------------------------------------------------------------------------
double ShellPlan::GetDistance(int shell) const
{
  return (this->FirstSlice + static_cast<double>(shell) * this->SamplesPerShell) * this->Spacing;
}

//------------------------------------------------------------------------------
void ShellPlan::FindShells(double nearest, double farthest, int shells[2]) const
{
  const double thickness = this->SamplesPerShell * this->Spacing;
  const double start = this->GetDistance(0);
  const auto shellAt = [&](double distance)
  {
    const double shell = std::floor((distance - start) / thickness);
    return static_cast<int>(std::clamp(shell, 0.0, this->NumberOfShells - 1.0));
  };
  shells[0] = shellAt(nearest - this->Margin);
  shells[1] = shellAt(farthest + this->Margin);
}
