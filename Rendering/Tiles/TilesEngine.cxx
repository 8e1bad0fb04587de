#include "TilesEngine.h"

#include "TileProjection.h"
#include "VolumeShading.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdint>

namespace
{
// Optical depth by which pieces may overlap before a pixel is done again.
constexpr double OrderTolerance = 1e-4;
// Share of the mesh's extent that a float on the screen does not resolve.
constexpr double FloatResolution = 1e-6;
// Optical depth of the whole extent from which a float's step of it shows.
constexpr double DenseMedium = 300.0;
}

//------------------------------------------------------------------------------
void TilesEngine::SetMesh(const std::vector<float>& points, const std::vector<int>& corners,
  const TileMesh::Progress& report)
{
  this->Mesh.Build(points, corners, report);
  this->Clusters.Build(this->Mesh);
  this->Gradients.Clear();
  this->Colors.Clear();
  // Its number of cells has a say in the shape of tiles.
  this->HasView = this->IsTransformed = false;
}

//------------------------------------------------------------------------------
void TilesEngine::SetDrawn(const std::vector<unsigned char>& drawn)
{
  const bool wasSparse = this->Mesh.IsSparse;
  if (this->Mesh.SetDrawn(drawn))
  {
    this->Clusters.CountDrawn(this->Mesh);
    // All cells have places and an order, but where only those drawn have.
    this->IsTransformed = this->IsTransformed && !wasSparse && !this->Mesh.IsSparse;
  }
}

//------------------------------------------------------------------------------
void TilesEngine::SetGradients(const std::vector<float>& gradients)
{
  this->Gradients.Build(this->Mesh, gradients, false);
}

//------------------------------------------------------------------------------
void TilesEngine::SetColors(const std::vector<float>& colors, bool onePerCell)
{
  this->Colors.Build(this->Mesh, colors, onePerCell);
}

//------------------------------------------------------------------------------
std::size_t TilesEngine::GetMeshMemory() const
{
  return this->Mesh.GetMemorySize() + this->Gradients.GetMemorySize() +
         this->Colors.GetMemorySize() + this->Clusters.GetMemorySize();
}

//------------------------------------------------------------------------------
std::size_t TilesEngine::GetFrameMemory() const
{
  return this->Vertices.Values.capacity() * sizeof(float) +
         this->Cells.Boxes.capacity() * sizeof(std::uint32_t) + this->Cells.Faces.capacity() +
         this->Bins.GetMemorySize() + this->Scratch.GetMemorySize();
}

//------------------------------------------------------------------------------
void TilesEngine::SetScalars(const std::vector<float>& values, bool onePerCell)
{
  this->Mesh.SetScalars(values, onePerCell);
  if (this->IsTransformed)
  {
    this->Vertices.CopyScalars(this->Mesh.Points);
  }
}

//------------------------------------------------------------------------------
bool TilesEngine::Render(const Scene& scene)
{
  if (!this->SetView(scene))
  {
    return false;
  }
  this->Clock.Begin(scene.TimesStages);
  this->Cull(scene);
  this->Transform();
  this->Bin(scene);
  this->Clock.End();
  this->SetTask(scene);
  return this->Project(scene);
}

//------------------------------------------------------------------------------
bool TilesEngine::SetView(const Scene& scene)
{
  if (this->HasView && scene.Camera == this->SeenCamera)
  {
    return true;
  }
  this->HasView = this->IsTransformed = false;
  if (!TileSize::IsImage(scene.Camera.Width, scene.Camera.Height) ||
    !this->View.Build(scene.Camera))
  {
    return false;
  }
  this->SetTiles(scene.Camera.Width, scene.Camera.Height);
  this->SeenCamera = scene.Camera;
  this->HasView = true;
  return true;
}

//------------------------------------------------------------------------------
void TilesEngine::SetTiles(int width, int height)
{
  const int rowShift = TileSize::RowShiftOf(width, height, this->Mesh.GetNumberOfCells());
  const bool areSame =
    width == this->SeenCamera.Width && height == this->SeenCamera.Height && rowShift == this->View.RowShift;
  this->View.RowShift = rowShift;
  this->TilesX = TileSize::CountOf(width);
  this->TilesY = TileSize::CountOf(height, rowShift);
  if (!areSame || this->IsBlank.empty())
  {
    this->IsBlank.assign(static_cast<std::size_t>(this->TilesX) * this->TilesY, 0);
  }
}

