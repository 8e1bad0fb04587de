#ifndef CentroidApproximation_h
#define CentroidApproximation_h

#include "CellApproximation.h"
#include "CellShapes.h"
#include "ProjectedPoints.h"

#include <vector>

/**
 * @class CentroidApproximation
 * @brief Triangles about the centre of the inscribed sphere, whose thickness is a multiple of its
 * radius.
 *
 * Paper: Cignoni, Montani, Sarti and Scopigno, "Fast projective volume rendering: approximating the
 * rendering process or simplifying the data?", 1995, section 3.2. In class 2 the triangles meet in
 * the centre; in class 1 in the inner corner, with the mean of its value and the centre's; in
 * class 3 where Shirley's and Tuchman's do; class 4 is theirs. Where the thickness is that of the
 * sphere the rim has a share of the opacity.
 */
class CentroidApproximation : public CellApproximation
{
public:
  struct Input
  {
    const ProjectedPoints& Points;
    const CellShapes& Shapes;
    /// Colour and extinction at the centres.
    const std::vector<glm::vec4>& CenterValues;
    const glm::dmat4& MeshToWorld;
  };
  /// Thickness over radius, the paper's c1; opacity of the rim over that of the middle.
  struct Factors
  {
    double Thickness;
    double RimOpacity;
  };

  /// Keeps what the input refers to.
  CentroidApproximation(const Input& input, const Factors& factors)
    : From(input)
    , By(factors)
  {
  }

  void Append(const ProjectedTetrahedron& cell, ApproximationTriangles& triangles) const override;

private:
  struct Center
  {
    CellShapes::Sphere Sphere;
    glm::vec4 Value;
  };
  Center FindCenter(const ProjectedTetrahedron& cell) const;
  ApproximationTriangles::Vertex AtInnerCorner(
    const ProjectedTetrahedron& cell, const Center& center) const;
  ApproximationTriangles::Vertex AtCenter(
    const ProjectedTetrahedron& cell, const Center& center) const;
  ApproximationTriangles::Vertex AtThickestPoint(
    const ProjectedTetrahedron& cell, const Center& center) const;

  Input From;
  Factors By;
};

#endif
