#include "TileOrder.h"

#include "TileCells.h"
#include "TileMesh.h"
#include "TileTask.h"
#include "TileVertices.h"
#include "TileView.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>

namespace
{
constexpr short Done = -1;
// Of a tile's depth: free cells of one step come as they are.
constexpr int Steps = 256;
// The depth of what has no place on the screen: it is close to the eye.
constexpr float Unknown = 3e38f;
// Cells whose neighbours are fetched before their turn.
constexpr int Ahead = 12;
// The lowest bit of a set of faces.
constexpr int FirstFace[16] = { 0, 0, 1, 0, 2, 0, 1, 0, 3, 0, 1, 0, 2, 0, 1, 0 };

// How far a cell's nearest corner is.
float DepthOf(const TileTask& task, int cell)
{
  if ((task.Cells->Faces[cell] & TileCells::Exact) != 0)
  {
    return Unknown;
  }
  const int* corners = &task.Mesh->Corners[4 * static_cast<std::size_t>(cell)];
  float u = -3e38f;
  for (int k = 0; k < 4; ++k)
  {
    u = std::max(u, task.Vertices->Values[4 * static_cast<std::size_t>(corners[k]) + 2]);
  }
  const TileView& view = *task.View;
  return view.WeightScale > 0.0 ? 1.0f / (u + static_cast<float>(view.WeightOffset)) : -u;
}
}

//------------------------------------------------------------------------------
bool TileOrder::Sort(const TileTask& task, int* ids, int count, std::vector<int>& work)
{
  const unsigned int flags = this->FindWaiters(*task.Mesh, *task.Cells, ids, count);
  work.resize(static_cast<std::size_t>(count));
  this->Sorted = work.data();
  this->NumberOfSorted = 0;
  if (task.Mesh->IsSparse)
  {
    this->FindSteps(task, ids, count);
    this->ReleaseNearest(ids, count);
  }
  else
  {
    this->ReleaseAll(ids, count);
  }
  const bool hasCircles = this->NumberOfSorted < count;
  // What is left hides each other in circles.
  for (int i = 0; i < count && this->NumberOfSorted < count; ++i)
  {
    if (this->Blockers[i] != Done)
    {
      this->Sorted[this->NumberOfSorted++] = ids[i];
    }
  }
  std::copy_n(this->Sorted, count, ids);
  return !hasCircles && !task.Mesh->IsSparse &&
    (flags & (TileCells::Unsure | TileCells::Exact)) == 0;
}

//------------------------------------------------------------------------------
void TileOrder::FindSteps(const TileTask& task, const int* ids, int count)
{
  this->Depths.resize(static_cast<std::size_t>(count));
  float nearest = 3e38f, farthest = -3e38f;
  for (int i = 0; i < count; ++i)
  {
    const float depth = DepthOf(task, ids[i]);
    this->Depths[i] = depth;
    nearest = std::min(nearest, depth);
    farthest = depth < Unknown ? std::max(farthest, depth) : farthest;
  }
  const float perStep = nearest < farthest ? (Steps - 1) / (farthest - nearest) : 0.0f;
  this->StepOf.resize(static_cast<std::size_t>(count));
  std::transform(this->Depths.begin(), this->Depths.end(), this->StepOf.begin(),
    [&](float depth)
    { return depth < Unknown ? static_cast<int>((depth - nearest) * perStep) : 0; });
}

//------------------------------------------------------------------------------
void TileOrder::ReleaseNearest(const int* ids, int count)
{
  // The free cells of every step are a list.
  this->NextFree.resize(static_cast<std::size_t>(count));
  std::array<int, Steps> first;
  first.fill(TilePlaces::None);
  auto release = [&](int place, int step)
  {
    this->NextFree[place] = first[step];
    first[step] = place;
    this->Blockers[place] = Done;
  };
  for (int place = count - 1; place >= 0; --place)
  {
    if (this->Blockers[place] == 0)
    {
      release(place, this->StepOf[place]);
    }
  }
  for (int step = 0; step < Steps; ++step)
  {
    while (first[step] != TilePlaces::None)
    {
      const int cell = first[step];
      first[step] = this->NextFree[cell];
      this->Sorted[this->NumberOfSorted++] = ids[cell];
      for (int k = this->WaitersBegin[cell]; k < this->WaitersBegin[cell + 1]; ++k)
      {
        const int waiter = this->Waiters[k];
        if (--this->Blockers[waiter] == 0)
        {
          release(waiter, std::max(step, this->StepOf[waiter]));
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
unsigned int TileOrder::FindWaiters(const TileMesh& mesh, const TileCells& cells, const int* ids, int count)
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
  unsigned int flags = 0;
  for (int i = 0; i < count; ++i)
  {
    this->WaitersBegin[i] = next;
    flags |= cells.Faces[ids[i]];
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
  return flags;
}

//------------------------------------------------------------------------------
void TileOrder::ReleaseAll(const int* ids, int count)
{
  for (int seed = 0; seed < count; ++seed)
  {
    if (this->Blockers[seed] == 0)
    {
      this->Release(seed, ids, count);
    }
  }
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
    sizeof(float) * this->Depths.capacity() +
    sizeof(int) * (this->Waiters.capacity() + this->WaitersBegin.capacity() +
                    this->StepOf.capacity() + this->NextFree.capacity());
}
