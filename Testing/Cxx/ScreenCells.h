#ifndef ScreenCells_h
#define ScreenCells_h

#include "TileCells.h"
#include "TileMesh.h"
#include "TileTask.h"
#include "TileTransfer.h"
#include "TileVertices.h"
#include "TileView.h"

#include <vector>

/// Tetrahedra whose places in the mesh are those on the screen, as a frame of the Tiles engine has them.
class ScreenCells
{
public:
  /// `corners`: as those of class HardTetrahedra; `isCut`: least and greatest scalars are transparent.
  ScreenCells(const std::vector<float>& corners, bool isCut);
  ScreenCells(const ScreenCells&) = delete;
  void operator=(const ScreenCells&) = delete;

  int GetCount() const { return static_cast<int>(this->Cells.Faces.size()); }
  /// Has every so manieth cell set up in double, whether it needs that or not; 0: none.
  void MakeExact(int step);

  /// Whole tiles, parts of them, one pixel.
  static std::vector<TileRectangle> MakeRectangles();

  TileMesh Mesh;
  TileView View;
  TileVertices Vertices;
  TileCells Cells;
  TileTransfer Transfer;
  TileTask Task;

private:
  void SetMesh(const std::vector<float>& corners);
  void SetTransfer(bool isCut);
};

#endif
