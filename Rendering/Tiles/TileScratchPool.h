/**
 * Scratch memory for as many threads as work at once, kept for the next frame.
 */
#ifndef TileScratchPool_h
#define TileScratchPool_h

#include "TileScratch.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

class TileScratchPool
{
public:
  std::unique_ptr<TileScratch> Take();
  void Return(std::unique_ptr<TileScratch> scratch);

  /** Sums up what was counted, and counts anew. */
  TileCounts CollectCounts();

  /** The same of the seconds: each stage's, of all threads together. */
  TileStages CollectStages();

  /** Bytes of what goes with the cells of a tile. */
  std::size_t GetMemorySize() const;

private:
  std::mutex Mutex;
  std::vector<std::unique_ptr<TileScratch>> Free;
};

#endif
