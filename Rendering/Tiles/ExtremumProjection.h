/**
 * The greatest scalar along every ray of a tile.
 *
 * A scalar that is linear between a ray's entry and exit is greatest at one of them, also where
 * the ray is cut. Cells come with the greatest scalars first: one that holds nothing greater than
 * all pixels of its box have costs a comparison.
 */
#ifndef ExtremumProjection_h
#define ExtremumProjection_h

struct ConvexTileTask;
struct TileRectangle;
struct TileScratch;

namespace ExtremumProjection
{
/** Where no cell is. */
constexpr float Nothing = -3.4e38f;

/** `cells`: ids; `greatest`: per cell of the mesh. Writes the tile's part of `extrema`, one float
 *  per pixel of the viewport. */
void Draw(const ConvexTileTask& task, const TileRectangle& tile, const int* cells, int count,
  const float* greatest, TileScratch& scratch, float* extrema);
}

#endif
