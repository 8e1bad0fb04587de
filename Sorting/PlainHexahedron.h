/**
 * A quick yes for most hexahedra that are convex, as ConvexityTest has it.
 *
 * Two faces across from each other are looked at together: the corners of one are those off the
 * other. Heights over the triangles' planes are the same numbers as in ConvexityTest, and are held
 * against 0 where that allows more: no tolerance needs the cell's size or a root.
 */
#ifndef PlainHexahedron_h
#define PlainHexahedron_h

#include "vtkType.h"

namespace PlainHexahedron
{
/** `ids`, all different, and `points`, finite, by VTK's corners; `sign`: negative where it is inside
 *  out. True: convex. False is no answer. */
bool IsConvex(const vtkIdType ids[8], const double (*points)[3], double sign);
}

#endif
