#ifndef HexahedraArrays_h
#define HexahedraArrays_h

#include "CellPlanes.h"
#include "ConvexCellFaces.h"
#include "FacePieces.h"

#include <functional>
#include <vector>

/// A lattice of n^3 hexahedra in [-1, 1]^3 as the mappers prepare it, for engines without a window.
struct HexahedraArrays
{
  /// `move`: takes a point of the lattice elsewhere.
  explicit HexahedraArrays(int n, const std::function<void(float* point)>& move = {});

  template <class Engine>
  void SetMesh(Engine& engine) const
  {
    engine.SetMesh(this->Points, this->Cells, this->Pieces, this->Planes);
  }

  /// x, y, z and an unused fourth.
  std::vector<float> Points;
  /// Between 0 and 1.
  std::vector<float> Scalars;
  /// All cells.
  std::vector<unsigned int> Drawn;
  ConvexCellFaces Cells;
  FacePieces Pieces;
  CellPlanes Planes;
};

#endif
