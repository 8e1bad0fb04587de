#include "ConvexTileCells.h"

#include "ConvexTileExactCell.h"
#include "ConvexTileFaces.h"
#include "ConvexTileMesh.h"
#include "TileCells.h"
#include "TileVertices.h"
#include "TileView.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
bool HasFaceInDoubt(const ConvexTileMesh& mesh, const ConvexTileFaces& faces, int cell)
{
  const int* row = mesh.Cells->Faces.GetRow(cell);
  return std::any_of(row, row + mesh.Cells->Faces.GetSize(cell),
    [&](int face) { return faces.Values[face].Side == 0.0f; });
}

bool FallsFar(
  const ConvexTileMesh& mesh, const TileView& view, const TileVertices& vertices, int cell)
{
  const int* ids = mesh.Cells->Corners.GetRow(cell);
  float low = vertices.Values[4 * static_cast<std::size_t>(ids[0]) + 2], high = low;
  for (int i = 1; i < mesh.Cells->Corners.GetSize(cell); ++i)
  {
    const float u = vertices.Values[4 * static_cast<std::size_t>(ids[i]) + 2];
    low = std::min(low, u);
    high = std::max(high, u);
  }
  return view.WeightScale * low + view.WeightOffset <
         ConvexTileCells::LeastShare * (view.WeightScale * high + view.WeightOffset);
}

std::array<int, 4> FindBox(
  const ConvexTileMesh& mesh, const TileView& view, const TileVertices& vertices, int cell)
{
  const int* ids = mesh.Cells->Corners.GetRow(cell);
  float low[2] = { TileVertices::OffScreen, TileVertices::OffScreen };
  float high[2] = { -TileVertices::OffScreen, -TileVertices::OffScreen };
  for (int i = 0; i < mesh.Cells->Corners.GetSize(cell); ++i)
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
  const TileVertices& vertices, const ConvexTileFaces& faces, bool allExact)
{
  const auto cells = static_cast<std::size_t>(mesh.GetNumberOfCells());
  this->Tiles.resize(cells);
  this->Boxes.resize(cells);
  this->Exact.resize(cells);
  vtkSMPTools::For(0, static_cast<vtkIdType>(cells),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto cell = static_cast<int>(begin); cell < end; ++cell)
      {
        if (!mesh.Drawn[cell])
        {
          this->SetBox(cell, { { 0, 0, -1, -1 } });
          continue;
        }
        const bool isExact = allExact || HasFaceInDoubt(mesh, faces, cell) ||
                             FallsFar(mesh, view, vertices, cell);
        this->Exact[cell] = isExact ? 1 : 0;
        this->SetBox(cell,
          this->Exact[cell] ? ConvexTileExactCell::FindBox(mesh, view, cell)
                            : FindBox(mesh, view, vertices, cell));
      }
    });
}
