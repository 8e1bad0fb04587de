#ifndef FacePieces_h
#define FacePieces_h

#include "ConvexCellFaces.h"

#include <glm/vec3.hpp>

#include <array>
#include <vector>

/**
 * @class FacePieces
 * @brief Faces as quadrilaterals of two triangles each, and their shape.
 *
 * A face is a fan of triangles from its first point: its smallest id, or where nodes on its edges
 * make triangles flat, the smallest of those with the fewest. Two neighbouring triangles of
 * the fan are a piece: corners v0, v1, v2, v3 with the diagonal v0 v2; a single triangle has no v3.
 * On a piece the scalar is linear in each triangle:
 *
 *     u = GradientU . (x - v0) is 0 at v0 and 1 at v2,
 *     w = GradientW . (x - v0) is 0 on the diagonal, 1 at v3, W1 below zero at v1,
 *     beyond w = 0: weights w of v3 and u - U3 w of v2, else w / W1 of v1 and u - U1 w / W1 of v2.
 *
 * All of it holds for warped pieces too, on each of their triangles.
 */
class FacePieces
{
public:
  /// One texel of four floats each.
  struct Shape
  {
    glm::vec3 GradientU;
    float U3;
    glm::vec3 GradientW;
    /// Its sign is turned where the next piece of the same face lies beyond the edge v0 v3.
    float W1;
    glm::vec3 First; // v0
    float U1;
  };
  static_assert(sizeof(Shape) == 48, "read as three texels");

  /// A face's plane, through its first point; of a warped quadrilateral those of both triangles.
  /// Normals are of unit length and have a common side.
  struct Plane
  {
    glm::dvec3 Normals[2];
    bool IsWarped;
    /// Warped: the last corner lies on the side to which the normals point.
    bool IsRaised;
  };

  /// `points`: 4 floats each.
  void Build(const std::vector<float>& points, const ConvexCellFaces::Rows& loops);

  /// Whether a face has more than four corners, and so more than one piece.
  bool HasLongFaces() const { return this->Corners.size() > this->Planes.size(); }
  int GetNumberOfPieces() const { return static_cast<int>(this->Corners.size()); }

  std::vector<int> Offsets;                // of each face's first piece; one more at the end
  std::vector<std::array<int, 4>> Corners; // per piece: point ids; no v3: v2 once more
  std::vector<Shape> Shapes;               // per piece
  std::vector<Plane> Planes;               // per face
};

#endif
