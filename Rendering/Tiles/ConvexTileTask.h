/**
 * What the projection of every tile of convex cells reads.
 */
#ifndef ConvexTileTask_h
#define ConvexTileTask_h

#include "ConvexTileFaces.h"
#include "TileTask.h"

class ConvexTileCells;
class ConvexTileMesh;
class ConvexTileRays;

struct ConvexTileTask
{
  /** View, limits and image; the rest of it is that of tetrahedra. */
  TileTask Common;
  const ConvexTileMesh* Mesh = nullptr;
  const ConvexTileRays* Rays = nullptr;
  const ConvexTileFaces* Faces = nullptr;
  const ConvexTileCells* Cells = nullptr;
  ConvexTileFaces::Bounds Bounds;
  /** Whether cells are left out of which the limits leave nothing in a tile. */
  bool LeavesOut = false;
};

#endif
