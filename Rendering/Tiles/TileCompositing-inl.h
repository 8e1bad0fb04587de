/**
 * Lays shaded fragments over each other from front to back, in the order of the queue, and keeps
 * the proof of that order per pixel.
 */
#if defined(TileCompositing_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileCompositing_inl_h
#undef TileCompositing_inl_h
#else
#define TileCompositing_inl_h
#endif

#include "TileBuffer.h"
#include "TileColors-inl.h"
#include "TileFragments.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE void BlendFragment(TileBuffer::Pixel& pixel, const float* color)
{
  const hn::CappedTag<float, 4> d;
  const auto through = hn::Set(d, pixel.Through);
  float* under = &pixel.Red;
  for (std::size_t i = 0; i < 4; i += hn::Lanes(d))
  {
    hn::Store(hn::MulAdd(hn::Load(d, color + i), through, hn::Load(d, under + i)), d, under + i);
  }
}

#if HWY_TARGET <= HWY_AVX2
/// Whether one of four fragments and one of the four behind them lie in the same pixel.
HWY_INLINE bool ShareAnyPixel(const int* pixels)
{
  // Against each block of the first four are the last four, turned by one place more.
  alignas(64) static constexpr std::uint8_t turns[64] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, //
    4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, //
    8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7, //
    12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 };
  const hn::CappedTag<int, 16> d;
  const hn::Repartition<std::uint8_t, decltype(d)> bytes;
  const auto first = hn::LoadDup128(d, pixels);
  const auto last = hn::BitCast(bytes, hn::LoadDup128(d, pixels + 4));
  auto areSame = [&](int from)
  { return hn::Eq(first, hn::BitCast(d, hn::TableLookupBytes(last, hn::Load(bytes, turns + from)))); };
  if constexpr (hn::MaxLanes(d) < 16)
  {
    return !hn::AllFalse(d, hn::Or(areSame(0), areSame(32)));
  }
  else
  {
    return !hn::AllFalse(d, areSame(0));
  }
}

/// Fragments of two pixels at once. Each is loaded and stored alone, as the next cell may pair it otherwise: a load of
/// what two stores wrote waits for both.
HWY_INLINE void BlendPair(TileBuffer::Pixel& first, TileBuffer::Pixel& second, const float* colors)
{
  const hn::CappedTag<float, 4> half;
  const hn::CappedTag<float, 8> d;
  const auto under = hn::Combine(d, hn::Load(half, &second.Red), hn::Load(half, &first.Red));
  const auto sum = hn::MulAdd(hn::Load(d, colors), hn::Broadcast<3>(under), under);
  hn::Store(hn::LowerHalf(half, sum), half, &first.Red);
  hn::Store(hn::UpperHalf(half, sum), half, &second.Red);
}

/// Blends the eight fragments from `Begin` of the vector at `at`, unless two lie in one pixel and would change places.
template <int Begin>
HWY_INLINE bool BlendEight(const TileFragments& q, int at, TileBuffer& tile)
{
  const int* pixels = q.Pixel + at + Begin;
  if (ShareAnyPixel(pixels))
  {
    return false;
  }
  for (int k = 0; k < 4; ++k)
  {
    // In slots a fragment and the fourth behind it are neighbours.
    BlendPair(
      tile.Pixels[pixels[k]], tile.Pixels[pixels[k + 4]], q.Slots[at + ColorSlot(Begin + k)]);
  }
  return true;
}
#endif

/// Blends eight fragments of a full vector, or all of a shorter one. The compiler knows where they begin: to compute their
/// slots each time would take as long as to blend them.
template <int Begin>
HWY_INLINE void BlendPart(const TileFragments& q, int at, TileBuffer& tile)
{
#if HWY_TARGET <= HWY_AVX2
  if (BlendEight<Begin>(q, at, tile))
  {
    return;
  }
#endif
  constexpr int lanes = static_cast<int>(hn::MaxLanes(ColorFloat()));
  for (int k = Begin; k < Begin + std::min(lanes, 8); ++k)
  {
    BlendFragment(tile.Pixels[q.Pixel[at + k]], q.Slots[at + ColorSlot(k)]);
  }
}

/// Blends a full vector.
HWY_INLINE void BlendVector(const TileFragments& q, int at, TileBuffer& tile)
{
  BlendPart<0>(q, at, tile);
  if constexpr (hn::MaxLanes(ColorFloat()) > 8)
  {
    BlendPart<8>(q, at, tile);
  }
}

/// A piece that begins nearer than the last one ended proves the order wrong in its pixel.
/// `lastExits`: of the pixels of the fragments from `at` on.
HWY_INLINE void ProveFragments(
  const TileFragments& q, int at, const float* lastExits, float tolerance, TileBuffer& tile)
{
  const ColorFloat d;
  const auto entry = hn::Load(d, q.Entry + at);
  // Less what a float's step may make of it.
  const auto step = hn::Mul(hn::Abs(entry), hn::Set(d, 5e-7f));
  const auto overlap = hn::Sub(hn::Sub(entry, hn::Load(d, lastExits)), step);
  if (hn::AllTrue(d, hn::Le(overlap, hn::Set(d, tolerance))))
  {
    return;
  }
  HWY_ALIGN float overlaps[16];
  hn::Store(overlap, d, overlaps);
  for (int k = 0; k < static_cast<int>(hn::Lanes(d)) && at + k < q.Count; ++k)
  {
    if (overlaps[k] > tolerance)
    {
      tile.Wrong[q.Pixel[at + k]] = 1;
      tile.HasWrong = true;
    }
  }
}

/// The fragments of a vector from `at` on, `count` of them, with their proof where wanted.
template <bool Prove, class Number>
HWY_INLINE void CompositeVector(
  const TileFragments& q, int at, Number count, float tolerance, TileBuffer& tile)
{
  const ColorFloat d;
  HWY_ALIGN float exits[16], lastExits[16];
  if (Prove)
  {
    hn::Store(hn::Sub(hn::Load(d, q.Entry + at), hn::Load(d, q.Extent + at)), d, exits);
    hn::Store(hn::Set(d, 3e38f), d, lastExits);
  }
  for (int k = 0; k < count; ++k)
  {
    const int pixel = q.Pixel[at + k];
    BlendFragment(tile.Pixels[pixel], q.Slots[at + ColorSlot(k)]);
    if (Prove)
    {
      lastExits[k] = tile.LastExits[pixel];
      tile.LastExits[pixel] = exits[k];
    }
  }
  if (Prove)
  {
    ProveFragments(q, at, lastExits, tolerance, tile);
  }
}

/// `tolerance`: of an overlap, in u.
template <bool Prove>
void CompositeFragments(const TileFragments& q, float tolerance, TileBuffer& tile)
{
  constexpr int lanes = static_cast<int>(hn::MaxLanes(ColorFloat()));
  int at = 0;
  for (; at + lanes <= q.Count; at += lanes)
  {
    if constexpr (Prove)
    {
      CompositeVector<true>(q, at, std::integral_constant<int, lanes>(), tolerance, tile);
    }
    else
    {
      BlendVector(q, at, tile);
    }
  }
  if (at < q.Count)
  {
    CompositeVector<Prove>(q, at, q.Count - at, tolerance, tile);
  }
}
}
}
HWY_AFTER_NAMESPACE();

#endif
