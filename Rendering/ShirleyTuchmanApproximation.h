#ifndef ShirleyTuchmanApproximation_h
#define ShirleyTuchmanApproximation_h

#include "CellApproximation.h"
#include "ProjectedPoints.h"

/**
 * @class ShirleyTuchmanApproximation
 * @brief Triangles about the thickest point, whose opacity falls linearly to nothing at the rim.
 *
 * Paper: Shirley and Tuchman, "A polygonal approximation to direct scalar volume rendering", 1990.
 * The thickest point has the mean of colour and extinction at entry and exit.
 */
class ShirleyTuchmanApproximation : public CellApproximation
{
public:
  /// Keeps the address.
  explicit ShirleyTuchmanApproximation(const ProjectedPoints& points)
    : Points(points)
  {
  }

  void Append(const ProjectedTetrahedron& cell, ApproximationTriangles& triangles) const override;

  /// The thickest point, with the mean extinction.
  static ApproximationTriangles::Vertex MakeThickVertex(const ProjectedTetrahedron& cell);

private:
  const ProjectedPoints& Points;
};

#endif
