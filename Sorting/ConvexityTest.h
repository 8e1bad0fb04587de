/**
 * Whether a cell is convex as it is drawn: its faces as fans of triangles from their vertices of
 * smallest id (TetrahedralSplit), not as the curved surfaces that warped quadrilaterals stand for.
 *
 * A cell is, where for each of its faces
 * - the triangles' normals are within 60 degrees of each other,
 * - each vertex that is not on the face lies on the inner side of each triangle's plane,
 * - a face of five or more vertices is planar.
 * So a slightly warped quadrilateral passes, though its diagonal may be a dent. A triangle without
 * an area is passed over.
 */
#ifndef ConvexityTest_h
#define ConvexityTest_h

#include "TetrahedralSplit.h"

namespace ConvexityTest
{
/** How far outside a vertex may lie, by the size of the cell. */
constexpr double InsideTolerance = 1e-9;
/** How far out of its plane a vertex of a large face may lie, by the size of the face. */
constexpr double PlanarTolerance = 1e-5;

/** `ids` and `points`, finite, by the solid's vertices; `sign`: negative where it is inside out. */
bool IsConvex(const TetrahedralSplit::Solid& solid, const vtkIdType* ids, const double (*points)[3],
  double sign);

/** Whether a voxel, its eight vertices in a hexahedron's order, is along the axes, as VTK has it. */
bool IsBox(const double (*points)[3]);
}

#endif
