/**
 * Whether the rays of a tile enter the mesh once at most.
 *
 * Then the cells along each ray follow each other through faces, without a gap, and the order that those faces give
 * (class TileOrder) is the right one wherever it is certain: no pixel has to prove it. Rays enter where a face without a neighbour
 * looks towards the eye; two such faces at one pixel are a gap, or cells that overlap. Faces are filled row by
 * row, those that share an edge by the same numbers, so that no pixel between them is theirs twice or not at all.
 * Of a mesh that begins before the near plane the cells that the plane cuts are not certain, see class
 * TileCells; of one that clipping planes cut this class knows nothing.
 */
#ifndef TileEntries_h
#define TileEntries_h

#include "TileCells.h"

#include <array>
#include <cstdint>
#include <vector>

struct TileRectangle;
struct TileTask;

class TileEntries
{
public:
  /** `cells`: those of a tile through which rays enter. */
  bool AreSingle(const TileTask& task, const TileRectangle& tile, const std::vector<int>& cells);

private:
  static_assert(TileSize::Pixels == 64, "a row of pixels is one word");
  using Rows = std::array<std::uint64_t, TileSize::MostRows>;
  struct Point
  {
    double X, Y;
  };

  bool AddCell(const TileTask& task, const TileRectangle& tile, int cell);
  bool AddFace(const Point& a, const Point& b, const Point& c);
  void FlipRightOf(const Point& a, const Point& b);

  /** Pixels that were entered, and those of one face. */
  Rows Entered{};
  Rows Face{};
  int Height = 0; // of the tile, in rows
};

#endif
