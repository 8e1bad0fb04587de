// Compiled once for each instruction set that the machine may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "PixelBlending.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "PixelBlending.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionPixels
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR
// A lane takes no whole pixel.
constexpr int MostPixels = 1;

int CountPixels()
{
  return 1;
}

void LayVectorOver(const float* image, unsigned char* window)
{
  auto cut = [](float value) { return value > 0.0f ? std::min(value, 1.0f) : 0.0f; };
  const float shown = 1.0f - cut(image[3]);
  for (int i = 0; i < 4; ++i)
  {
    const float sum = window[i] * shown + 255.0f * cut(image[i]);
    window[i] = static_cast<unsigned char>(std::nearbyint(std::min(sum, 255.0f)));
  }
}
#else
using Floats = hn::CappedTag<float, 16>;
constexpr int MostPixels = static_cast<int>(hn::MaxLanes(Floats())) / 4;

int CountPixels()
{
  return static_cast<int>(hn::Lanes(Floats())) / 4;
}

void LayVectorOver(const float* image, unsigned char* window)
{
  const Floats d;
  const hn::RebindToSigned<Floats> ints;
  const hn::Rebind<unsigned char, Floats> bytes;
  const auto one = hn::Set(d, 1.0f);
  const auto given = hn::LoadU(d, image);
  const auto color = hn::Min(hn::IfThenElseZero(hn::Gt(given, hn::Zero(d)), given), one);
  // A pixel is a block of four: its last is alpha.
  const auto shown = hn::Sub(one, hn::Broadcast<3>(color));
  const auto under = hn::ConvertTo(d, hn::PromoteTo(ints, hn::LoadU(bytes, window)));
  const auto sum = hn::MulAdd(under, shown, hn::Mul(color, hn::Set(d, 255.0f)));
  hn::StoreU(hn::DemoteTo(bytes, hn::NearestInt(sum)), bytes, window);
}
#endif

// NOLINTNEXTLINE: Highway's dispatch table names it.
void LayOver(const float* image, int count, unsigned char* window)
{
  const int pixels = CountPixels();
  int i = 0;
  for (; i + pixels <= count; i += pixels)
  {
    LayVectorOver(image + 4 * i, window + 4 * i);
  }
  // What is left goes the same way, so that a pixel's place is not seen in its value.
  float colors[4 * MostPixels] = {};
  unsigned char under[4 * MostPixels] = {};
  std::copy(image + 4 * i, image + 4 * count, colors);
  std::copy(window + 4 * i, window + 4 * count, under);
  LayVectorOver(colors, under);
  std::copy_n(under, 4 * (count - i), window + 4 * i);
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace CellProjectionPixels
{
HWY_EXPORT(LayOver);
}

//------------------------------------------------------------------------------
void PixelBlending::LayOver(const float* image, int count, unsigned char* window)
{
  HWY_DYNAMIC_DISPATCH(CellProjectionPixels::LayOver)(image, count, window);
}
#endif
