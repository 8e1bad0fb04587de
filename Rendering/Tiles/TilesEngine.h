/**
 * The Tiles engine: absorption and emission of tetrahedra, on the CPU.
 *
 * Stages of a frame: clusters that are not seen left out, points to the screen, cells to tiles, then
 * tile by tile: order, set-up, coverage, shading, compositing, repair. No window, no GL; threads by
 * vtkSMPTools, vectors by Highway. Any mesh comes out right: every pixel keeps the exit of its last piece, and where a
 * later one begins before that the pixel is done again with its pieces sorted. A frame without such
 * pixels is proven. Tiles whose rays enter the mesh once at most and whose faces say for certain what comes
 * first are proven by that alone (class TileEntries). Cells behind pixels that are nearly opaque are not projected. The result does not
 * depend on the number of threads.
 */
#ifndef TilesEngine_h
#define TilesEngine_h

#include "TileBins.h"
#include "TileCellFields.h"
#include "TileCells.h"
#include "TileClock.h"
#include "TileClusters.h"
#include "TileLighting.h"
#include "TileLimits.h"
#include "TileLoop.h"
#include "TileMesh.h"
#include "TileScratchPool.h"
#include "TileTask.h"
#include "TileTransfer.h"
#include "TileVertices.h"
#include "TileView.h"

#include "vtkType.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

class TransferFunction;
class VolumeShading;

class TilesEngine
{
public:
  struct Scene
  {
    TileView::Camera Camera;
    const TransferFunction* Function = nullptr;
    /** Light, gradient opacity and other components; null or not needed for none. Its gradients and
     *  colours must have been set. */
    const VolumeShading* Shading = nullptr;
    /** Window depths per pixel, or null; view coordinates. */
    const float* OpaqueDepth = nullptr;
    std::vector<glm::vec4> ClippingPlanes;
    /** The cells of the mesh that was given from back to front; null: found within each tile. */
    const std::vector<vtkIdType>* BackToFront = nullptr;
    TileLoop::AbortCheck IsAborted;
    /** Leaves out cells behind pixels that are nearly opaque, see class TileOcclusion. */
    bool EndsEarly = true;
    /** Times the stages and counts the lanes of coverage. */
    bool TimesStages = false;
    /** Lets tiles that are known to be in order do without the proof of each pixel, see class TileEntries. The
     *  bytes are the same but in pixels that the proof repairs: those are covered again from another corner, so that
     *  depths of faces seen nearly edge-on round differently. That is up to 1.1e-5 on lattices, 5e-5 on those flatter
     *  than 1 : 50; the order is right either way. */
    bool TrustsOrder = true;
  };

  void SetMesh(
    const std::vector<float>& points, const std::vector<int>& corners,
    const TileMesh::Progress& report = [](double) {});
  void SetScalars(const std::vector<float>& values, bool onePerCell);
  /** 4 floats each, the last unused: one per point; one per point or cell. */
  void SetGradients(const std::vector<float>& gradients);
  void SetColors(const std::vector<float>& colors, bool onePerCell);
  /** 0 for cells that are not to be seen. Costs no order where nothing changes, or where most cells are
   *  drawn before and after, see TileMesh::SetDrawn. */
  void SetDrawn(const std::vector<unsigned char>& drawn);

  /** False where the view has no inverse, no pixel or more than LargestImage, and where the frame is
   *  given up: the next one is drawn as if that had not begun. */
  bool Render(const Scene& scene);

  /** Premultiplied RGBA, first row at the bottom. */
  const std::vector<float>& GetImage() const { return this->Image; }
  const TileCounts& GetCounts() const { return this->Counts; }
  /** Of the last frame, all zero where it was not asked for them. */
  const TileStages& GetStages() const { return this->Stages; }
  const TileMesh& GetMesh() const { return this->Mesh; }
  /** Cells worth drawing that the last frame did not look at, see class TileClusters. */
  long long CountCellsOutside() const { return this->Clusters.CountCellsOutside(); }
  /** Cells whose places on the screen the last frame had, and how many times they are in tiles. */
  long long CountCellsSeen() const { return this->Clusters.CountCellsSeen(); }
  long long CountCellsInTiles() const { return this->Bins.GetNumberOfEntries(); }
  /** Bytes that last from frame to frame, and what a frame of this mesh needs beside them; what goes
   *  with pixels and threads alone is not counted. */
  std::size_t GetMeshMemory() const;
  std::size_t GetFrameMemory() const;

private:
  bool SetView(const Scene& scene);
  void SetTiles(int width, int height);
  void Cull(const Scene& scene);
  void Transform();
  void Bin(const Scene& scene);
  void SetTask(const Scene& scene);
  void SetLighting(const Scene& scene);
  bool Project(const Scene& scene);
  void SortTile(int tile, const TileRectangle& rectangle, TileScratch& scratch);
  void DrawTile(int tile, TileScratch& scratch);
  void CopyDrawn(int tile, std::vector<int>& drawn);
  void ClearTile(int tile, const TileRectangle& rectangle);
  void CollectStages(double secondsOfTiles);
  std::vector<int> FrontToBack(const std::vector<vtkIdType>& backToFront) const;

  TileMesh Mesh;
  TileView View;
  TileVertices Vertices;
  TileCells Cells;
  TileClusters Clusters;
  TileBins Bins;
  TileTransfer Transfer;
  TileLimits Limits;
  TileLighting Lighting;
  TileCellFields Gradients, Colors;
  TileScratchPool Scratch;
  TileTask Task;
  TileCounts Counts;
  TileClock Clock;
  TileStages Stages;
  std::vector<float> Image;
  // Of each tile: whether the image has nothing there.
  std::vector<unsigned char> IsBlank;
  // Of each tile whose list is sorted: whether it is known to be right.
  std::vector<unsigned char> InOrder;
  int TilesX = 0, TilesY = 0;

  // What stands from the last frame on, for SeenCamera.
  TileView::Camera SeenCamera;
  bool HasView = false;
  bool IsTransformed = false;
  bool IsBinned = false;
  bool IsSorted = false;
};

#endif
