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
#include "TileFragments.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

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

/// A piece that begins nearer than the last one ended proves the order wrong in its pixel.
HWY_INLINE void ProveFragment(TileBuffer::Proof& proof, float entry, float extent)
{
  // Less what a float's step may make of it.
  const float overlap = entry - proof.LastExit - 5e-7f * std::abs(entry);
  proof.Overlap = std::max(proof.Overlap, overlap);
  proof.LastExit = entry - extent;
}

template <bool Prove>
void CompositeFragments(const TileFragments& q, TileBuffer& tile)
{
  for (int i = 0; i < q.Count; ++i)
  {
    const int pixel = q.Pixel[i];
    BlendFragment(tile.Pixels[pixel], q.Color[i]);
    if (Prove)
    {
      ProveFragment(tile.Proofs[pixel], q.Entry[i], q.Extent[i]);
    }
  }
}
}
}
HWY_AFTER_NAMESPACE();

#endif
