/**
 * Cells that touch in faces that do not match: T-junctions, as where a mesh is finer on one side of
 * a plane than on the other, or is cut along the other diagonal there.
 *
 * Found among the boundary triangles: two that lie in one plane, within 1e-12 of the mesh's
 * diagonal, face each other and overlap by more than rounding. A tree of boxes finds the pairs to
 * look at; n log n for the boundary's n triangles.
 *
 * Not guaranteed: where the points of the finer side are off the plane by more, the cells overlap
 * or leave gaps, and nothing is found here.
 */
#ifndef NonconformingFaces_h
#define NonconformingFaces_h

#include "CellComplex.h"

namespace NonconformingFaces
{
/** Pairs of cells that touch so. Needs points, boundary and the box about the centres. */
int CountCellPairs(const CellComplex& complex);
}

#endif
