#ifndef IsoTriangles_h
#define IsoTriangles_h

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <vector>

/**
 * @class IsoTriangles
 * @brief The exact iso-surfaces of a mesh of tetrahedra, as triangles.
 *
 * Where the scalar is linear in a tetrahedron, the points of one value form a triangle or a planar
 * quadrilateral, whose corners lie on edges (Doi and Koide 1991, in Georgii and Westermann 2006).
 * A corner is the same to the last bit in all cells around its edge: the surface has no crack. A
 * face all of whose points have the value belongs to it once, whether cells of other values lie on
 * one side or on both.
 *
 * What the scalars decide, the edges that are cut and where, is found apart from what points
 * decide: points that move cost as much as the surface is large.
 *
 * Array shapes: corners 4 ids per cell, ascending; scalars one per point; points 4 floats each
 * (xyz, one unused), as the gradients. The result: vertices and gradients of 4 floats each, of
 * which a vertex's last is 1, or 0 where it is not finite; triangles of 3 vertices each.
 */
class IsoTriangles
{
public:
  /// The triangles of one value.
  struct Surface
  {
    float Value = 0.0f;
    std::size_t FirstTriangle = 0;
    std::size_t EndTriangle = 0;
  };

  /// Finds the edges that these values cut; uses all threads. Cells with a scalar that is not a
  /// number have no surface.
  void Cut(const std::vector<int>& corners, const std::vector<float>& scalars,
    std::vector<float> values);

  /// Puts the vertices on their edges; `corners` as they were cut.
  void Move(const std::vector<int>& corners, const std::vector<float>& points);

  /// Interpolates gradients to the vertices.
  void Shade(const std::vector<float>& gradients);

  /// The points of all edges that are cut, each once.
  std::vector<int> FindPoints(std::size_t numberOfPoints) const;

  std::vector<Surface> Surfaces;
  std::vector<float> Vertices;
  std::vector<float> Gradients;
  std::vector<int> Triangles;
  /// The cells that are cut.
  std::vector<int> Cells;
  vtkIdType NumberOfInvalidCells = 0;
  /// Of the cells that are cut: those with a corner that is not finite.
  vtkIdType NumberOfLostCells = 0;

private:
  /// A vertex: `Share` of the way between two points; a point twice where it lies on that.
  struct Edge
  {
    int From;
    int To;
    float Share;
  };
  /// What a stretch of the mesh has.
  struct Part
  {
    std::vector<int> Cells;
    /// Three vertices per triangle.
    std::vector<Edge> Edges;
    vtkIdType NumberOfInvalidCells = 0;
  };

  void FindLevels(const std::vector<float>& scalars, const std::vector<float>& values);
  void FindCells(const std::vector<int>& corners, vtkIdType begin, vtkIdType end, Part& part) const;
  void CutCells(const std::vector<int>& corners, const std::vector<float>& scalars, int index,
    Part& part) const;
  void AppendSurface(const std::vector<Part>& parts, float value);
  /// Faces on the value, by their points, ascending: a list for each first point, as of the vertices.
  struct Faces
  {
    bool IsNew(const std::array<int, 3>& points, std::size_t numberOfPoints);

    std::vector<int> LastOfPoint;
    /// The second and the third point, and the face before.
    std::vector<std::array<int, 3>> Items;
  };
  /// False for a face that is in `faces`, to which it adds others, and for a point.
  bool IsNew(const Edge* triangle, Faces& faces) const;
  int FindVertex(const Edge& edge);
  void CountLostCells(const std::vector<int>& corners, const std::vector<float>& points);
  void AppendCells(const std::vector<Part>& parts);

  /// Of each point: twice the number of values below its scalar, and one more on a value.
  std::vector<unsigned char> Levels;
  std::vector<float> Values;
  /// One per vertex.
  std::vector<Edge> Edges;
  /// The vertices of the surface in work whose edges begin at a point: the last one; of each vertex
  /// the one before.
  std::vector<int> LastOfPoint;
  std::vector<int> Before;
};

#endif
