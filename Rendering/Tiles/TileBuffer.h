/**
 * The pixels of one tile, and for each whether its pieces came from front to back.
 */
#ifndef TileBuffer_h
#define TileBuffer_h

#include "TileCells.h"

#include <algorithm>

struct TileBuffer
{
  static constexpr int Size = TileSize::Pixels * TileSize::MostRows;

  struct alignas(16) Pixel
  {
    float Red, Green, Blue, Through;
  };

  /** So many rows; pixels that need no proof of their order leave LastExits alone. */
  void Clear(int rows, bool forProof)
  {
    const int count = rows * TileSize::Pixels;
    std::fill_n(this->Pixels, count, Pixel{ 0.0f, 0.0f, 0.0f, 1.0f });
    if (forProof)
    {
      std::fill_n(this->LastExits, count, 3e38f);
    }
    if (this->HasWrong)
    {
      std::fill_n(this->Wrong, Size, static_cast<unsigned char>(0));
      this->HasWrong = false;
    }
  }

  alignas(64) Pixel Pixels[Size];
  /** u where the pixel's last piece ended. */
  alignas(64) float LastExits[Size];
  /** Not 0: a piece began before the one before it ended. */
  alignas(64) unsigned char Wrong[Size] = {};
  bool HasWrong = false;
};

#endif
