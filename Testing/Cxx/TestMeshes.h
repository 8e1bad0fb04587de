#ifndef TestMeshes_h
#define TestMeshes_h

#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkUnstructuredGrid;

/// Small meshes with a point scalar named "scalar"; all are convex.
namespace TestMeshes
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;
using Field = std::function<double(const double point[3])>;

/// One tetrahedron with scalars 0, .3, .7 and 1; `numbering` permutes its four corners.
Grid Tetrahedron(const std::vector<int>& numbering = { 0, 1, 2, 3 });

/// The unit cube about the origin as one cell of `type`: voxel, hexahedron, two wedges, six
/// pyramids.
Grid Cube(int type);

/// The unit cube about the origin as six tetrahedra.
Grid SixTetrahedra();

/// size[0] x size[1] x size[2] about the origin in hexahedra, with a constant scalar of 1.
Grid Slab(const double size[3], const int cells[3]);

/// The unit cube about the origin in cells^3 hexahedra whose points inside it are moved about.
Grid JitteredCube(int cells);

/// A Delaunay mesh of random points in the unit cube about the origin.
Grid Delaunay(int points);

/// The hexahedra of a lattice over the unit cube about the origin, bent into a curvilinear grid.
Grid Curvilinear(int cells);

/// Replaces the scalar by a function of the point.
void SetField(vtkUnstructuredGrid* grid, const Field& field);

/// A smooth field in [0,1].
double Waves(const double point[3]);
}

#endif
