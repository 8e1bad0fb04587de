/**
 * The Tiles engine for the greatest, or least, scalar along each ray, from convex cells as they are.
 *
 * No window, no GL; threads by vtkSMPTools, vectors by Highway. Nothing is sorted by depth; cells
 * are taken from the greatest scalar down, and those that cannot change a pixel cost next to
 * nothing. The result does not depend on the number of threads. The scalar is within 1e-5 of its
 * range, save at silhouettes, which are off by less than 1/64 pixel.
 */
#ifndef ExtremumTilesEngine_h
#define ExtremumTilesEngine_h

#include "ConvexTilesFrame.h"

#include <vector>

class ExtremumTilesEngine
{
public:
  void SetMesh(const std::vector<float>& points, const ConvexCellFaces& cells,
    const FacePieces& pieces, const CellPlanes& planes);
  /** One per point or per cell. */
  void SetScalars(const std::vector<float>& values, bool onePerCell, bool findLeast);
  void SetDrawn(const std::vector<unsigned int>& cells) { this->Frame.SetDrawn(cells); }

  /** False where the view has no inverse or is larger than TileSize::LargestImage, and where the
   *  frame is given up. */
  bool Render(const ConvexTilesFrame::Scene& scene);

  /** Premultiplied RGBA, first row at the bottom. */
  const std::vector<float>& GetImage() const { return this->Image; }
  /** Cells: those that could change a pixel, summed over the tiles. */
  const TileCounts& GetCounts() const { return this->Frame.Counts; }
  /** Cells worth drawing that the last frame did not look at, see class TileClusters. */
  long long CountCellsOutside() const { return this->Frame.CountCellsOutside(); }
  /** Cells of the clusters that it looked at. */
  long long CountCellsSeen() const { return this->Frame.CountCellsSeen(); }

private:
  void OrderCells();
  void Colour(const TransferFunction& function);

  ConvexTilesFrame Frame;
  float Sign = 1.0f;
  std::vector<float> Greatest;
  std::vector<int> Order;
  std::vector<float> Extrema;
  std::vector<float> Image;
};

#endif
