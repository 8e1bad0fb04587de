/**
 * What becomes of one polyhedron: left as it is, cut into tetrahedra, or left out. As
 * ConvexCellPlan, but for surfaces of any number of faces.
 *
 * It is cut from its corner of smallest id, or else from any that sees the whole surface, ConePlan.
 * Where there is none, it is Concave: a point within may see all, StarCell, or a corner all but for
 * what is flat. Else it is left out: its tetrahedra would overlap.
 */
#ifndef PolyhedronPlan_h
#define PolyhedronPlan_h

#include "ConvexCellPlan.h"
#include "PolyhedronSurface.h"

/**
 * `surface`: as it was read; its faces are turned outward. `points`: by vertex, all finite; may be
 * scaled here. Moves the cursor past what WritePolyhedron will write. Inverted says that a face was
 * turned.
 */
ConvexCellPlan PlanPolyhedron(
  PolyhedronSurface& surface, double (*points)[3], ConvexCellCut cut, ConvexCellCursor& cursor);

/** From a corner that sees the whole surface but for faces that it looks along within
 *  TetrahedralSplit::FlatnessTolerance. `surface` and `points` as PlanPolyhedron left them. Stays
 *  Concave where there is none. */
void PlanButForFlat(const PolyhedronSurface& surface, const double (*points)[3],
  ConvexCellPlan& plan, ConvexCellCursor& cursor);

/** Orients the surface outward. Whole where it is closed and has a volume; `points` may be scaled
 *  here. */
ConvexCellPlan::FateType TurnOutward(PolyhedronSurface& surface, double (*points)[3]);

/** `surface` and `points` as for PlanPolyhedron. `outputIds`, by id, names the points in the output
 *  (null: the same). */
void WritePolyhedron(const ConvexCellPlan& plan, PolyhedronSurface& surface, double (*points)[3],
  const vtkIdType* outputIds, vtkIdType sourceCell, const ConvexCellArrays& arrays,
  ConvexCellCursor& cursor);

#endif
