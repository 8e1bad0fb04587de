#include "TileBins.h"

#include "TileClusters.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace
{
constexpr int Shares = 32;
}

//------------------------------------------------------------------------------
template <class Visit>
void TileBins::VisitShare(const std::vector<std::uint32_t>& boxes, const std::vector<int>* order,
  const TileClusters* clusters, int share, Visit&& visit) const
{
  const std::size_t first = boxes.size() * share / Shares;
  const std::size_t last = boxes.size() * (share + 1) / Shares;
  for (std::size_t i = first; i < last; ++i)
  {
    const int cell = order ? (*order)[i] : static_cast<int>(i);
    if (clusters && !clusters->IsSeen(cell))
    {
      // In the mesh's order the others of its cluster follow.
      i |= order ? 0 : TileClusters::Size - 1;
      continue;
    }
    const std::uint32_t box = boxes[cell];
    // Most cells touch one tile.
    if (((box ^ box >> 8) & 0x00ff00ffu) == 0)
    {
      visit(static_cast<int>(box >> 24) * this->TilesX + static_cast<int>(box & 255), cell);
      continue;
    }
    for (std::uint32_t y = box >> 16 & 255; y <= box >> 24; ++y)
    {
      for (std::uint32_t x = box & 255; x <= (box >> 8 & 255); ++x)
      {
        visit(static_cast<int>(y) * this->TilesX + static_cast<int>(x), cell);
      }
    }
  }
}

//------------------------------------------------------------------------------
void TileBins::Fill(const std::vector<std::uint32_t>& boxes, const std::vector<int>* order,
  const TileClusters* clusters, int tilesX, int tilesY)
{
  const int tiles = tilesX * tilesY;
  this->TilesX = tilesX;
  this->Places.assign(static_cast<std::size_t>(Shares) * tiles, 0);
  auto forShares = [&](auto&& visitOf)
  {
    vtkSMPTools::For(0, Shares, 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType share = begin; share < end; ++share)
        {
          std::size_t* places = &this->Places[share * tiles];
          this->VisitShare(boxes, order, clusters, static_cast<int>(share), visitOf(places));
        }
      });
  };
  forShares([](std::size_t* places) { return [places](int tile, int) { ++places[tile]; }; });
  this->Accumulate(tiles);
  forShares([this](std::size_t* places)
    { return [this, places](int tile, int cell) { this->Cells[places[tile]++] = cell; }; });
}

//------------------------------------------------------------------------------
void TileBins::Accumulate(int tiles)
{
  this->Begin.assign(static_cast<std::size_t>(tiles) + 1, 0);
  std::size_t sum = 0;
  for (int tile = 0; tile < tiles; ++tile)
  {
    this->Begin[tile] = sum;
    for (int share = 0; share < Shares; ++share)
    {
      std::size_t& place = this->Places[static_cast<std::size_t>(share) * tiles + tile];
      const std::size_t count = place;
      place = sum;
      sum += count;
    }
  }
  this->Begin[tiles] = sum;
  this->Cells.resize(sum);
  this->HeaviestFirst.resize(tiles);
  std::iota(this->HeaviestFirst.begin(), this->HeaviestFirst.end(), 0);
  // A stable sort would take memory in every frame.
  std::sort(this->HeaviestFirst.begin(), this->HeaviestFirst.end(),
    [this](int a, int b)
    { return std::make_pair(-this->GetSize(a), a) < std::make_pair(-this->GetSize(b), b); });
}
