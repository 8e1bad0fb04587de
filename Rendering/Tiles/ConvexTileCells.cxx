#include "ConvexTileCells.h"

#include "ConvexTileExactCell.h"
#include "ConvexTileFaces.h"
#include "ConvexTileMesh.h"
#include "TileCells.h"
#include "TileClusters.h"
#include "TileVertices.h"
#include "TileView.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
bool HasFaceInDoubt(const ConvexTileMesh& mesh, const ConvexTileFaces& faces, int cell)
{
  const int* row = mesh.Faces.GetRow(cell);
  unsigned char isAny = 0;
  for (int i = 0; i < mesh.Faces.GetSize(cell); ++i)
  {
    isAny |= faces.InDoubt[row[i]];
  }
  return isAny != 0;
}

/// Least and greatest x, y and u of a cell's corners; a corner without a place on the screen is OffScreen.
struct Extent
{
  float Low[4], High[4];

  Extent(const ConvexTileMesh& mesh, const TileVertices& vertices, int cell)
  {
    const int* ids = mesh.Corners.GetRow(cell);
    const int count = mesh.Corners.GetSize(cell);
    std::fill_n(this->Low, 4, TileVertices::OffScreen);
    std::fill_n(this->High, 4, -TileVertices::OffScreen);
    for (int i = 0; i < count; ++i)
    {
      // The fourth, the scalar, comes along: all four are one vector.
      const float* corner = &vertices.Values[4 * static_cast<std::size_t>(ids[i])];
      for (int k = 0; k < 4; ++k)
      {
        this->Low[k] = std::min(corner[k], this->Low[k]);
        this->High[k] = std::max(corner[k], this->High[k]);
      }
    }
  }

  bool IsOnScreen() const { return this->High[0] < TileVertices::OffScreen; }

  ConvexTileCells::Depths GetDepths() const
  {
    return this->IsOnScreen() ? ConvexTileCells::Depths{ this->Low[2], this->High[2] }
                              : ConvexTileCells::Depths{ -TileVertices::OffScreen, TileVertices::OffScreen };
  }

  /// The pixels inside of it and `margin` beyond.
  std::array<int, 4> GetBox(const TileView& view, float margin) const
  {
    const float lastX = static_cast<float>(view.Width - 1), lastY = static_cast<float>(view.Height - 1);
    return { { static_cast<int>(std::ceil(std::max(this->Low[0] - margin, 0.0f))),
      static_cast<int>(std::ceil(std::max(this->Low[1] - margin, 0.0f))),
      static_cast<int>(std::floor(std::min(this->High[0] + margin, lastX))),
      static_cast<int>(std::floor(std::min(this->High[1] + margin, lastY))) } };
  }
};

bool FallsFar(const TileView& view, const ConvexTileCells::Depths& depths)
{
  return view.WeightScale * depths.Farthest + view.WeightOffset <
         ConvexTileCells::LeastShare * (view.WeightScale * depths.Nearest + view.WeightOffset);
}
}

//------------------------------------------------------------------------------
void ConvexTileCells::SetBox(int cell, const std::array<int, 4>& box)
{
  const bool isEmpty = box[2] < box[0] || box[3] < box[1];
  auto tile = [&](int i) { return static_cast<std::uint32_t>(box[i]) >> TileSize::Shift; };
  this->Tiles[cell] =
    isEmpty ? TileCells::NoTile : tile(0) | tile(2) << 8 | tile(1) << 16 | tile(3) << 24;
  for (int i = 0; i < 4; ++i)
  {
    this->Boxes[cell][i] = static_cast<short>(isEmpty ? i < 2 ? 0 : -1 : box[i]);
  }
}

//------------------------------------------------------------------------------
void ConvexTileCells::Project(const ConvexTileMesh& mesh, const TileView& view,
  const TileVertices& vertices, const TileClusters& clusters, const ConvexTileFaces& faces,
  bool allExact)
{
  const int cells = mesh.GetNumberOfCells();
  this->Tiles.resize(static_cast<std::size_t>(cells));
  this->Boxes.resize(static_cast<std::size_t>(cells));
  this->Exact.resize(static_cast<std::size_t>(cells));
  this->Ranges.resize(static_cast<std::size_t>(cells));
  constexpr int Size = TileClusters::Size;
  vtkSMPTools::For(0, (cells + Size - 1) / Size, 32,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto cluster = static_cast<int>(begin); cluster < end; ++cluster)
      {
        const int first = cluster * Size, last = std::min(first + Size, cells);
        std::fill(this->Tiles.begin() + first, this->Tiles.begin() + last, TileCells::NoTile);
        for (int cell = first; clusters.IsSeen(first) && cell < last; ++cell)
        {
          if (mesh.Drawn[cell])
          {
            this->ProjectCell(mesh, view, vertices, faces, allExact, cell);
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
void ConvexTileCells::ProjectCell(const ConvexTileMesh& mesh, const TileView& view,
  const TileVertices& vertices, const ConvexTileFaces& faces, bool isExact, int cell)
{
  const Extent extent(mesh, vertices, cell);
  this->Ranges[cell] = extent.GetDepths();
  const bool fallsFar = FallsFar(view, this->Ranges[cell]);
  isExact = isExact || fallsFar || HasFaceInDoubt(mesh, faces, cell);
  this->Exact[cell] = !isExact ? None : fallsFar || !extent.IsOnScreen() ? AlongRays : OnScreen;
  const auto margin = static_cast<float>(isExact ? ConvexTileExactCell::Margin : 0.0);
  this->SetBox(cell,
    extent.IsOnScreen() ? extent.GetBox(view, margin)
                        : ConvexTileExactCell::FindBox(mesh, view, cell));
}
