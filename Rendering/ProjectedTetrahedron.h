#ifndef ProjectedTetrahedron_h
#define ProjectedTetrahedron_h

#include "ProjectedPoints.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>

/**
 * @class ProjectedTetrahedron
 * @brief The projection of a tetrahedron: its class, its silhouette, its thickest point.
 *
 * Papers: Shirley and Tuchman, "A polygonal approximation to direct scalar volume rendering", 1990;
 * classes as in Cignoni et al., "Fast projective volume rendering", 1995, figure 2.
 *
 * One linear relation of the corners' rays, sum of w[i] Ray[i] = 0, says it all: w are, up to a
 * factor, the eye's barycentric coordinates, so their signs tell the faces that look to the eye.
 * Corners of positive weight and corners of negative weight span two faces, edges or corners that
 * cross on the screen: there the ray enters the cell and leaves it, and there it is thickest.
 *
 *     signs    class
 *     + + + -  1   one corner projects into the triangle of the others
 *     + + - -  2   the diagonals of a quadrilateral cross
 *     + + - 0  3   one corner projects onto an edge: a face is seen edge-on
 *     + - 0 0  4   two corners project onto each other: two faces are seen edge-on
 *
 * A weight that rounding leaves undecided counts as zero. Cells that contain the eye, and those
 * seen edge-on as a whole, have no class.
 */
class ProjectedTetrahedron
{
public:
  using Corners = std::array<ProjectedPoints::Point, 4>;
  /// Colour and extinction or opacity of the corners.
  using Values = std::array<glm::vec4, 4>;

  /// `cell`: the mesh's number for it, -1 for a part of one.
  ProjectedTetrahedron(const Corners& corners, const Values& values, int cell);

  /// 1 to 4, or 0.
  int GetClass() const { return this->Class; }
  int GetCell() const { return this->Cell; }
  const ProjectedPoints::Point& GetCorner(int i) const { return this->Points[i]; }
  const glm::vec4& GetValue(int i) const { return this->PointValues[i]; }

  /// Of class 1: the corner inside the others' triangle.
  int GetInnerCorner() const;
  /// Of class 1: the inner corner is nearer than the others' triangle (Cignoni's class 1a).
  bool IsInnerCornerNearer() const
  {
    return this->Weights[this->GetInnerCorner()] * this->Nearer > 0.0;
  }
  ///@{
  /// The face opposite a corner; one that is seen edge-on is neither.
  bool IsFrontFace(int opposite) const { return this->Weights[opposite] * this->Nearer < 0.0; }
  bool IsBackFace(int opposite) const { return this->Weights[opposite] * this->Nearer > 0.0; }
  ///@}

  /// Where the ray through the thickest point enters (0) and leaves (1).
  struct End
  {
    double Depth;
    glm::vec4 Value;
  };
  std::array<End, 2> GetThickEnds() const;
  /// Normalised device coordinates.
  glm::dvec2 GetThickScreen() const;

  /// The edges of the silhouette that form triangles with an inner point; those with the thickest
  /// one as a corner's own place are left out. Returns how many: 3, 4, 2, 1 in classes 1 to 4.
  int GetSilhouette(std::array<std::array<int, 2>, 4>& edges) const;

private:
  void Weigh();
  int FindClass() const;
  int CountSign(double sign) const;
  End GetEnd(double sign) const;

  Corners Points;
  Values PointValues;
  int Cell;
  int Class = 0;
  std::array<double, 4> Weights;
  /// The sign of the weights whose corners span the nearer end.
  double Nearer = 1.0;
};

#endif
