#include "TileOcclusion.h"

#include "TileBox.h"
#include "TileBuffer.h"
#include "TileCells.h"
#include "TileFragments.h"
#include "TileMesh.h"
#include "TileTask.h"
#include "TileVertices.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
// Hides nothing: every u is nearer.
constexpr float Open = -3e38f;
// The optical depth that leaves NextToNone of the light.
constexpr double DeepestVisible = 16.0;
// Of the two fragments that are looked at in each queue, those in vain for which blocks are found anew.
constexpr int Worthwhile = 8;
// Pixels by which rounding may miss a cell's edge.
constexpr float Margin = 1.0f / 64.0f;
}

//------------------------------------------------------------------------------
void TileOcclusion::Clear(const TileTask& task, const TileRectangle& tile, bool isInOrder)
{
  static_assert(Size * InRow == TileSize::Pixels, "blocks fill a tile");
  this->Depths.fill(Open);
  this->Last = { tile.LastX - tile.Left, tile.LastY - tile.Bottom };
  this->InVain = 0;
  this->Hides = false;
  this->IsInOrder = isInOrder;
  this->MayHide = task.EndsEarly && task.OpticalDepth > DeepestVisible;
}

//------------------------------------------------------------------------------
void TileOcclusion::Watch(const TileFragments& fragments, const TileBuffer& buffer)
{
  if (!this->MayHide || fragments.Count == 0)
  {
    return;
  }
  for (const int at : { 0, fragments.Count / 2 })
  {
    this->InVain += buffer.Pixels[fragments.Pixel[at]].Through < NextToNone ? 1 : 0;
  }
  if (this->InVain >= Worthwhile)
  {
    this->FindBlocks(buffer);
    this->InVain = 0;
  }
}

//------------------------------------------------------------------------------
void TileOcclusion::FindBlocks(const TileBuffer& buffer)
{
  for (int y = 0; y <= this->Last[1] >> Shift; ++y)
  {
    for (int x = 0; x <= this->Last[0] >> Shift; ++x)
    {
      // What hides stays: later pieces move the pixels' last exits, not what is seen.
      if (this->Depths[y * InRow + x] == Open)
      {
        this->FindBlock(buffer, x, y);
      }
    }
  }
}

//------------------------------------------------------------------------------
void TileOcclusion::FindBlock(const TileBuffer& buffer, int x, int y)
{
  float depth = 3e38f;
  for (int row = y * Size; row <= std::min(y * Size + Size - 1, this->Last[1]); ++row)
  {
    const int begin = row * TileSize::Pixels + x * Size;
    const int end = row * TileSize::Pixels + std::min(x * Size + Size - 1, this->Last[0]);
    for (int pixel = begin; pixel <= end; ++pixel)
    {
      if (!(buffer.Pixels[pixel].Through < NextToNone))
      {
        return;
      }
      depth = this->IsInOrder ? depth : std::min(depth, buffer.LastExits[pixel]);
    }
  }
  this->Depths[y * InRow + x] = depth;
  this->Hides = true;
}

//------------------------------------------------------------------------------
bool TileOcclusion::HidesCell(
  const TileTask& task, const TileRectangle& tile, int cell, std::uint32_t& box) const
{
  // Of its corners some have no place on the screen.
  if ((task.Cells->Faces[cell] & TileCells::Exact) != 0)
  {
    return false;
  }
  const int* corners = &task.Mesh->Corners[4 * static_cast<std::size_t>(cell)];
  const float* point = &task.Vertices->Values[4 * static_cast<std::size_t>(corners[0])];
  float low[2] = { point[0], point[1] }, high[2] = { point[0], point[1] }, nearest = point[2];
  for (int corner = 1; corner < 4; ++corner)
  {
    point = &task.Vertices->Values[4 * static_cast<std::size_t>(corners[corner])];
    for (int k = 0; k < 2; ++k)
    {
      low[k] = std::min(low[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
    nearest = std::max(nearest, point[2]);
  }
  const int corner[2] = { tile.Left, tile.Bottom };
  int first[2], last[2];
  for (int k = 0; k < 2; ++k)
  {
    const auto begin = static_cast<int>(std::ceil(low[k] - Margin)) - corner[k];
    const auto end = static_cast<int>(std::floor(high[k] + Margin)) - corner[k];
    first[k] = std::max(begin, 0);
    last[k] = std::min(end, this->Last[k]);
  }
  return this->HidesBox(first, last, nearest, box);
}

//------------------------------------------------------------------------------
bool TileOcclusion::HidesBox(
  const int (&first)[2], const int (&last)[2], float nearest, std::uint32_t& box) const
{
  box = 0;
  if (first[0] > last[0] || first[1] > last[1])
  {
    return true;
  }
  for (int y = first[1] >> Shift; y <= last[1] >> Shift; ++y)
  {
    for (int x = first[0] >> Shift; x <= last[0] >> Shift; ++x)
    {
      if (this->Depths[y * InRow + x] < nearest)
      {
        return false;
      }
    }
  }
  box = TileBox::Pack(
    first[0], first[1], last[0] - first[0] + 1, last[1] - first[1] + 1);
  return true;
}
