/**
 * Tetrahedra of a hexahedron, wedge, pyramid or tetrahedron such that two cells that share a face
 * always cut it along the same diagonal: each quadrilateral is cut from its vertex of smallest id.
 *
 * Paper: J. Dompierre, P. Labbe, M.-G. Vallet, R. Camarero, How to Subdivide Pyramids, Prisms and
 * Hexahedra into Tetrahedra, 8th International Meshing Roundtable, 1999. The cell is seen from its
 * own vertex of smallest id, V: every face that does not touch V is triangulated, and each of these
 * triangles makes a tetrahedron with V. A hexahedron gives 6; it gives 5 where no diagonal ends in
 * the vertex opposite V. A wedge gives 3 and a pyramid 2.
 *
 * Notation: a vertex is its number in VTK's cell (vtkHexahedron, vtkWedge, ...), an id is its
 * point. Only comparisons of ids matter, so any numbering of the mesh will do. Equal ids are
 * allowed: the tetrahedra that are not flat still agree across faces. Not guaranteed: positive
 * volumes where a face is warped or the cell is not convex.
 */
#ifndef TetrahedralSplit_h
#define TetrahedralSplit_h

#include "vtkType.h"

namespace TetrahedralSplit
{
enum class Shape : unsigned char
{
  Tetrahedron,
  Pyramid,
  Wedge,
  Hexahedron
};

constexpr int MaximumVertices = 8;
constexpr int MaximumPieces = 6;

/** The tetrahedra of one cell, by the cell's vertices; all positive where the cell is convex. */
struct Pieces
{
  int Count = 0;
  unsigned char Vertex[MaximumPieces][4];
};

int NumberOfVertices(Shape shape);

/** `ids`: the NumberOfVertices(shape) point ids of the cell, in VTK's order. */
Pieces Split(Shape shape, const vtkIdType* ids);

/** The vertex that comes at `position` when an inside-out cell is renumbered to be positive. */
int TurnedVertex(Shape shape, int position);

/**
 * det(b - a, c - a, d - a), six times the volume; exactly 0 where rounding could have made its sign
 * (Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997: the static filter of orient3d).
 * Underflow and overflow are the caller's: coordinates of magnitude 1e-60 to 1e60 are safe.
 */
double SixVolumes(const double a[3], const double b[3], const double c[3], const double d[3]);
}

#endif
