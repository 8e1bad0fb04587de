/**
 * How far an image is from the oracle's, over the pixels that either of them covers. The error of a
 * pixel is the largest absolute difference over its four components; what is not a number counts as
 * infinitely far.
 */

#ifndef OracleStatistics_h
#define OracleStatistics_h

#include <array>
#include <vector>

class OracleStatistics
{
public:
  /** One pixel of both images, in the oracle's order; `covered` by the oracle. */
  void AddPixel(
    const std::array<double, 4>& oracle, const std::array<double, 4>& captured, bool covered);

  /** All are 0 where no pixel is covered. */
  double GetRootMeanSquareError() const;
  double GetMaximumError() const;

  /** The smallest error that the given share (0..1] of the covered pixels does not exceed. */
  double GetPercentileError(double share) const;

  /** The share of the covered pixels that are off by more than half an 8-bit level, 1/510. */
  double GetShareAboveHalfLevel() const;

  long long GetNumberOfCoveredPixels() const { return static_cast<long long>(this->Errors.size()); }

  /** The index of the first pixel of the largest error; -1 where no pixel is covered. */
  long long GetMaximumErrorIndex() const { return this->MaximumErrorIndex; }

private:
  std::vector<double> Errors;
  double MaximumError = 0.0;
  long long MaximumErrorIndex = -1;
  long long NumberOfPixels = 0;
};

#endif
