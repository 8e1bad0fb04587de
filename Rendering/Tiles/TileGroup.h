/**
 * Tetrahedra set up for one tile.
 *
 * On the screen extended by u a tetrahedron stays one, and scalar * weight is linear in it. x and y
 * count pixels from the corner of the cell's box.
 */
#ifndef TileGroup_h
#define TileGroup_h

#include "TileCells.h"

#include <cstdint>

struct TileGroup
{
  /** At most: to go from set-up to coverage and on costs as much for few cells as for many. */
  static constexpr int Size = 128;
  /** Always whole ones are set up, the last cell fills what is left. */
  static constexpr int Batch = 16;

  /** Of the plane of face f: u = P + A x + B y. The last two cut off what is transparent: where
   *  rays come to what is seen, and where they leave it. */
  alignas(64) float P[6][Size];
  alignas(64) float A[6][Size];
  alignas(64) float B[6][Size];
  static constexpr int CutEntry = 4, CutExit = 5;
  /** scalar * weight = ScalarP + ScalarA x + ScalarB y + ScalarU u. */
  alignas(64) float ScalarP[Size];
  alignas(64) float ScalarA[Size];
  alignas(64) float ScalarB[Size];
  alignas(64) float ScalarU[Size];
  /** The box: its corner in the tile, its size; 0 or less where empty. */
  alignas(64) int Left[Size];
  alignas(64) int Bottom[Size];
  alignas(64) int Width[Size];
  alignas(64) int Height[Size];
  /** Bit f: rays enter through face f. */
  alignas(64) int Entries[Size];
  /** Not 0: floats do not serve, see class TileExactCell. */
  alignas(64) int Exact[Size];
  /** Not 0: a part is transparent, the cuts are set. */
  alignas(64) int Cut[Size];
  /** FirstRows are read of every cell, whether it has them or not, then RowStep at a time: no processor guesses how high
   *  a cell is. */
  static constexpr int FirstRows = 8;
  static constexpr int RowStep = 4;
  static_assert(FirstRows % RowStep == 0 && FirstRows <= TileSize::MostRows, "what is read was written");
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  static constexpr int LowerHalf = 1;
#else
  static constexpr int LowerHalf = 0;
#endif
  /** Of the rows of the boxes: the pixel of the tile's where a cell begins, and how many pixels it covers, in the lower
   *  and the upper half. */
  alignas(64) std::int32_t Spans[TileSize::MostRows + RowStep][Size];
};

#endif
