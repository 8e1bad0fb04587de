#include "ExponentialApproximation.h"

#include "ShirleyTuchmanApproximation.h"

//------------------------------------------------------------------------------
void ExponentialApproximation::Append(
  const ProjectedTetrahedron& cell, ApproximationTriangles& triangles) const
{
  ApproximationTriangles::Rim rim = ApproximationTriangles::MakeRim(cell, 0.0f);
  for (int i = 0; i < 4; ++i)
  {
    rim[i].Value = cell.GetValue(i);
  }
  triangles.AppendFan(cell, ShirleyTuchmanApproximation::MakeThickVertex(cell), rim);
}
