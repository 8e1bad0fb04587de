/**
 * Projects the cells of one tile: set-up, coverage, shading, compositing, repair.
 */
#ifndef TileProjection_h
#define TileProjection_h

struct TileRectangle;
struct TileScratch;
struct TileTask;

namespace TileProjection
{
/** scratch.Drawn holds the cells from front to back. Writes the tile's part of the image. */
void Draw(const TileTask& task, const TileRectangle& tile, TileScratch& scratch);
}

#endif
