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
  return std::any_of(row, row + mesh.Faces.GetSize(cell),
    [&](int face) { return faces.Values[face].Side == 0.0f; });
}

ConvexTileCells::Depths FindDepths(
  const ConvexTileMesh& mesh, const TileVertices& vertices, int cell)
{
  const int* ids = mesh.Corners.GetRow(cell);
  ConvexTileCells::Depths depths = { TileVertices::OffScreen, -TileVertices::OffScreen };
  for (int i = 0; i < mesh.Corners.GetSize(cell); ++i)
  {
    const float* corner = &vertices.Values[4 * static_cast<std::size_t>(ids[i])];
    if (corner[0] == TileVertices::OffScreen)
    {
      return { -TileVertices::OffScreen, TileVertices::OffScreen };
    }
    depths.Farthest = std::min(depths.Farthest, corner[2]);
    depths.Nearest = std::max(depths.Nearest, corner[2]);
  }
  return depths;
}

bool FallsFar(const TileView& view, const ConvexTileCells::Depths& depths)
{
  return view.WeightScale * depths.Farthest + view.WeightOffset <
         ConvexTileCells::LeastShare * (view.WeightScale * depths.Nearest + view.WeightOffset);
}

std::array<int, 4> FindBox(
  const ConvexTileMesh& mesh, const TileView& view, const TileVertices& vertices, int cell)
{
  const int* ids = mesh.Corners.GetRow(cell);
  float low[2] = { TileVertices::OffScreen, TileVertices::OffScreen };
  float high[2] = { -TileVertices::OffScreen, -TileVertices::OffScreen };
  for (int i = 0; i < mesh.Corners.GetSize(cell); ++i)
  {
    const float* corner = &vertices.Values[4 * static_cast<std::size_t>(ids[i])];
    for (int k = 0; k < 2; ++k)
    {
      low[k] = std::min(low[k], corner[k]);
      high[k] = std::max(high[k], corner[k]);
    }
  }
  return { { static_cast<int>(std::ceil(std::max(low[0], 0.0f))),
    static_cast<int>(std::ceil(std::max(low[1], 0.0f))),
    static_cast<int>(std::floor(std::min(high[0], static_cast<float>(view.Width - 1)))),
    static_cast<int>(std::floor(std::min(high[1], static_cast<float>(view.Height - 1)))) } };
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
  this->Ranges[cell] = FindDepths(mesh, vertices, cell);
  isExact = isExact || HasFaceInDoubt(mesh, faces, cell) || FallsFar(view, this->Ranges[cell]);
  this->Exact[cell] = isExact ? 1 : 0;
  this->SetBox(cell,
    isExact ? ConvexTileExactCell::FindBox(mesh, view, cell)
            : FindBox(mesh, view, vertices, cell));
}
