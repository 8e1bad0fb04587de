/**
 * Tetrahedra of a cell such that two cells that share a face always cut it along the same
 * diagonals: each face is a fan of triangles from its vertex of smallest id.
 *
 * Paper: J. Dompierre, P. Labbe, M.-G. Vallet, R. Camarero, How to Subdivide Pyramids, Prisms and
 * Hexahedra into Tetrahedra, 8th International Meshing Roundtable, 1999. The cell is seen from its
 * own vertex of smallest id, V: every face that does not touch V is triangulated, and each of these
 * triangles makes a tetrahedron with V. A hexahedron gives 6; it gives 5 where no diagonal ends in
 * the vertex opposite V. A wedge gives 3, a pyramid 2, a pentagonal prism 9, a hexagonal prism 12.
 *
 * A cell that V does not see all of can be seen from another vertex, FindApex(): the triangles of
 * the faces stay as they are, and those of V's own faces are joined to it as well.
 *
 * Notation: a vertex is its number in VTK's cell (vtkHexahedron, vtkWedge, ...), an id is its
 * point. Only comparisons of ids matter, so any numbering of the mesh will do. Equal ids are
 * allowed: the tetrahedra that are not flat still agree across faces. Not guaranteed: positive
 * volumes where a face is warped or the cell is not convex.
 */
#ifndef TetrahedralSplit_h
#define TetrahedralSplit_h

#include "vtkType.h"

#include <algorithm>

namespace TetrahedralSplit
{
enum class Shape : unsigned char
{
  Tetrahedron,
  Pyramid,
  Wedge,
  Hexahedron,
  PentagonalPrism,
  HexagonalPrism
};

constexpr int MaximumVertices = 12;
constexpr int MaximumPieces = 17;

/** How far from a plane a corner may be to lie in it, by the size of the cell. */
constexpr double FlatnessTolerance = 1e-6;

/** A closed surface, not owned: the vertices of each face, counter-clockwise from outside. */
struct Solid
{
  int NumberOfVertices;
  int NumberOfFaces;
  const int* FaceOffsets; // one more than there are faces
  const int* FaceVertices;

  const int* Begin(int face) const { return this->FaceVertices + this->FaceOffsets[face]; }
  const int* End(int face) const { return this->FaceVertices + this->FaceOffsets[face + 1]; }
  bool Touches(int face, int vertex) const
  {
    return std::find(this->Begin(face), this->End(face), vertex) != this->End(face);
  }
};

/** As VTK's GetFace lists them. */
const Solid& SolidOf(Shape shape);

/** The tetrahedra of one cell, by the cell's vertices; all positive where the cell is convex. */
struct Pieces
{
  int Count = 0;
  unsigned char Vertex[MaximumPieces][4];
};

int NumberOfVertices(Shape shape);

/** `ids`: the NumberOfVertices(shape) point ids of the cell, in VTK's order. `apex`: V where it is
 *  not the vertex of smallest id. */
Pieces Split(Shape shape, const vtkIdType* ids, int apex = -1);

/** The vertex that comes at `position` when an inside-out cell is renumbered to be positive. */
int TurnedVertex(Shape shape, int position);

/** visit(a, b, c) for each triangle of a face, counter-clockwise from outside, from `a`, its vertex
 *  of smallest id. */
template <typename Visit>
void VisitTriangles(const Solid& solid, int face, const vtkIdType* ids, Visit visit)
{
  const int* begin = solid.Begin(face);
  const int* end = solid.End(face);
  const int* start = std::min_element(begin, end, [ids](int v, int w) { return ids[v] < ids[w]; });
  const auto next = [begin, end](const int* at) { return at + 1 == end ? begin : at + 1; };
  for (const int* at = next(start); next(at) != start; at = next(at))
  {
    visit(*start, *at, *next(at));
  }
}

/** visit(face, a, b, c) for each triangle that makes a tetrahedron (apex, a, b, c). */
template <typename Visit>
void VisitCone(const Solid& solid, const vtkIdType* ids, int apex, Visit visit)
{
  for (int face = 0; face < solid.NumberOfFaces; ++face)
  {
    const int* begin = solid.Begin(face);
    const int* end = solid.End(face);
    if (std::find(begin, end, apex) != end &&
        std::all_of(begin, end, [=](int vertex) { return ids[apex] <= ids[vertex]; }))
    {
      continue; // the face's fan starts in the apex
    }
    VisitTriangles(solid, face, ids,
      [&](int a, int b, int c)
      {
        if (a != apex && b != apex && c != apex)
        {
          visit(face, a, b, c);
        }
      });
  }
}

/**
 * A vertex that sees the whole surface from inside, so that the cone from it is the cell; -1 where
 * there is none. First the vertex of smallest id, then those whose own faces fan from them or from
 * across, then all others. Tetrahedra of negative volume are allowed where their apex lies within
 * FlatnessTolerance of the plane of their triangle, and all of them are no more of the cell: they are
 * to be dropped. `sign`: -1 where the
 * cell is inside out.
 */
int FindApex(
  const Solid& solid, const vtkIdType* ids, const double (*points)[3], double sign = 1.0);

/**
 * det(b - a, c - a, d - a), six times the volume; exactly 0 where rounding could have made its sign
 * (Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997: the static filter of orient3d).
 * Underflow and overflow are the caller's: coordinates of magnitude 1e-60 to 1e60 are safe.
 */
double SixVolumes(const double a[3], const double b[3], const double c[3], const double d[3]);

/** By a power of two, hence exactly, to coordinates that are safe for SixVolumes. */
void ScaleIfExtreme(double (*points)[3], int count);

/** The diagonal of the box about the points. */
double SizeOf(const double (*points)[3], int count);
}

#endif