//------------------------------------------------------------------------------
void TilesEngine::Cull(const Scene& scene)
{
  const bool isCut = this->Limits.Build(this->View, scene.OpaqueDepth, scene.ClippingPlanes);
  this->Task.Limits = isCut ? &this->Limits : nullptr;
  const TileLimits* opaque = isCut && this->Limits.HasOpaque() ? &this->Limits : nullptr;
  if (this->Clusters.FindSeen(this->View, scene.ClippingPlanes, opaque))
  {
    this->IsTransformed = false;
  }
  this->Clock.Lap(TileStages::Cull);
}

//------------------------------------------------------------------------------
void TilesEngine::Transform()
{
  if (!this->IsTransformed)
  {
    this->Vertices.Transform(this->Mesh.Points, this->View, &this->Clusters.GetPoints());
    this->Clock.Lap(TileStages::Transform);
    this->Cells.Project(this->Mesh, this->View, this->Vertices, this->Clusters);
    this->Clock.Lap(TileStages::Box);
    this->IsTransformed = true;
    this->IsBinned = false;
  }
}

//------------------------------------------------------------------------------
std::vector<int> TilesEngine::FrontToBack(const std::vector<vtkIdType>& backToFront) const
{
  std::vector<int> own(backToFront.size());
  for (int cell = 0; cell < this->Mesh.GetNumberOfCells(); ++cell)
  {
    own[this->Mesh.Source[cell]] = cell;
  }
  std::vector<int> order(backToFront.size());
  std::transform(backToFront.rbegin(), backToFront.rend(), order.begin(),
    [&](vtkIdType source) { return own[source]; });
  return order;
}

//------------------------------------------------------------------------------
void TilesEngine::Bin(const Scene& scene)
{
  if (this->IsBinned && !scene.BackToFront)
  {
    return;
  }
  const std::vector<int> order =
    scene.BackToFront ? this->FrontToBack(*scene.BackToFront) : std::vector<int>();
  this->Bins.Fill(this->Cells.Boxes, scene.BackToFront ? &order : nullptr, &this->Clusters,
    this->TilesX, this->TilesY);
  this->IsSorted = scene.BackToFront != nullptr;
  this->InOrder.assign(static_cast<std::size_t>(this->TilesX) * this->TilesY, 0);
  // The next frame's order may be another one, where it is not found here.
  this->IsBinned = !this->IsSorted;
  this->Clock.Lap(TileStages::Bin);
}

//------------------------------------------------------------------------------
void TilesEngine::SetTask(const Scene& scene)
{
  this->Image.resize(4 * static_cast<std::size_t>(this->View.Width) * this->View.Height);
  this->Transfer.Build(*scene.Function, this->View.LengthOfExtent);
  const double depth =
    std::max<double>(this->Transfer.GreatestExtinction, 1e-30) * this->View.LengthOfExtent;
  this->Task.Mesh = &this->Mesh;
  this->Task.View = &this->View;
  this->Task.Vertices = &this->Vertices;
  this->Task.Cells = &this->Cells;
  this->Task.Transfer = &this->Transfer;
  this->Task.Tolerance =
    static_cast<float>(this->View.Extent * this->View.FarWeight * this->View.FarWeight *
                       std::max(std::min(OrderTolerance / depth, 1e-3), FloatResolution));
  this->SetLighting(scene);
  this->Task.OpticalDepth = depth;
  this->Task.AllExact = depth > DenseMedium;
  this->Task.EndsEarly = scene.EndsEarly;
  // A ray may enter again behind what a plane cuts off.
  this->Task.TrustsOrder = scene.TrustsOrder && scene.ClippingPlanes.empty();
  this->Task.Image = this->Image.data();
}

