#include "ImageSampling.h"

#include <algorithm>
#include <cmath>

namespace
{
// Else the size would change with every tremor of the clock from frame to frame, and
// nothing that was made for the size before would be used again.
constexpr double StepsPerPixel = 4.0;
// A frame that misses its time by less is left as fine as it is.
constexpr double Slack = 1.1;
// Who allots more does not wait for the picture to move: windows at rest allot thousands.
constexpr double LongestOfMotion = 10.0;
}

//------------------------------------------------------------------------------
void ImageSampling::RecordGivenUp(const Rays& rays, double seconds)
{
  // It would have taken longer.
  this->SecondsPerRay = std::max(this->SecondsPerRay, PerRay(rays, seconds));
}

//------------------------------------------------------------------------------
double ImageSampling::Choose(double seconds, double pixels, const Limits& limits) const
{
  const double wholeImage = seconds > LongestOfMotion ? 0.0 : this->SecondsPerRay * pixels;
  const double ratio = wholeImage / std::max(seconds, 1e-9);
  const double wanted = ratio > Slack ? std::sqrt(ratio) : 1.0;
  const double stepped = std::ceil(StepsPerPixel * wanted) / StepsPerPixel;
  const double least = std::max(limits.Least, 1.0);
  return std::min(std::max(stepped, least), std::max(limits.Greatest, least));
}
