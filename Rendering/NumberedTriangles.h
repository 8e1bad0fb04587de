#ifndef NumberedTriangles_h
#define NumberedTriangles_h

#include <cstddef>
#include <vector>

/**
 * @class NumberedTriangles
 * @brief Triangles with their vertices numbered so that the last one of triangle i has number i.
 *
 * What a vertex shader finds for a triangle, its plane for one, then reaches the triangle's
 * fragments by its last vertex, with no attribute interpolated and nothing found twice. A vertex
 * that is the last of several triangles has several numbers.
 */
class NumberedTriangles
{
public:
  /// `triangles`: three vertices each, of so many.
  NumberedTriangles(const std::vector<int>& triangles, std::size_t numberOfVertices);

  /// Three numbers per triangle, in the order of the triangles.
  std::vector<int> Indices;
  /// Four per number: the vertices of the triangle that has it, the last the number's own, and 0.
  /// Numbers beyond the triangles' have their own vertex three times.
  std::vector<int> Corners;

private:
  void AppendCorners(int a, int b, int c);
};

#endif
