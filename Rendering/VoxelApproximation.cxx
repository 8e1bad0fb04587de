#include "VoxelApproximation.h"

#include "UniformThicknessApproximation.h"

//------------------------------------------------------------------------------
glm::vec4 VoxelApproximation::Classify(const glm::vec4& value) const
{
  return UniformThicknessApproximation::ClassifySlab(value, this->Thickness);
}

//------------------------------------------------------------------------------
void VoxelApproximation::Append(
  const ProjectedTetrahedron& cell, ApproximationTriangles& triangles) const
{
  const glm::vec4 mean =
    0.25f * (cell.GetValue(0) + cell.GetValue(1) + cell.GetValue(2) + cell.GetValue(3));
  ApproximationTriangles::Rim corners =
    UniformThicknessApproximation::MakeSlab(cell, this->Thickness, true);
  for (ApproximationTriangles::Vertex& corner : corners)
  {
    corner.Value = mean;
  }
  triangles.AppendFaces(cell, corners, true);
}
