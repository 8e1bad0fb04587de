#include "TileOrder.h"

#include "TileCells.h"
#include "TileMesh.h"

#include <hwy/cache_control.h>

#include <algorithm>

namespace
{
constexpr short Done = -1;
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
  int next = 0;
  for (int i = 0; i < count; ++i)
  {
    this->WaitersBegin[i] = next;
    hwy::Prefetch(&mesh.Neighbours[4 * static_cast<std::size_t>(ids[std::min(i + Ahead, count - 1)])]);
    const int* neighbours = &mesh.Neighbours[4 * static_cast<std::size_t>(ids[i])];
    const unsigned int exits = cells.Faces[ids[i]] & TileCells::ExitFaces;
    for (unsigned int left = exits; left != 0; left &= left - 1)
    {
      const int place = this->Places.Find(neighbours[FirstFace[left]]);
      if (place != TilePlaces::None)
      {
        this->Waiters[next++] = place;
        ++this->Blockers[place];
      }
    }
  }
  this->WaitersBegin[size] = next;
}

//------------------------------------------------------------------------------
void TileOrder::Release(int seed, const int* ids, int count)
{
  // Last in, first out: the cells that came free last are still in cache. The stack grows down from the
  // end of the list: what is on it is not sorted yet.
  int top = count;
  this->Sorted[--top] = seed;
  this->Blockers[seed] = Done;
  while (top < count)
  {
    const int cell = this->Sorted[top++];
    this->Sorted[this->NumberOfSorted++] = ids[cell];
    for (int k = this->WaitersBegin[cell]; k < this->WaitersBegin[cell + 1]; ++k)
    {
      const int waiter = this->Waiters[k];
      if (--this->Blockers[waiter] == 0)
      {
        this->Blockers[waiter] = Done;
        this->Sorted[--top] = waiter;
      }
    }
  }
}

//------------------------------------------------------------------------------
std::size_t TileOrder::GetMemorySize() const
{
  return this->Places.GetMemorySize() + sizeof(short) * this->Blockers.capacity() +
    sizeof(int) * (this->Waiters.capacity() + this->WaitersBegin.capacity());
}
