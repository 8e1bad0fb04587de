#include "OracleStatistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
void OracleStatistics::AddPixel(
  const std::array<double, 4>& oracle, const std::array<double, 4>& captured, bool covered)
{
  double error = 0.0;
  for (int component = 0; component < 4; ++component)
  {
    const double difference = std::abs(oracle[component] - captured[component]);
    const bool isNumber = std::isfinite(difference);
    error = std::max(error, isNumber ? difference : std::numeric_limits<double>::infinity());
    covered = covered || captured[component] != 0.0;
  }
  if (covered)
  {
    this->Errors.push_back(error);
    if (this->MaximumErrorIndex < 0 || error > this->MaximumError)
    {
      this->MaximumError = error;
      this->MaximumErrorIndex = this->NumberOfPixels;
    }
  }
  ++this->NumberOfPixels;
}

//------------------------------------------------------------------------------
double OracleStatistics::GetRootMeanSquareError() const
{
  double sum = 0.0;
  for (double error : this->Errors)
  {
    sum += error * error;
  }
  return this->Errors.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(this->Errors.size()));
}

//------------------------------------------------------------------------------
double OracleStatistics::GetMaximumError() const
{
  return this->MaximumError;
}

//------------------------------------------------------------------------------
double OracleStatistics::GetPercentileError(double share) const
{
  if (this->Errors.empty())
  {
    return 0.0;
  }
  std::vector<double> errors = this->Errors;
  std::sort(errors.begin(), errors.end());
  const double rank = std::ceil(share * static_cast<double>(errors.size()));
  return errors[std::max<std::size_t>(static_cast<std::size_t>(rank), 1) - 1];
}

//------------------------------------------------------------------------------
double OracleStatistics::GetShareAboveHalfLevel() const
{
  const auto isAbove = [](double error) { return error > 1.0 / 510.0; };
  const auto count = std::count_if(this->Errors.begin(), this->Errors.end(), isAbove);
  return this->Errors.empty()
           ? 0.0
           : static_cast<double>(count) / static_cast<double>(this->Errors.size());
}