//------------------------------------------------------------------------------
void TilesEngine::SetLighting(const Scene& scene)
{
  const bool isNeeded = scene.Shading && scene.Shading->IsNeeded();
  if (isNeeded)
  {
    this->Lighting.Build(*scene.Shading, this->View, scene.Camera);
  }
  this->Task.Lighting = isNeeded ? &this->Lighting : nullptr;
  this->Task.Gradients = &this->Gradients;
  this->Task.Colors = &this->Colors;
}

//------------------------------------------------------------------------------
bool TilesEngine::Project(const Scene& scene)
{
  const auto start = TileClock::Wall::now();
  const bool isDrawn = TileLoop::Run(this->Bins.GetHeaviestFirst(), this->TilesX, scene.IsAborted, this->Scratch,
    [this](int tile, TileScratch& scratch) { this->DrawTile(tile, scratch); });
  this->CollectStages(std::chrono::duration<double>(TileClock::Wall::now() - start).count());
  this->Counts = this->Scratch.CollectCounts();
  // Of a frame that was given up some tiles have put their lists in order, the others have not.
  this->IsSorted = this->IsSorted || isDrawn;
  this->IsBinned = this->IsBinned && this->IsSorted;
  return isDrawn;
}

//------------------------------------------------------------------------------
void TilesEngine::DrawTile(int tile, TileScratch& scratch)
{
  scratch.Clock.Begin(this->Clock.GetIsOn());
  const TileRectangle rectangle =
    TileRectangle::OfTile(tile, this->View.Width, this->View.Height, this->View.RowShift);
  if (!this->IsSorted)
  {
    this->SortTile(tile, rectangle, scratch);
  }
  this->CopyDrawn(tile, scratch.Drawn);
  scratch.IsInOrder = this->Task.TrustsOrder && this->InOrder[tile] != 0;
  scratch.Clock.Lap(TileStages::Order);
  if (scratch.Drawn.empty())
  {
    this->ClearTile(tile, rectangle);
    scratch.Clock.Lap(TileStages::Write);
  }
  else
  {
    this->IsBlank[tile] = 0;
    TileProjection::Draw(this->Task, rectangle, scratch);
  }
  scratch.Clock.End();
}

//------------------------------------------------------------------------------
void TilesEngine::CopyDrawn(int tile, std::vector<int>& drawn)
{
  const int* cells = this->Bins.GetTile(tile);
  drawn.assign(cells, cells + this->Bins.GetSize(tile));
  if (this->Mesh.OrdersEmpty)
  {
    auto isEmpty = [this](int cell) { return this->Mesh.Drawn[cell] == 0; };
    drawn.erase(std::remove_if(drawn.begin(), drawn.end(), isEmpty), drawn.end());
  }
}

//------------------------------------------------------------------------------
// What was empty in the frame before stays as it is.
void TilesEngine::ClearTile(int tile, const TileRectangle& rectangle)
{
  for (int y = rectangle.FirstY; this->IsBlank[tile] == 0 && y <= rectangle.LastY; ++y)
  {
    const std::size_t first = static_cast<std::size_t>(y) * this->View.Width + rectangle.FirstX;
    std::fill_n(&this->Image[4 * first], 4 * (rectangle.LastX + 1 - rectangle.FirstX), 0.0f);
  }
  this->IsBlank[tile] = 1;
}

//------------------------------------------------------------------------------
void TilesEngine::SortTile(int tile, const TileRectangle& rectangle, TileScratch& scratch)
{
  int* cells = this->Bins.GetTile(tile);
  const int count = this->Bins.GetSize(tile);
  const bool isCertain = scratch.Order.Sort(this->Task, cells, count, scratch.Drawn);
  this->InOrder[tile] =
    isCertain && scratch.Entries.AreSingle(this->Task, rectangle, scratch.Order.GetEntered()) ? 1 : 0;
}

//------------------------------------------------------------------------------
void TilesEngine::CollectStages(double secondsOfTiles)
{
  this->Stages = this->Clock.Stages;
  this->Clock.Stages = TileStages();
  if (this->Clock.GetIsOn())
  {
    const double share = 1.0 / std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads());
    const TileStages tiles = this->Scratch.CollectStages();
    this->Stages.Add(tiles, share);
    this->Stages.Seconds[TileStages::Wait] = std::max(0.0, secondsOfTiles - share * tiles.GetSum());
  }
}
