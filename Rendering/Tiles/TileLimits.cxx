#include "TileLimits.h"

#include "TileCells.h"
#include "TileView.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
// Share of u by which rounding may move the end of a piece within its cell.
constexpr double RoundingOfU = 1e-6;
}

//------------------------------------------------------------------------------
bool TileLimits::Build(
  const TileView& view, const float* opaqueDepth, const std::vector<glm::vec4>& planes)
{
  const auto size = static_cast<std::size_t>(view.Width) * view.Height;
  this->TileFar.clear();
  const bool hidden = opaqueDepth && std::any_of(opaqueDepth, opaqueDepth + size,
                                       [](float depth) { return depth < 1.0f; });
  if (!hidden && planes.empty())
  {
    return false;
  }
  this->Planes.resize(planes.size());
  std::transform(planes.begin(), planes.end(), this->Planes.begin(),
    [&](const glm::vec4& plane) { return view.ViewPlaneToScreen * glm::dvec4(plane); });
  this->Near.resize(size);
  this->Far.resize(size);
  vtkSMPTools::For(0, view.Height,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType y = begin; y < end; ++y)
      {
        this->SetRow(view, hidden ? opaqueDepth : nullptr, static_cast<int>(y));
      }
    });
  if (hidden)
  {
    this->FindTileFar(view);
  }
  return true;
}

//------------------------------------------------------------------------------
void TileLimits::SetRow(const TileView& view, const float* opaqueDepth, int y)
{
  for (int x = 0; x < view.Width; ++x)
  {
    const std::size_t pixel = static_cast<std::size_t>(y) * view.Width + x;
    double nearest = 1e30, farthest = -1e30;
    if (opaqueDepth && opaqueDepth[pixel] < 1.0f)
    {
      farthest = view.ScreenDepth(view.DepthOfWindow(opaqueDepth[pixel]));
    }
    for (const glm::dvec4& plane : this->Planes)
    {
      // What stays has value + plane.z * u >= 0.
      const double value = plane.x * x + plane.y * y + plane.w;
      if (plane.z > 0.0)
      {
        farthest = std::max(farthest, -value / plane.z);
      }
      else if (plane.z < 0.0)
      {
        nearest = std::min(nearest, -value / plane.z);
      }
      else if (value < 0.0)
      {
        nearest = -1e30;
      }
    }
    this->Near[pixel] = static_cast<float>(std::max(nearest, -1e30));
    this->Far[pixel] = static_cast<float>(std::min(farthest, 1e30));
  }
}

//------------------------------------------------------------------------------
void TileLimits::FindTileFar(const TileView& view)
{
  this->Tiles[0] = TileSize::CountOf(view.Width);
  this->Tiles[1] = TileSize::CountOf(view.Height);
  this->TileFar.assign(static_cast<std::size_t>(this->Tiles[0]) * this->Tiles[1], 1e30f);
  for (int y = 0; y < view.Height; ++y)
  {
    const float* row = &this->Far[static_cast<std::size_t>(y) * view.Width];
    float* tiles = &this->TileFar[static_cast<std::size_t>(y >> TileSize::Shift) * this->Tiles[0]];
    for (int x = 0; x < view.Width; ++x)
    {
      tiles[x >> TileSize::Shift] = std::min(tiles[x >> TileSize::Shift], row[x]);
    }
  }
}

//------------------------------------------------------------------------------
bool TileLimits::IsBeforeAny(
  const double (&first)[2], const double (&last)[2], double nearest) const
{
  int begin[2], end[2];
  for (int k = 0; k < 2; ++k)
  {
    const double tiles = this->Tiles[k];
    begin[k] = static_cast<int>(std::min(std::max(first[k] / TileSize::Pixels, 0.0), tiles));
    end[k] = static_cast<int>(std::min(std::max(last[k] / TileSize::Pixels + 1.0, 0.0), tiles));
  }
  for (int y = begin[1]; y < end[1]; ++y)
  {
    const float* row = &this->TileFar[static_cast<std::size_t>(y) * this->Tiles[0]];
    if (std::any_of(
          row + begin[0], row + std::max(begin[0], end[0]), [&](float far) { return far < nearest; }))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void TileLimits::FindBlocks(const TileView& view)
{
  constexpr int Size = 1 << BlockShift;
  const int rows = (view.Height + Size - 1) >> BlockShift;
  this->BlocksInRow = (view.Width + Size - 1) >> BlockShift;
  this->Rounding = static_cast<float>(RoundingOfU * view.WeightOffset);
  this->Blocks.resize(static_cast<std::size_t>(rows) * this->BlocksInRow);
  vtkSMPTools::For(0, rows,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto y = static_cast<int>(begin); y < end; ++y)
      {
        this->FindBlockRow(view, y);
      }
    });
}

//------------------------------------------------------------------------------
void TileLimits::FindBlockRow(const TileView& view, int y)
{
  Block* blocks = &this->Blocks[static_cast<std::size_t>(y) * this->BlocksInRow];
  std::fill_n(blocks, this->BlocksInRow, Block{ -3e38f, 3e38f });
  for (int row = y << BlockShift; row < std::min((y + 1) << BlockShift, view.Height); ++row)
  {
    const std::size_t begin = static_cast<std::size_t>(row) * view.Width;
    for (int x = 0; x < view.Width; ++x)
    {
      Block& block = blocks[x >> BlockShift];
      block.Near = std::max(block.Near, this->Near[begin + x]);
      block.Far = std::min(block.Far, this->Far[begin + x]);
    }
  }
}

//------------------------------------------------------------------------------
bool TileLimits::CutsOff(
  const int (&first)[2], const int (&last)[2], float farthest, float nearest) const
{
  nearest += this->Rounding + static_cast<float>(RoundingOfU) * std::abs(nearest);
  farthest -= this->Rounding + static_cast<float>(RoundingOfU) * std::abs(farthest);
  for (int y = first[1] >> BlockShift; y <= last[1] >> BlockShift; ++y)
  {
    const Block* blocks = &this->Blocks[static_cast<std::size_t>(y) * this->BlocksInRow];
    const bool isCut = std::all_of(blocks + (first[0] >> BlockShift),
      blocks + (last[0] >> BlockShift) + 1,
      [&](const Block& block) { return nearest < block.Far || farthest > block.Near; });
    if (!isCut)
    {
      return false;
    }
  }
  return true;
}
