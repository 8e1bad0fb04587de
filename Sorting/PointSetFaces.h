/**
 * The faces of a convex point set, as those of a polyhedron: the convex hull, with triangles that
 * lie in one plane joined, and points on an edge kept as corners.
 *
 * So it has the faces that its neighbours have, be they hexahedra or other point sets. A point
 * within the hull or within a face is no corner.
 */
#ifndef PointSetFaces_h
#define PointSetFaces_h

#include "vtkType.h"

#include <vector>

class vtkIdList;

namespace PointSetFaces
{
/** `ids`: of the points, distinct; `points`: three for each. `stream`: as GetFaceStream gives it;
 *  empty where all points lie in a plane. */
void List(const std::vector<vtkIdType>& ids, const std::vector<double>& points, vtkIdList* stream);
}

#endif
