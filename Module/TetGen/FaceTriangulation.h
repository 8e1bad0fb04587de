/**
 * Triangles of a face of any shape, the same for the two cells that share it.
 *
 * A face that its corner of smallest id sees whole is a fan from there, as vtkConvexCells cuts it;
 * any other loses ears (Meisters, Polygons Have Ears, 1975), found in an order that its ids alone
 * decide. Signs are exact in the coordinate plane that the face covers best.
 */
#ifndef FaceTriangulation_h
#define FaceTriangulation_h

#include <array>
#include <vector>

namespace FaceTriangulation
{
/** `ids`, one per corner, are compared; `points`, three per corner. Triangles by the corners'
 *  numbers, wound as the face is; fewer than corners - 2 where the face runs through itself. */
std::vector<std::array<int, 3>> Triangulate(
  const std::vector<long long>& ids, const std::vector<double>& points);
}

#endif
