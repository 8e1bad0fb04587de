/**
 * A cell cut from one of its vertices along the triangles of its faces, FaceTriangles, where one
 * sees each of them from inside. Dropped are tetrahedra without a volume, over triangles whose edges
 * go straight on within FaceTriangles::Straight: where such a triangle has an area, the cell beside
 * may have a tetrahedron over it.
 */
#ifndef ConePlan_h
#define ConePlan_h

#include "ConvexCellPlan.h"
#include "FaceTriangles.h"

namespace ConePlan
{
/** False where no vertex sees all; then `plan` stays. `points`: as `triangles` has them; `sign`: -1
 *  where the cell is inside out; `flatness`: as FaceTriangles has it, what is so flat is dropped. Moves
 *  the cursor past what Write will write. */
bool Make(const FaceTriangles& triangles, const double (*points)[3], double sign,
  ConvexCellPlan& plan, ConvexCellCursor& cursor, double flatness = 0.0);

/** `named`: ids in the output by vertex. */
void Write(const ConvexCellPlan& plan, const FaceTriangles& triangles, const double (*points)[3],
  double sign, const vtkIdType* named, vtkIdType sourceCell, const ConvexCellArrays& arrays,
  ConvexCellCursor& cursor);
}

#endif
