/**
 * The emission along every ray of a tile, summed up cell by cell in the order given.
 */
#ifndef EmissionProjection_h
#define EmissionProjection_h

class EmissionTable;
struct ConvexTileTask;
struct TileRectangle;
struct TileScratch;

namespace EmissionProjection
{
/** `cells`: ids. Writes the tile's part of task.Common.Image. */
void Draw(const ConvexTileTask& task, const TileRectangle& tile, const int* cells, int count,
  const EmissionTable& table, TileScratch& scratch);
}

#endif
