#include "ErrorBalance.h"

#include <cmath>

namespace
{
struct Largest
{
  double Error = -1.0;
  double Slope = 0.0;
};

Largest FindLargest(const std::vector<std::pair<double, double>>& errors, double shift)
{
  Largest largest;
  for (const std::pair<double, double>& error : errors)
  {
    const double shifted = error.first + error.second * shift;
    if (std::abs(shifted) > largest.Error)
    {
      largest.Error = std::abs(shifted);
      largest.Slope = shifted > 0.0 ? error.second : -error.second;
    }
  }
  return largest;
}
}

namespace ErrorBalance
{
//------------------------------------------------------------------------------
double FindShift(const std::vector<std::pair<double, double>>& errors, double reach)
{
  // The largest error is convex in the shift: halved until the rest does not matter.
  double low = -reach, high = reach;
  for (int i = 0; i < 12; ++i)
  {
    const double middle = 0.5 * (low + high);
    (FindLargest(errors, middle).Slope > 0.0 ? high : low) = middle;
  }
  const double shift = 0.5 * (low + high);
  return FindLargest(errors, shift).Error < FindLargest(errors, 0.0).Error ? shift : 0.0;
}
}
