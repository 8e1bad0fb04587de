/**
 * The cells of a tile from front to back: Williams' MPVO (1992) among them.
 *
 * Cells along a ray through a pixel of the tile follow each other through faces and all cover that
 * pixel, so the tile's own cells suffice. They are few, stay in cache, and tiles are put in order
 * in parallel. Where the mesh is sparse (TileMesh::IsSparse) the cells between those that are drawn
 * are missing: of the ones that nothing is known to hide the nearest come first then, which is as good
 * as the order of all but where cells are long. Not guaranteed: across gaps and in cycles cells come
 * as they are (class TileCompositing finds the pixels where that matters).
 */
#ifndef TileOrder_h
#define TileOrder_h

#include "TilePlaces.h"

#include <cstddef>
#include <vector>

class TileCells;
class TileMesh;
struct TileTask;

class TileOrder
{
public:
  /** Reorders `count` ids. `work` is left as it comes. True where all that follow each other through
   *  faces are certain to be in order. */
  bool Sort(const TileTask& task, int* ids, int count, std::vector<int>& work);

  std::size_t GetMemorySize() const;

private:
  unsigned int FindWaiters(const TileMesh& mesh, const TileCells& cells, const int* ids, int count);
  void ReleaseAll(const int* ids, int count);
  void Release(int seed, const int* ids, int count);
  void FindSteps(const TileTask& task, const int* ids, int count);
  void ReleaseNearest(const int* ids, int count);

  TilePlaces Places;
  // Places of the cells behind each one, from WaitersBegin[i] on.
  std::vector<int> Waiters, WaitersBegin;
  // How many cells before each one are still to come, or Done: 4 at most. No
  // bytes: after a store to one the compiler reads every pointer again.
  std::vector<short> Blockers;
  // How far each cell is, in which step of the tile's depth that is, and which free cell of the step
  // comes next.
  std::vector<float> Depths;
  std::vector<int> StepOf, NextFree;
  int* Sorted = nullptr;
  int NumberOfSorted = 0;
};

#endif
