#include "TileOrder.h"

#include "TileCells.h"
#include "TileMesh.h"
#include "TilePrefetch.h"
#include "TileTask.h"
#include "TileVertices.h"
#include "TileView.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>

namespace
{
// More than the number of cells before any one.
constexpr std::uint8_t Present = 128;
// Free cells that are taken at a time, so that none waits for what the one before it finds.
constexpr std::size_t Batch = 4;
// Of a tile's depth: free cells of one step come as they are.
constexpr int Steps = 256;
constexpr int None = -1;
// The depth of what has no place on the screen: it is close to the eye.
constexpr float Unknown = 3e38f;

// What says which cells are behind one, and the numbers of class TileOrder that this changes. All four
// faces take the same steps, since no processor guesses which of them rays leave through.
struct Links
{
  const int* Neighbours;
  const std::uint8_t* Faces;
  std::uint8_t* Blockers;

  template <class Visit>
  void VisitFaces(int cell, const Visit& visit) const
  {
    const int* neighbours = this->Neighbours + 4 * static_cast<std::size_t>(cell);
    const std::array<int, 4> behind = { neighbours[0], neighbours[1], neighbours[2], neighbours[3] };
    const unsigned int faces = this->Faces[cell];
    for (int f = 0; f < 4; ++f)
    {
      visit(behind[f], faces >> f & 1);
    }
  }

  // Cells of other tiles count too, never come free, and are back at 0 after all.
  void Count(int cell) const
  {
    this->VisitFaces(cell, [this](int behind, unsigned int isExit)
      { this->Blockers[behind] = static_cast<std::uint8_t>(this->Blockers[behind] + isExit); });
  }

  // `free`: is given each neighbour, and 1 if this was the last one that it waited for, else 0.
  template <class Free>
  void Release(int cell, const Free& free) const
  {
    this->VisitFaces(cell,
      [&](int behind, unsigned int isExit)
      {
        const auto left = static_cast<std::uint8_t>(this->Blockers[behind] - isExit);
        this->Blockers[behind] = left;
        free(behind, isExit & (left == Present ? 1u : 0u));
      });
  }
};

Links LinksOf(const TileTask& task, std::vector<std::uint8_t>& blockers)
{
  // A face without a neighbour has -1.
  return { task.Mesh->Neighbours.data(), task.Cells->Faces.data(), blockers.data() + 1 };
}

// Cells fetch the corners of those that come so many later.
constexpr int Ahead = 8;

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
  const unsigned int flags = this->CountBlockers(task, ids, count);
  work.resize(static_cast<std::size_t>(count) + Batch);
  int* sorted = work.data();
  if (task.Mesh->IsSparse)
  {
    this->FindSteps(task, ids, count);
  }
  const int taken = task.Mesh->IsSparse ? this->ReleaseNearest(task, ids, count, sorted)
                                        : this->ReleaseAll(task, ids, count, sorted);
  if (taken < count)
  {
    this->TakeCircles(task, ids, count, sorted, taken);
  }
  std::copy_n(sorted, count, ids);
  return taken == count && !task.Mesh->IsSparse &&
    (flags & (TileCells::Unsure | TileCells::Exact)) == 0;
}

//------------------------------------------------------------------------------
unsigned int TileOrder::CountBlockers(const TileTask& task, const int* ids, int count)
{
  this->Blockers.resize(task.Mesh->Source.size() + 1, 0);
  const Links links = LinksOf(task, this->Blockers);
  for (int i = 0; i < count; ++i)
  {
    links.Blockers[ids[i]] = Present;
    hwy::Prefetch(links.Neighbours + 4 * static_cast<std::size_t>(ids[i]));
  }
  this->Entered.resize(static_cast<std::size_t>(count));
  int* entered = this->Entered.data();
  unsigned int flags = 0;
  for (int i = 0; i < count; ++i)
  {
    const unsigned int faces = links.Faces[ids[i]];
    flags |= faces;
    *entered = ids[i];
    entered += (faces & TileCells::Entered) != 0 ? 1 : 0;
    links.Count(ids[i]);
  }
  this->Entered.resize(static_cast<std::size_t>(entered - this->Entered.data()));
  return flags;
}

