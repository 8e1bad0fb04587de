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

#include <cstddef>
#include <cstdint>
#include <vector>

struct TileTask;

class TileOrder
{
public:
  /** Reorders `count` ids. `work` is left as it comes. True where all that follow each other through
   *  faces are certain to be in order. */
  bool Sort(const TileTask& task, int* ids, int count, std::vector<int>& work);

  /** Of the ids that were sorted last, those with a face through which rays enter the mesh; ascending where
   *  the ids were. */
  const std::vector<int>& GetEntered() const { return this->Entered; }

  std::size_t GetMemorySize() const;

private:
  /** A free cell of a step, and the place of the next one in FreeCells. */
  struct FreeCell
  {
    int Cell, Next;
  };

  unsigned int CountBlockers(const TileTask& task, const int* ids, int count);
  int ReleaseAll(const TileTask& task, const int* ids, int count, int* sorted);
  void FindSteps(const TileTask& task, const int* ids, int count);
  int ReleaseNearest(const TileTask& task, const int* ids, int count, int* sorted);
  void TakeCircles(const TileTask& task, const int* ids, int count, int* sorted, int taken);

  // Of every cell of the mesh, after an unused one: how many cells of the tile before it are still to
  // come, and Present where it is to come itself. Between tiles all are 0.
  std::vector<std::uint8_t> Blockers;
  std::vector<int> Entered;
  // How far each cell of a tile is; of every cell of the mesh, after an unused one, in which step of the tile's depth;
  // those of other tiles' cells are read but never used.
  std::vector<float> Depths;
  std::vector<std::uint8_t> StepOf;
  std::vector<FreeCell> FreeCells;
};

#endif
