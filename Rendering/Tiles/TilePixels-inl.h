/**
 * Columns and rows of a vector of pixels of a tile.
 */
#if defined(TilePixels_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TilePixels_inl_h
#undef TilePixels_inl_h
#else
#define TilePixels_inl_h
#endif

#include "TileCells.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

struct PixelPlaces
{
  using Float = hn::CappedTag<float, 16>;
  using Int = hn::RebindToSigned<Float>;
  hn::Vec<Float> X, Y;

  /// `pixel`: as in TileFragments.
  explicit HWY_INLINE PixelPlaces(hn::Vec<Int> pixel)
  {
    this->X = hn::ConvertTo(Float(), hn::And(pixel, hn::Set(Int(), TileSize::Pixels - 1)));
    this->Y = hn::ConvertTo(Float(), hn::ShiftRight<TileSize::Shift>(pixel));
  }
  /// From the pixel where a box begins that holds all.
  HWY_INLINE PixelPlaces(hn::Vec<Int> pixel, int corner)
    : PixelPlaces(hn::Sub(pixel, hn::Set(Int(), corner)))
  {
  }
};
}
}
HWY_AFTER_NAMESPACE();

#endif
