/**
 * Sixteen tetrahedra set up for one tile.
 *
 * On the screen extended by u a tetrahedron stays one, and scalar * weight is linear in it. x and y
 * count pixels from the corner of the cell's box.
 */
#ifndef TileGroup_h
#define TileGroup_h

struct TileGroup
{
  static constexpr int Size = 16;

  /** Of the plane of face f: u = P + A x + B y. */
  alignas(64) float P[4][Size];
  alignas(64) float A[4][Size];
  alignas(64) float B[4][Size];
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
};

#endif
