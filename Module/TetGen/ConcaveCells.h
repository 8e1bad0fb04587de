/**
 * One polyhedron that no point sees all of, cut by TetGen: its faces stay, as triangles that its
 * neighbours have too.
 */
#ifndef ConcaveCells_h
#define ConcaveCells_h

#include "TetGenMesher.h"

#include <string>
#include <vector>

class PolyhedronSurface;

struct ConcaveCell
{
  /** The surface's vertices first; then the points that TetGen made, inside. */
  TetGenMesh Mesh;
  /** Three corners a triangle, counter-clockwise seen from outside. */
  std::vector<std::array<int, 3>> Triangles;
};

namespace ConcaveCells
{
/** `surface`: oriented; `points`, three per vertex. Failures are the mesh's. */
ConcaveCell Cut(PolyhedronSurface& surface, const std::vector<double>& points);
}

#endif
