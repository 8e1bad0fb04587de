#include "TileScratchPool.h"

#include <utility>

//------------------------------------------------------------------------------
std::unique_ptr<TileScratch> TileScratchPool::Take()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Free.empty())
  {
    return std::make_unique<TileScratch>();
  }
  std::unique_ptr<TileScratch> scratch = std::move(this->Free.back());
  this->Free.pop_back();
  return scratch;
}

//------------------------------------------------------------------------------
void TileScratchPool::Return(std::unique_ptr<TileScratch> scratch)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Free.push_back(std::move(scratch));
}

//------------------------------------------------------------------------------
TileCounts TileScratchPool::CollectCounts()
{
  TileCounts sum;
  for (const std::unique_ptr<TileScratch>& scratch : this->Free)
  {
    sum.Cells += scratch->Counts.Cells;
    sum.HiddenCells += scratch->Counts.HiddenCells;
    sum.Fragments += scratch->Counts.Fragments;
    sum.Pieces += scratch->Counts.Pieces;
    sum.ShadedLanes += scratch->Counts.ShadedLanes;
    sum.LanesOfBlocks += scratch->Counts.LanesOfBlocks;
    sum.CoveredLanes += scratch->Counts.CoveredLanes;
    sum.RepairedPixels += scratch->Counts.RepairedPixels;
    sum.TrustedFragments += scratch->Counts.TrustedFragments;
    scratch->Counts = TileCounts();
  }
  return sum;
}

//------------------------------------------------------------------------------
TileStages TileScratchPool::CollectStages()
{
  TileStages sum;
  for (const std::unique_ptr<TileScratch>& scratch : this->Free)
  {
    sum.Add(scratch->Clock.Stages);
    scratch->Clock.Stages = TileStages();
  }
  return sum;
}

//------------------------------------------------------------------------------
std::size_t TileScratchPool::GetMemorySize() const
{
  std::size_t sum = 0;
  for (const std::unique_ptr<TileScratch>& scratch : this->Free)
  {
    sum += scratch->Order.GetMemorySize() + scratch->Repair.GetMemorySize() +
           scratch->Drawn.capacity() * sizeof(int) +
           scratch->Boxes.capacity() * sizeof(std::uint32_t);
  }
  return sum;
}
