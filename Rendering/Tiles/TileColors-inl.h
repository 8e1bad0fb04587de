/**
 * Where the colours of shaded fragments lie.
 *
 * Four vectors, one per component, become records of four floats by transposing each 128-bit block
 * alone, which is half the shuffles of a full transposition. So the records of a vector's fragments
 * lie in slots of another order: the first of every block, then the second of every block.
 */
#if defined(TileColors_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileColors_inl_h
#undef TileColors_inl_h
#else
#define TileColors_inl_h
#endif

#include "TileFragments.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

using ColorFloat = hn::CappedTag<float, 16>;

/// The slot of a fragment.
HWY_INLINE int ColorSlot(int fragment)
{
  // Without signs no division is left.
  constexpr auto lanes = static_cast<unsigned int>(hn::MaxLanes(ColorFloat()));
  constexpr unsigned int blocks = lanes < 4 ? lanes : lanes / 4;
  const unsigned int lane = static_cast<unsigned int>(fragment) % lanes;
  const unsigned int slot = lane % 4 * blocks + lane / 4;
  return lanes < 4 ? fragment : fragment - static_cast<int>(lane) + static_cast<int>(slot);
}

/// Stores the colours of a vector of fragments from `at` on.
HWY_INLINE void StoreColors(const hn::Vec<ColorFloat> (&color)[4], int at, TileFragments& q)
{
  const ColorFloat d;
#if HWY_TARGET == HWY_SCALAR
  hn::StoreInterleaved4(color[0], color[1], color[2], color[3], d, q.Slots[at]);
#else
  const hn::Repartition<double, ColorFloat> pairs;
  const int blocks = static_cast<int>(hn::Lanes(d)) / 4;
  const auto low01 = hn::BitCast(pairs, hn::InterleaveLower(d, color[0], color[1]));
  const auto low23 = hn::BitCast(pairs, hn::InterleaveLower(d, color[2], color[3]));
  const auto high01 = hn::BitCast(pairs, hn::InterleaveUpper(d, color[0], color[1]));
  const auto high23 = hn::BitCast(pairs, hn::InterleaveUpper(d, color[2], color[3]));
  auto store = [&](hn::Vec<decltype(pairs)> records, int row)
  { hn::Store(hn::BitCast(d, records), d, q.Slots[at + row * blocks]); };
  store(hn::InterleaveLower(pairs, low01, low23), 0);
  store(hn::InterleaveUpper(pairs, low01, low23), 1);
  store(hn::InterleaveLower(pairs, high01, high23), 2);
  store(hn::InterleaveUpper(pairs, high01, high23), 3);
#endif
}
}
}
HWY_AFTER_NAMESPACE();

#endif
