#include "TileOrder.h"

#include "TileCells.h"
#include "TileMesh.h"

#include <hwy/cache_control.h>

#include <algorithm>

namespace
{
constexpr signed char Done = -1;
// Cells whose neighbours are fetched before their turn.
constexpr int Ahead = 12;
// The lowest bit of a set of faces.
constexpr int FirstFace[16] = { 0, 0, 1, 0, 2, 0, 1, 0, 3, 0, 1, 0, 2, 0, 1, 0 };
}

//------------------------------------------------------------------------------
void TileOrder::Sort(
  const TileMesh& mesh, const TileCells& cells, int* ids, int count, std::vector<int>& work)
{
  this->FindWaiters(mesh, cells, ids, count);
  work.resize(static_cast<std::size_t>(count));
  this->Sorted = work.data();
  this->NumberOfSorted = 0;
  for (int seed = 0; seed < count; ++seed)
  {
    if (this->Blockers[seed] == 0)
    {
      this->Release(seed, ids, count);
    }
  }
  // What is left hides each other in circles.
  for (int i = 0; i < count && this->NumberOfSorted < count; ++i)
  {
    if (this->Blockers[i] != Done)
    {
      this->Sorted[this->NumberOfSorted++] = ids[i];
    }
  }
  std::copy_n(this->Sorted, count, ids);
}

//------------------------------------------------------------------------------
void TileOrder::FindWaiters(const TileMesh& mesh, const TileCells& cells, const int* ids, int count)
{
  const auto size = static_cast<std::size_t>(count);
  this->Places.Clear(mesh.Source.size());
  this->Waiters.resize(std::max(this->Waiters.size(), 4 * size));
  this->WaitersBegin.resize(size + 1);
  this->Blockers.assign(size, 0);
  for (int i = 0; i < count; ++i)
  {
    this->Places.Set(ids[i], i);
  }
  const TilePlaces::Finder places(this->Places);
  const int* const allNeighbours = mesh.Neighbours.data();
  const std::uint8_t* const faces = cells.Faces.data();
  int* const begins = this->WaitersBegin.data();
  int* const waiters = this->Waiters.data();
  signed char* const blockers = this->Blockers.data();
  int next = 0;
  for (int i = 0; i < count; ++i)
  {
    begins[i] = next;
    hwy::Prefetch(allNeighbours + 4 * static_cast<std::size_t>(ids[std::min(i + Ahead, count - 1)]));
    const int* neighbours = allNeighbours + 4 * static_cast<std::size_t>(ids[i]);
    const unsigned int exits = faces[ids[i]] & TileCells::ExitFaces;
    for (unsigned int left = exits; left != 0; left &= left - 1)
    {
      const int place = places.Find(neighbours[FirstFace[left]]);
      if (place != TilePlaces::None)
      {
        waiters[next++] = place;
        ++blockers[place];
      }
    }
  }
  begins[count] = next;
}

//------------------------------------------------------------------------------
void TileOrder::Release(int seed, const int* ids, int count)
{
  const int* const begins = this->WaitersBegin.data();
  const int* const waiters = this->Waiters.data();
  signed char* const blockers = this->Blockers.data();
  int* const sorted = this->Sorted;
  int done = this->NumberOfSorted;
  // Last in, first out: the cells that came free last are still in cache. The stack grows down from the
  // end of the list: what is on it is not sorted yet.
  int top = count;
  sorted[--top] = seed;
  blockers[seed] = Done;
  while (top < count)
  {
    const int cell = sorted[top++];
    sorted[done++] = ids[cell];
    for (int k = begins[cell]; k < begins[cell + 1]; ++k)
    {
      const int waiter = waiters[k];
      if (--blockers[waiter] == 0)
      {
        blockers[waiter] = Done;
        sorted[--top] = waiter;
      }
    }
  }
  this->NumberOfSorted = done;
}

//------------------------------------------------------------------------------
std::size_t TileOrder::GetMemorySize() const
{
  return this->Places.GetMemorySize() + this->Blockers.capacity() +
    sizeof(int) * (this->Waiters.capacity() + this->WaitersBegin.capacity());
}
