#include "ExtremumTilesEngine.h"

#include "ExtremumProjection.h"
#include "TransferFunction.h"
#include "vtkSMPTools.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

//------------------------------------------------------------------------------
void ExtremumTilesEngine::SetMesh(const std::vector<float>& points, const ConvexCellFaces& cells,
  const FacePieces& pieces, const CellPlanes& planes)
{
  this->Frame.SetMesh(points, cells, pieces, planes);
}

//------------------------------------------------------------------------------
void ExtremumTilesEngine::SetScalars(
  const std::vector<float>& values, bool onePerCell, bool findLeast)
{
  this->Sign = findLeast ? -1.0f : 1.0f;
  this->Frame.SetScalars(values, onePerCell, this->Sign);
  this->OrderCells();
}

//------------------------------------------------------------------------------
void ExtremumTilesEngine::OrderCells()
{
  const int cells = this->Frame.Mesh.GetNumberOfCells();
  this->Greatest.resize(static_cast<std::size_t>(cells));
  for (int cell = 0; cell < cells; ++cell)
  {
    // Cells without a number are not drawn; a sort needs one.
    const float greatest = this->Frame.Mesh.FindGreatest(cell);
    this->Greatest[cell] =
      std::isnan(greatest) ? std::numeric_limits<float>::lowest() : greatest;
  }
  this->Order.resize(this->Greatest.size());
  std::iota(this->Order.begin(), this->Order.end(), 0);
  vtkSMPTools::Sort(this->Order.begin(), this->Order.end(),
    [this](int a, int b)
    {
      return this->Greatest[a] > this->Greatest[b] ||
             (this->Greatest[a] == this->Greatest[b] && a < b);
    });
  this->Frame.SetOrder(&this->Order);
}

//------------------------------------------------------------------------------
bool ExtremumTilesEngine::Render(const ConvexTilesFrame::Scene& scene)
{
  if (!this->Frame.SetView(scene.Camera))
  {
    return false;
  }
  ConvexTileFaces::Bounds bounds;
  bounds.ScalarError = 4e-6;
  // Where rays are cut the place of a face counts, elsewhere its scalar alone.
  const bool isCut = scene.OpaqueDepth || !scene.ClippingPlanes.empty();
  bounds.Steep = isCut ? 0.05 : 1.0;
  this->Frame.SetCells(scene, bounds, false);
  const TileView& view = this->Frame.View;
  this->Extrema.resize(static_cast<std::size_t>(view.Width) * view.Height);
  const bool isDrawn = this->Frame.Draw(scene.IsAborted,
    [this](const TileRectangle& tile, const int* cells, int count, TileScratch& scratch)
    {
      ExtremumProjection::Draw(this->Frame.Task, tile, cells, count, this->Greatest.data(), scratch,
        this->Extrema.data());
    });
  if (isDrawn)
  {
    this->Colour(*scene.Function);
  }
  return isDrawn;
}

//------------------------------------------------------------------------------
void ExtremumTilesEngine::Colour(const TransferFunction& function)
{
  this->Image.resize(4 * this->Extrema.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Extrema.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        glm::vec4 color(0.0f);
        if (this->Extrema[i] != ExtremumProjection::Nothing)
        {
          color = function.ValueAt(this->Sign * this->Extrema[i]);
          const float alpha = std::min(color.a, 1.0f);
          color = glm::vec4(color.r * alpha, color.g * alpha, color.b * alpha, alpha);
        }
        for (int k = 0; k < 4; ++k)
        {
          this->Image[4 * i + k] = color[k];
        }
      }
    });
}
