#include "ShirleyTuchmanApproximation.h"

#include <cmath>

//------------------------------------------------------------------------------
ApproximationTriangles::Vertex ShirleyTuchmanApproximation::MakeThickVertex(
  const ProjectedTetrahedron& cell)
{
  const std::array<ProjectedTetrahedron::End, 2> ends = cell.GetThickEnds();
  return ApproximationTriangles::MakeVertex(cell.GetThickScreen(), ends[0].Depth,
    ends[1].Depth - ends[0].Depth, 0.5f * (ends[0].Value + ends[1].Value));
}

//------------------------------------------------------------------------------
void ShirleyTuchmanApproximation::Append(
  const ProjectedTetrahedron& cell, ApproximationTriangles& triangles) const
{
  ApproximationTriangles::Vertex middle = MakeThickVertex(cell);
  const double length = middle.Thickness * this->Points.LengthAt(middle.Screen);
  middle.Value.a = static_cast<float>(-std::expm1(-middle.Value.a * length));
  triangles.AppendFan(cell, middle, ApproximationTriangles::MakeRim(cell, 0.0f));
}
