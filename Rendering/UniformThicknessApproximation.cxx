#include "UniformThicknessApproximation.h"

#include <cmath>

//------------------------------------------------------------------------------
glm::vec4 UniformThicknessApproximation::ClassifySlab(const glm::vec4& value, double thickness)
{
  return { glm::vec3(value), static_cast<float>(-std::expm1(-value.a * thickness)) };
}

//------------------------------------------------------------------------------
glm::vec4 UniformThicknessApproximation::Classify(const glm::vec4& value) const
{
  return ClassifySlab(value, this->Thickness);
}

//------------------------------------------------------------------------------
ApproximationTriangles::Rim UniformThicknessApproximation::MakeSlab(
  const ProjectedTetrahedron& cell, double thickness, bool isFront)
{
  ApproximationTriangles::Rim slab;
  for (int i = 0; i < 4; ++i)
  {
    const ProjectedPoints::Point& corner = cell.GetCorner(i);
    const double depth = thickness / corner.Length;
    const double front = isFront ? corner.Depth : corner.Depth - depth;
    slab[i] = ApproximationTriangles::MakeVertex(
      corner.GetScreen(), front, depth, cell.GetValue(i));
  }
  return slab;
}

//------------------------------------------------------------------------------
void UniformThicknessApproximation::Append(
  const ProjectedTetrahedron& cell, ApproximationTriangles& triangles) const
{
  const bool areFront =
    !(this->OneFaceForThree && cell.GetClass() == 1 && cell.IsInnerCornerNearer());
  triangles.AppendFaces(cell, MakeSlab(cell, this->Thickness, areFront), areFront);
}
