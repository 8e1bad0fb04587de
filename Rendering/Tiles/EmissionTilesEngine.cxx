#include "EmissionTilesEngine.h"

#include "EmissionProjection.h"

#include <algorithm>

namespace
{
// Emission along the whole extent from which a float's step of it shows.
constexpr double DenseMedium = 300.0;
// What a scalar that is off may change along the whole extent; a cell is a part of it.
constexpr double ScalarEffect = 2e-3;
}

//------------------------------------------------------------------------------
void EmissionTilesEngine::SetMesh(const std::vector<float>& points, const ConvexCellFaces& cells,
  const FacePieces& pieces, const CellPlanes& planes)
{
  this->Frame.SetMesh(points, cells, pieces, planes);
}

//------------------------------------------------------------------------------
void EmissionTilesEngine::SetScalars(const std::vector<float>& values, bool onePerCell)
{
  this->Frame.SetScalars(values, onePerCell, 1.0f);
}

//------------------------------------------------------------------------------
bool EmissionTilesEngine::Render(const ConvexTilesFrame::Scene& scene)
{
  if (!this->Frame.SetView(scene.Camera))
  {
    return false;
  }
  this->Table.Build(*scene.Function);
  ConvexTileFaces::Bounds bounds;
  const double extent = this->Frame.View.LengthOfExtent;
  bounds.Density = std::max(this->Table.GreatestEmission * extent, 1e-30);
  const double scalar = ScalarEffect / std::max(this->Table.GreatestSlope * extent, 1e-30);
  bounds.ScalarError = std::min(std::max(scalar, 1e-6), 1e-4);
  this->Frame.SetCells(scene, bounds, bounds.Density > DenseMedium);
  this->Image.resize(4 * static_cast<std::size_t>(scene.Camera.Width) * scene.Camera.Height);
  this->Frame.Task.Common.Image = this->Image.data();
  return this->Frame.Draw(scene.IsAborted,
    [this](const TileRectangle& tile, const int* cells, int count, TileScratch& scratch)
    { EmissionProjection::Draw(this->Frame.Task, tile, cells, count, this->Table, scratch); });
}
