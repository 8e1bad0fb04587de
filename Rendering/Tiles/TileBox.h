/**
 * A cell's box of pixels in a tile, in one number: a byte each, from the lowest, for first x and y,
 * width and height. 0 is empty.
 */
#ifndef TileBox_h
#define TileBox_h

#include "TileCells.h"

#include <cstdint>

struct TileBox
{
  static constexpr std::uint32_t Pack(int x, int y, int width, int height)
  {
    return static_cast<std::uint32_t>(x | y << 8 | width << 16) |
      static_cast<std::uint32_t>(height) << 24;
  }
  static constexpr std::uint32_t WholeTile()
  {
    return Pack(0, 0, TileSize::Pixels, TileSize::MostRows);
  }

  explicit constexpr TileBox(std::uint32_t packed)
    : X(packed & 255)
    , Y(packed >> 8 & 255)
    , Width(packed >> 16 & 255)
    , Height(packed >> 24)
  {
  }

  std::uint32_t X, Y, Width, Height;
};

#endif
