#include "EmissionTilesEngine.h"

#include "EmissionProjection.h"

#include <algorithm>

namespace
{
// Emission along the whole extent from which a float's step of it shows.
constexpr double DenseMedium = 300.0;
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
  bounds.Density = std::max(this->Table.GreatestEmission * this->Frame.View.LengthOfExtent, 1e-30);
  this->Frame.SetCells(scene, bounds, bounds.Density > DenseMedium);
  this->Image.resize(4 * static_cast<std::size_t>(scene.Camera.Width) * scene.Camera.Height);
  this->Frame.Task.Common.Image = this->Image.data();
  this->Frame.Draw(
    [this](const TileRectangle& tile, const int* cells, int count, TileScratch& scratch)
    { EmissionProjection::Draw(this->Frame.Task, tile, cells, count, this->Table, scratch); });
  return true;
}
