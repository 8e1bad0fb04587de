#include "TileEntries.h"

#include "TileMesh.h"
#include "TilePrefetch.h"
#include "TileTask.h"
#include "TileVertices.h"
#include "TileView.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstddef>

namespace
{
// Cells whose corners are fetched before their turn.
constexpr std::size_t Ahead = 6;

// The first whole number from `at` on, in the tile or at its end.
int FirstFrom(double at, int end)
{
  const double inTile = std::min(std::max(at, 0.0), double(end));
  const auto below = static_cast<int>(inTile);
  return below + (below < inTile ? 1 : 0);
}

HWY_INLINE void Prefetch(const TileTask& task, const std::vector<int>& cells, std::size_t at)
{
  const std::size_t last = cells.size() - 1;
  const int later = cells[std::min(at + 2 * Ahead, last)];
  PrefetchCorners(task, later);
  hwy::Prefetch(&task.Mesh->Neighbours[4 * static_cast<std::size_t>(later)]);
  PrefetchPlaces(task, cells[std::min(at + Ahead, last)]);
}
}

//------------------------------------------------------------------------------
bool TileEntries::AreSingle(
  const TileTask& task, const TileRectangle& tile, const std::vector<int>& cells)
{
  this->Entered.fill(0);
  this->Height = tile.LastY + 1 - tile.Bottom;
  bool isSingle = true;
  for (std::size_t i = 0; isSingle && i < cells.size(); ++i)
  {
    Prefetch(task, cells, i);
    isSingle = this->AddCell(task, tile, cells[i]);
  }
  return isSingle;
}

//------------------------------------------------------------------------------
bool TileEntries::AddCell(const TileTask& task, const TileRectangle& tile, int cell)
{
  const std::size_t first = 4 * static_cast<std::size_t>(cell);
  const bool positive = (task.Mesh->Orientations[cell] > 0) == task.View->KeepsOrientation;
  auto cornerOf = [&](int corner) -> Point
  {
    const float* at =
      &task.Vertices->Values[4 * static_cast<std::size_t>(task.Mesh->Corners[first + corner])];
    return { double(at[0]) - tile.Left, double(at[1]) - tile.Bottom };
  };
  bool isSingle = true;
  for (int f = 0; isSingle && f < 4; ++f)
  {
    if (task.Mesh->Neighbours[first + f] >= 0)
    {
      continue;
    }
    const Point a = cornerOf(TileMesh::FaceCorners[f][0]), b = cornerOf(TileMesh::FaceCorners[f][1]);
    const Point c = cornerOf(TileMesh::FaceCorners[f][2]);
    const double area = (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X);
    const bool enters = area != 0.0 && (area > 0.0) != (TileMesh::IsInward(f) == positive);
    isSingle = !enters || this->AddFace(a, b, c);
  }
  return isSingle;
}

//------------------------------------------------------------------------------
bool TileEntries::AddFace(const Point& a, const Point& b, const Point& c)
{
  this->FlipRightOf(a, b);
  this->FlipRightOf(b, c);
  this->FlipRightOf(a, c);
  const int begin = FirstFrom(std::min({ a.Y, b.Y, c.Y }), this->Height);
  const int end = FirstFrom(std::max({ a.Y, b.Y, c.Y }), this->Height);
  std::uint64_t twice = 0;
  for (int y = begin; y < end; ++y)
  {
    twice |= this->Entered[y] & this->Face[y];
    this->Entered[y] |= this->Face[y];
    this->Face[y] = 0;
  }
  return twice == 0;
}

//------------------------------------------------------------------------------
void TileEntries::FlipRightOf(const Point& a, const Point& b)
{
  const Point& low = a.Y < b.Y ? a : b;
  const Point& high = a.Y < b.Y ? b : a;
  const double perRow = (high.X - low.X) / (high.Y - low.Y);
  const int end = FirstFrom(high.Y, this->Height);
  for (int y = FirstFrom(low.Y, this->Height); y < end; ++y)
  {
    const int x = FirstFrom(low.X + (y - low.Y) * perRow, TileSize::Pixels);
    this->Face[y] ^= x < TileSize::Pixels ? ~std::uint64_t(0) << x : 0;
  }
}
