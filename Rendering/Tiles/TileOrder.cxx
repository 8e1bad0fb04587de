#include "TileOrder.h"

#include "TileCells.h"
#include "TileMesh.h"

#include <algorithm>

namespace
{
constexpr int Done = -1;
// The lowest bit of a set of faces.
constexpr int FirstFace[16] = { 0, 0, 1, 0, 2, 0, 1, 0, 3, 0, 1, 0, 2, 0, 1, 0 };
}

//------------------------------------------------------------------------------
void TileOrder::Sort(const TileMesh& mesh, const TileCells& cells, int* ids, int count)
{
  this->FindWaiters(mesh, cells, ids, count);
  this->Sorted.clear();
  for (int seed = 0; seed < count; ++seed)
  {
    if (this->Blockers[seed] == 0)
    {
      this->Release(seed, ids);
    }
  }
  // What is left hides each other in circles.
  for (int i = 0; i < count && this->Sorted.size() < static_cast<std::size_t>(count); ++i)
  {
    if (this->Blockers[i] != Done)
    {
      this->Sorted.push_back(ids[i]);
    }
  }
  std::copy(this->Sorted.begin(), this->Sorted.end(), ids);
}

//------------------------------------------------------------------------------
void TileOrder::FindWaiters(const TileMesh& mesh, const TileCells& cells, const int* ids, int count)
{
  const auto size = static_cast<std::size_t>(count);
  this->Place.resize(mesh.Source.size());
  this->Waiters.resize(4 * size);
  this->NumberOfWaiters.resize(size);
  this->Blockers.assign(size, 0);
  this->Stack.resize(size);
  this->Sorted.reserve(size);
  for (int i = 0; i < count; ++i)
  {
    this->Place[ids[i]] = i;
  }
  for (int i = 0; i < count; ++i)
  {
    const int* neighbours = &mesh.Neighbours[4 * static_cast<std::size_t>(ids[i])];
    const unsigned int exits = cells.Faces[ids[i]] & TileCells::ExitFaces;
    int* waiters = &this->Waiters[4 * static_cast<std::size_t>(i)];
    std::uint8_t found = 0;
    for (unsigned int left = exits; left != 0; left &= left - 1)
    {
      const int behind = neighbours[FirstFace[left]];
      const int place = this->Place[behind];
      if (place >= 0 && place < count && ids[place] == behind)
      {
        waiters[found++] = place;
        ++this->Blockers[place];
      }
    }
    this->NumberOfWaiters[i] = found;
  }
}

//------------------------------------------------------------------------------
void TileOrder::Release(int seed, const int* ids)
{
  // Last in, first out: the cells that came free last are still in cache.
  int top = 0;
  this->Stack[top++] = seed;
  this->Blockers[seed] = Done;
  while (top > 0)
  {
    const int cell = this->Stack[--top];
    this->Sorted.push_back(ids[cell]);
    const int* waiters = &this->Waiters[4 * static_cast<std::size_t>(cell)];
    for (int k = 0; k < this->NumberOfWaiters[cell]; ++k)
    {
      if (--this->Blockers[waiters[k]] == 0)
      {
        this->Blockers[waiters[k]] = Done;
        this->Stack[top++] = waiters[k];
      }
    }
  }
}