//------------------------------------------------------------------------------
int TileOrder::ReleaseAll(const TileTask& task, const int* ids, int count, int* sorted)
{
  const Links links = LinksOf(task, this->Blockers);
  // Last in, first out: the cells that came free last are still in cache. The stack grows down from the
  // end of the list: what is on it is not sorted yet, and what it writes below its top stays clear of what is.
  const std::size_t end = static_cast<std::size_t>(count) + Batch;
  std::size_t top = end, next = 0;
  auto push = [&](int cell, unsigned int isFree)
  {
    sorted[top - 1] = cell;
    top -= isFree;
  };
  for (int i = count - 1; i >= 0; --i)
  {
    push(ids[i], links.Blockers[ids[i]] == Present ? 1 : 0);
  }
  while (top < end)
  {
    const std::size_t last = next + std::min(Batch, end - top);
    for (std::size_t i = next; i < last; ++i)
    {
      sorted[i] = sorted[top++];
      links.Blockers[sorted[i]] = 0;
    }
    for (; next < last; ++next)
    {
      links.Release(sorted[next], push);
    }
  }
  return static_cast<int>(next);
}

//------------------------------------------------------------------------------
void TileOrder::FindSteps(const TileTask& task, const int* ids, int count)
{
  this->Depths.resize(static_cast<std::size_t>(count));
  float nearest = 3e38f, farthest = -3e38f;
  for (int i = 0; i < count; ++i)
  {
    PrefetchCorners(task, ids[std::min(i + 2 * Ahead, count - 1)]);
    PrefetchPlaces(task, ids[std::min(i + Ahead, count - 1)]);
    const float depth = DepthOf(task, ids[i]);
    this->Depths[i] = depth;
    nearest = std::min(nearest, depth);
    farthest = depth < Unknown ? std::max(farthest, depth) : farthest;
  }
  const float perStep = nearest < farthest ? (Steps - 1) / (farthest - nearest) : 0.0f;
  this->StepOf.resize(task.Mesh->Source.size() + 1);
  std::uint8_t* const stepOf = this->StepOf.data() + 1;
  for (int i = 0; i < count; ++i)
  {
    const float depth = this->Depths[i];
    // What is not a number comes first.
    const float step = depth < Unknown ? std::max(0.0f, (depth - nearest) * perStep) : 0.0f;
    stepOf[ids[i]] = static_cast<std::uint8_t>(std::min(step, Steps - 1.0f));
  }
}

//------------------------------------------------------------------------------
int TileOrder::ReleaseNearest(const TileTask& task, const int* ids, int count, int* sorted)
{
  const Links links = LinksOf(task, this->Blockers);
  const std::uint8_t* const stepOf = this->StepOf.data() + 1;
  // The free cells of every step are a list. As in ReleaseAll no branch asks which neighbours came free: each is written to
  // the next place of FreeCells, which is kept if it did.
  this->FreeCells.resize(static_cast<std::size_t>(count) + 1);
  FreeCell* const free = this->FreeCells.data();
  std::array<int, Steps> first;
  first.fill(None);
  int added = 0;
  auto add = [&](int cell, int step, unsigned int isFree)
  {
    free[added] = { cell, first[step] };
    first[step] = isFree != 0 ? added : first[step];
    added += static_cast<int>(isFree);
  };
  for (int i = count - 1; i >= 0; --i)
  {
    add(ids[i], stepOf[ids[i]], links.Blockers[ids[i]] == Present ? 1 : 0);
  }
  int taken = 0;
  for (int step = 0; step < Steps; ++step)
  {
    while (first[step] != None)
    {
      int last = taken;
      for (; first[step] != None && last < taken + static_cast<int>(Batch); ++last)
      {
        const FreeCell& next = free[first[step]];
        sorted[last] = next.Cell;
        links.Blockers[next.Cell] = 0;
        first[step] = next.Next;
      }
      for (; taken < last; ++taken)
      {
        links.Release(sorted[taken], [&](int cell, unsigned int isFree)
          { add(cell, std::max<int>(step, stepOf[cell]), isFree); });
      }
    }
  }
  return taken;
}

//------------------------------------------------------------------------------
void TileOrder::TakeCircles(
  const TileTask& task, const int* ids, int count, int* sorted, int taken)
{
  const Links links = LinksOf(task, this->Blockers);
  // What is left hides each other in circles, or is behind such.
  std::copy_if(ids, ids + count, sorted + taken,
    [&links](int cell) { return links.Blockers[cell] >= Present; });
  // Each of them is behind another one.
  for (int i = taken; i < count; ++i)
  {
    links.VisitFaces(sorted[i], [&links](int behind, unsigned int) { links.Blockers[behind] = 0; });
  }
}

//------------------------------------------------------------------------------
std::size_t TileOrder::GetMemorySize() const
{
  return this->Blockers.capacity() + this->StepOf.capacity() +
    sizeof(int) * this->Entered.capacity() + sizeof(float) * this->Depths.capacity() +
    sizeof(FreeCell) * this->FreeCells.capacity();
}
