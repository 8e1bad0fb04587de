#include "ConvexTilesFrame.h"

#include <algorithm>

//------------------------------------------------------------------------------
void ConvexTilesFrame::SetMesh(const std::vector<float>& points, const ConvexCellFaces& cells,
  const FacePieces& pieces, const CellPlanes& planes)
{
  this->Mesh.Build(points, cells, pieces, planes);
  this->Clusters.Build(this->Mesh);
  this->HasPoints = false;
}

//------------------------------------------------------------------------------
void ConvexTilesFrame::SetScalars(const std::vector<float>& values, bool onePerCell, float sign)
{
  this->Mesh.SetScalars(values, onePerCell, sign);
  if (this->HasPoints)
  {
    this->Vertices.CopyScalars(this->Mesh.Points);
  }
  this->HasCells = false;
}

//------------------------------------------------------------------------------
void ConvexTilesFrame::SetDrawn(const std::vector<unsigned int>& cells)
{
  if (this->Mesh.SetDrawn(cells))
  {
    this->Clusters.CountDrawn(this->Mesh);
    this->HasCells = false;
  }
}

//------------------------------------------------------------------------------
bool ConvexTilesFrame::SetView(const TileView::Camera& camera)
{
  if (this->HasView && camera == this->SeenCamera)
  {
    return true;
  }
  this->HasView = this->HasPoints = false;
  if (!TileSize::IsImage(camera.Width, camera.Height) || !this->View.Build(camera))
  {
    return false;
  }
  this->Rays.Build(camera);
  this->TilesX = TileSize::CountOf(this->View.Width);
  this->TilesY = TileSize::CountOf(this->View.Height);
  this->SeenCamera = camera;
  this->HasView = true;
  return true;
}

//------------------------------------------------------------------------------
void ConvexTilesFrame::SetCells(
  const Scene& scene, const ConvexTileFaces::Bounds& bounds, bool allExact)
{
  this->Cull(scene);
  this->Transform();
  if (!this->HasCells || !(bounds == this->SeenBounds) || allExact != this->SeenAllExact)
  {
    this->Faces.Project(
      this->Mesh, this->View, this->Vertices, this->Clusters.GetFaces(), bounds);
    this->Cells.Project(
      this->Mesh, this->View, this->Vertices, this->Clusters, this->Faces, allExact);
    this->Bins.Fill(this->Cells.Tiles, this->Order, &this->Clusters, this->TilesX, this->TilesY);
    this->SeenBounds = bounds;
    this->SeenAllExact = allExact;
    this->HasCells = true;
  }
  this->Task.Common.View = &this->View;
  this->Task.Common.Vertices = &this->Vertices;
  this->Task.Mesh = &this->Mesh;
  this->Task.Rays = &this->Rays;
  this->Task.Faces = &this->Faces;
  this->Task.Cells = &this->Cells;
  this->Task.Bounds = bounds;
}

//------------------------------------------------------------------------------
void ConvexTilesFrame::Cull(const Scene& scene)
{
  const bool isCut = this->Limits.Build(this->View, scene.OpaqueDepth, scene.ClippingPlanes);
  this->Task.Common.Limits = isCut ? &this->Limits : nullptr;
  this->Task.LeavesOut = isCut && scene.LeavesOut;
  if (this->Task.LeavesOut)
  {
    this->Limits.FindBlocks(this->View);
  }
  const TileLimits* opaque = isCut && this->Limits.HasOpaque() ? &this->Limits : nullptr;
  const bool isNew = scene.LeavesOut
    ? this->Clusters.FindSeen(this->View, scene.ClippingPlanes, opaque)
    : this->Clusters.SeeAll();
  this->HasPoints = this->HasPoints && !isNew;
}

//------------------------------------------------------------------------------
void ConvexTilesFrame::Transform()
{
  if (!this->HasPoints)
  {
    this->Vertices.Transform(this->Mesh.Points, this->View, &this->Clusters.GetPoints());
    this->HasPoints = true;
    this->HasCells = false;
  }
}

//------------------------------------------------------------------------------
bool ConvexTilesFrame::Draw(const TileLoop::AbortCheck& isAborted, const Drawer& draw)
{
  const bool isDrawn = TileLoop::Run(this->Bins.GetHeaviestFirst(), this->TilesX, isAborted, this->Scratch,
    [&](int tile, TileScratch& scratch)
    {
      draw(TileRectangle::OfTile(tile, this->View.Width, this->View.Height),
        this->Bins.GetTile(tile), this->Bins.GetSize(tile), scratch);
    });
  this->Counts = this->Scratch.CollectCounts();
  return isDrawn;
}
