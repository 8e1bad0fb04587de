/**
 * The stages of a frame that all engines of convex cells share: limits of the rays, clusters that are
 * not seen left out, points and faces to the screen, cells to tiles. What stands from the last frame on is not done again.
 */
#ifndef ConvexTilesFrame_h
#define ConvexTilesFrame_h

#include "ConvexTileCells.h"
#include "ConvexTileFaces.h"
#include "ConvexTileMesh.h"
#include "ConvexTileRays.h"
#include "ConvexTileTask.h"
#include "TileBins.h"
#include "TileClusters.h"
#include "TileLimits.h"
#include "TileLoop.h"
#include "TileScratchPool.h"
#include "TileVertices.h"
#include "TileView.h"

#include <glm/vec4.hpp>

#include <functional>
#include <vector>

class TransferFunction;

class ConvexTilesFrame
{
public:
  struct Scene
  {
    TileView::Camera Camera;
    const TransferFunction* Function = nullptr;
    /** Window depths per pixel, or null; view coordinates. */
    const float* OpaqueDepth = nullptr;
    std::vector<glm::vec4> ClippingPlanes;
    TileLoop::AbortCheck IsAborted;
    /** Leaves out clusters that are not seen, and in each tile cells of which nothing is left; the image
     *  is the same. */
    bool LeavesOut = true;
  };

  /** See class ConvexTileMesh. */
  void SetMesh(const std::vector<float>& points, const ConvexCellFaces& cells,
    const FacePieces& pieces, const CellPlanes& planes);
  void SetScalars(const std::vector<float>& values, bool onePerCell, float sign);
  void SetDrawn(const std::vector<unsigned int>& cells);

  /** Drawn in that order within each tile; null for that of the mesh. */
  void SetOrder(const std::vector<int>* order) { this->Order = order; }

  /** False where the view has no inverse or is larger than TileSize::LargestImage. */
  bool SetView(const TileView::Camera& camera);
  /** After SetView. */
  void SetCells(const Scene& scene, const ConvexTileFaces::Bounds& bounds, bool allExact);

  /** Tile by tile, on all cores: the tile, its cells and their number. False where the frame was given
   *  up. */
  using Drawer =
    std::function<void(const TileRectangle& tile, const int* cells, int count, TileScratch&)>;
  bool Draw(const TileLoop::AbortCheck& isAborted, const Drawer& draw);

  /** Cells worth drawing that the last frame did not look at, see class TileClusters. */
  long long CountCellsOutside() const { return this->Clusters.CountCellsOutside(); }
  long long CountCellsSeen() const { return this->Clusters.CountCellsSeen(); }

  ConvexTileMesh Mesh;
  TileView View;
  ConvexTileTask Task;
  TileCounts Counts;

private:
  void Cull(const Scene& scene);
  void Transform();

  TileClusters Clusters;
  ConvexTileRays Rays;
  TileVertices Vertices;
  ConvexTileFaces Faces;
  ConvexTileCells Cells;
  TileBins Bins;
  TileLimits Limits;
  TileScratchPool Scratch;
  const std::vector<int>* Order = nullptr;
  int TilesX = 0, TilesY = 0;

  TileView::Camera SeenCamera;
  ConvexTileFaces::Bounds SeenBounds;
  bool SeenAllExact = false;
  bool HasView = false;
  bool HasPoints = false;
  bool HasCells = false;
};

#endif
