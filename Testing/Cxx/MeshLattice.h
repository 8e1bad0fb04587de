#ifndef MeshLattice_h
#define MeshLattice_h

#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkUnstructuredGrid;

/// Meshes from lattices of hexahedra: bent, closed to rings, with cells left out.
class MeshLattice
{
public:
  using Grid = vtkSmartPointer<vtkUnstructuredGrid>;
  /// Lattice coordinates (0 .. Cells in each axis, whole numbers at the points) to a point.
  using Map = std::function<void(const double u[3], double p[3])>;
  using Mask = std::function<bool(int i, int j, int k)>;

  MeshLattice(int cellsX, int cellsY, int cellsZ);

  /// The last points of this axis are the first ones.
  void SetWrap(int axis) { this->Wraps[axis] = true; }
  /// Cells for which it says false are left out, and points that no cell uses.
  void SetMask(const Mask& keeps) { this->Keeps = keeps; }
  void SetMap(const Map& map) { this->Bend = map; }

  /// Appends the hexahedra to `grid`, which needs no points yet; double.
  void AddTo(vtkUnstructuredGrid* grid) const;
  Grid Make() const;

private:
  void InsertPoint(vtkUnstructuredGrid* grid, const int index[3]) const;

  int Cells[3];
  bool Wraps[3] = { false, false, false };
  Mask Keeps;
  Map Bend;
};

#endif
