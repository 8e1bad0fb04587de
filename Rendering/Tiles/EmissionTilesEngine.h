/**
 * The Tiles engine for emission without absorption, from convex cells as they are.
 *
 * No window, no GL; threads by vtkSMPTools, vectors by Highway. Nothing is sorted: every tile adds
 * up its cells in the mesh's order, so that the result does not depend on the number of threads.
 * Within 1e-4 of the exact integral where that is about 1.
 */
#ifndef EmissionTilesEngine_h
#define EmissionTilesEngine_h

#include "ConvexTilesFrame.h"
#include "EmissionTable.h"

#include <vector>

class EmissionTilesEngine
{
public:
  void SetMesh(const std::vector<float>& points, const ConvexCellFaces& cells,
    const FacePieces& pieces, const CellPlanes& planes);
  /** One per point or per cell. */
  void SetScalars(const std::vector<float>& values, bool onePerCell);
  void SetDrawn(const std::vector<unsigned int>& cells) { this->Frame.SetDrawn(cells); }

  /** False where the view has no inverse or is larger than TileSize::LargestImage, and where the
   *  frame is given up. */
  bool Render(const ConvexTilesFrame::Scene& scene);

  /** Red, green, blue and 0, first row at the bottom. */
  const std::vector<float>& GetImage() const { return this->Image; }
  const TileCounts& GetCounts() const { return this->Frame.Counts; }
  /** Cells worth drawing that the last frame did not look at, see class TileClusters. */
  long long CountCellsOutside() const { return this->Frame.CountCellsOutside(); }
  /** Cells of the clusters that it looked at. */
  long long CountCellsSeen() const { return this->Frame.CountCellsSeen(); }

private:
  ConvexTilesFrame Frame;
  EmissionTable Table;
  std::vector<float> Image;
};

#endif
