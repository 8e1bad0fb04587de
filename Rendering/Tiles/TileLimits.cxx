#include "TileLimits.h"

#include "TileCells.h"
#include "TileView.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstddef>

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
