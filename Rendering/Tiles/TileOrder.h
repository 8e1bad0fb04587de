/**
 * The cells of a tile from front to back: Williams' MPVO (1992) among them.
 *
 * Cells along a ray through a pixel of the tile follow each other through faces and all cover that
 * pixel, so the tile's own cells suffice. They are few, stay in cache, and tiles are put in order
 * in parallel. Not guaranteed: across gaps and in cycles cells come as they are (class
 * TileCompositing finds the pixels where that matters).
 */
#ifndef TileOrder_h
#define TileOrder_h

#include <cstdint>
#include <vector>

class TileCells;
class TileMesh;

class TileOrder
{
public:
  /** Reorders `count` ids. */
  void Sort(const TileMesh& mesh, const TileCells& cells, int* ids, int count);

private:
  void FindWaiters(const TileMesh& mesh, const TileCells& cells, const int* ids, int count);
  void Release(int seed, const int* ids);

  // Of a cell of the mesh: where it is in the tile; true only where the tile's list says so too.
  std::vector<int> Place;
  std::vector<int> Waiters;  // up to 4 places of the cells behind each one
  std::vector<int> Blockers; // how many cells before each one are still to come, or Done
  std::vector<std::uint8_t> NumberOfWaiters;
  std::vector<int> Stack, Sorted;
};

#endif
