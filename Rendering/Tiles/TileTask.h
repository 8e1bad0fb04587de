/**
 * What the projection of every tile of a frame reads.
 */
#ifndef TileTask_h
#define TileTask_h

#include "TileCells.h"

#include <algorithm>
#include <array>

class TileCellFields;
class TileLighting;
class TileLimits;
class TileMesh;
class TileTransfer;
class TileVertices;
class TileView;

struct TileTask
{
  const TileMesh* Mesh = nullptr;
  const TileView* View = nullptr;
  const TileVertices* Vertices = nullptr;
  const TileCells* Cells = nullptr;
  const TileTransfer* Transfer = nullptr;
  /** Null where nothing cuts rays but the near and the far plane. */
  const TileLimits* Limits = nullptr;
  /** Null where colours are the transfer function's alone; else with the fields that it needs. */
  const TileLighting* Lighting = nullptr;
  const TileCellFields* Gradients = nullptr;
  const TileCellFields* Colors = nullptr;
  /** Pieces may overlap by this much of u without being called out of order. */
  float Tolerance = 0.0f;
  /** The greatest optical depth of a ray through the mesh, at most. */
  double OpticalDepth = 0.0;
  /** Whether the medium is so dense that every cell is set up in double. */
  bool AllExact = false;
  /** Whether pixels of tiles that are known to be in order do without their proof, see class
   *  TileEntries. */
  bool TrustsOrder = true;
  /** Whether cells behind pixels that are nearly opaque are left out, see class TileOcclusion. */
  bool EndsEarly = true;
  /** Premultiplied RGBA, View->Width x View->Height. */
  float* Image = nullptr;
};

/** The pixels of a tile, or of a part of it, in the viewport. */
struct TileRectangle
{
  /** The corner of the tile. */
  int Left = 0, Bottom = 0;
  /** First and last column and row to draw. */
  int FirstX = 0, FirstY = 0, LastX = -1, LastY = -1;

  /** The tile of that number, row by row from the bottom, cut to the image; of 1 << rowShift rows. */
  static TileRectangle OfTile(int tile, int width, int height, int rowShift = TileSize::Shift)
  {
    const int inRow = TileSize::CountOf(width);
    TileRectangle rectangle;
    rectangle.Left = rectangle.FirstX = tile % inRow * TileSize::Pixels;
    rectangle.Bottom = rectangle.FirstY = (tile / inRow) << rowShift;
    rectangle.LastX = std::min(rectangle.Left + TileSize::Pixels, width) - 1;
    rectangle.LastY = std::min(rectangle.Bottom + (1 << rowShift), height) - 1;
    return rectangle;
  }
};

/** What a tile counts. */
struct TileCounts
{
  long long Cells = 0;
  /** Of these, behind pixels that are nearly opaque: not projected. */
  long long HiddenCells = 0;
  long long Fragments = 0;
  long long Pieces = 0;
  /** Of vectors that were shaded. */
  long long ShadedLanes = 0;
  /** Of the vectors of pixels that coverage looked at, where stages are timed, and those in a cell. */
  long long LanesOfBlocks = 0;
  long long CoveredLanes = 0;
  long long RepairedPixels = 0;
  /** Of the fragments: in tiles whose pixels needed no proof. */
  long long TrustedFragments = 0;
};

#endif
