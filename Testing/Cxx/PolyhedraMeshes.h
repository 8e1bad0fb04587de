#ifndef PolyhedraMeshes_h
#define PolyhedraMeshes_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkUnstructuredGrid;

/// Meshes of every kind of convex cell, about the size of the unit cube, their scalar in [0, 1].
namespace PolyhedraMeshes
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

struct Entry
{
  std::string Name;
  Grid Mesh;
};

/// Tetrahedra, hexahedra, wedges, pyramids, pentagonal and hexagonal prisms, polyhedra with plane
/// faces that are no parallelograms; a curvilinear grid with warped ones; PentaHexa.vtk if
/// CELLPROJECTION_DATA has it.
std::vector<Entry> All();

/// Hexahedra with plane faces, none a parallelogram: a lattice seen in perspective.
Grid Hexahedra(int cells);
/// Truncated octahedra, 14 faces each, that fill space; cells^3 and (cells - 1)^3 between them.
Grid TruncatedOctahedra(int cells);
/// One right prism of unit height, as a cell of its own type or as a polyhedron of which every
/// second face is inside out.
Grid Prism(int corners, int type);
/// Prisms of 5 corners in a ring, sharing faces.
Grid PentagonalPrisms();
/// What the mappers draw of any cells: convex ones as they are, the others cut up.
Grid Convex(vtkUnstructuredGrid* grid);

/// Moves and scales a mesh into the unit cube about the origin.
void FitUnitCube(vtkUnstructuredGrid* grid);
/// The scalar: waves over the bounds, 0 and 1 reached.
void SetWaves(vtkUnstructuredGrid* grid);
/// The scalar: linear over the bounds, 0 and 1 reached.
void SetLinear(vtkUnstructuredGrid* grid);
}

#endif
