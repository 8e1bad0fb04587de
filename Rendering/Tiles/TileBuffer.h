/**
 * The pixels of one tile, and for each the proof that its pieces came from front to back.
 */
#ifndef TileBuffer_h
#define TileBuffer_h

#include "TileCells.h"

#include <algorithm>

struct TileBuffer
{
  static constexpr int Size = TileSize::Pixels * TileSize::Pixels;

  struct alignas(16) Pixel
  {
    float Red, Green, Blue, Through;
  };
  /** u where the pixel's last piece ended; by how much a later one began before that, at most. */
  struct Proof
  {
    float LastExit, Overlap;
  };

  void Clear()
  {
    std::fill_n(this->Pixels, Size, Pixel{ 0.0f, 0.0f, 0.0f, 1.0f });
    std::fill_n(this->Proofs, Size, Proof{ 3e38f, -3e38f });
  }

  alignas(64) Pixel Pixels[Size];
  alignas(64) Proof Proofs[Size];
};

#endif
