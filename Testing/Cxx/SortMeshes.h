#ifndef SortMeshes_h
#define SortMeshes_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

/// Meshes that are hard to sort, each with a point scalar "scalar".
namespace SortMeshes
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

struct Entry
{
  std::string Name;
  std::function<Grid()> Make;
  /// Whether cells may hide each other in a circle, for some eye.
  bool MayBeCyclic = false;
  /// Whether the mesh fills its convex hull.
  bool Convex = false;
  /// Whether the cells do hide each other in a circle, seen from far up the third axis.
  bool Tangle = false;
};

/// What every sort must get right.
const std::vector<Entry>& All();
/// What is no cell complex: a sort must say so, and return every cell once.
const std::vector<Entry>& Bad();
/// One of either by its name; null where there is none.
Grid Make(const std::string& name);

// === Generators ===

/// Two spur gears of 12 teeth, a tooth of each in a gap of the other.
Grid Gears();
/// A ring, and about it slanted teeth that each cover the next: a circle, seen along the third
/// axis.
Grid SlantedGear();
/// `count` slanted bars that each cover the next seen along the third axis, not touching.
Grid Bars(int count, double halfLength);
/// Two slabs, one behind the other with a gap.
Grid Slabs();
Grid Torus();
/// A ring, and three bars that each cover the next, of tetrahedra so small that many lie on every ray.
Grid FineRing();
Grid FineBars();
/// A ball with a hole inside: a cube's shell of cells, blown up.
Grid HollowSphere();
Grid Spring();
Grid LShape();
/// Every second cube of a lattice: they touch at edges only.
Grid Checkerboard();
/// Cubes of `cells` per edge, corners at whole numbers times 1/8, exact in binary.
Grid Lattice(int cells);
Grid JitteredLattice(int cells, double jitter);
/// Hexagonal prisms side by side, some left out.
Grid Prisms();
/// Three cells about an edge whose common faces are warped.
Grid WarpedThree();

// === Changes; all return a new grid ===

/// Six tetrahedra per hexahedron about its diagonal: conforms in every lattice.
Grid Kuhn(vtkUnstructuredGrid* hexahedra);
/// Conforming tetrahedra of any cells.
Grid Tetrahedra(vtkUnstructuredGrid* grid);
Grid Wedges(vtkUnstructuredGrid* hexahedra);
Grid Scaled(vtkUnstructuredGrid* grid, double x, double y, double z);
Grid Moved(vtkUnstructuredGrid* grid, double x, double y, double z);
Grid AsFloat(vtkUnstructuredGrid* grid);
/// The cells in another order, and the points too.
Grid Shuffled(vtkUnstructuredGrid* grid, unsigned int seed);
/// Only the cells for which it says true.
Grid Select(vtkUnstructuredGrid* grid, const std::function<bool(vtkIdType)>& keeps);
/// Both, with points of their own.
Grid Join(vtkUnstructuredGrid* first, vtkUnstructuredGrid* second);
/// The scalar, from the coordinates within the bounds.
void AddScalar(vtkUnstructuredGrid* grid);
}

#endif
