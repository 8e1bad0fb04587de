#include "CentroidApproximation.h"

#include "ShirleyTuchmanApproximation.h"

#include <cmath>

//------------------------------------------------------------------------------
CentroidApproximation::Center CentroidApproximation::FindCenter(
  const ProjectedTetrahedron& cell) const
{
  if (cell.GetCell() >= 0)
  {
    return { this->From.Shapes.GetSphere(cell.GetCell()),
      this->From.CenterValues[cell.GetCell()] };
  }
  CellShapes::Corners corners;
  for (int i = 0; i < 4; ++i)
  {
    corners[i] = cell.GetCorner(i).Place;
  }
  Center center{ CellShapes::InscribedSphere(corners, this->From.MeshToWorld), glm::vec4(0.0f) };
  for (int i = 0; i < 4; ++i)
  {
    center.Value += center.Sphere.Weights[i] * cell.GetValue(i);
  }
  return center;
}

//------------------------------------------------------------------------------
ApproximationTriangles::Vertex CentroidApproximation::AtInnerCorner(
  const ProjectedTetrahedron& cell, const Center& center) const
{
  const int inner = cell.GetInnerCorner();
  const ProjectedPoints::Point& corner = cell.GetCorner(inner);
  const double depth = this->By.Thickness * center.Sphere.Radius / corner.Length;
  const double front = cell.IsInnerCornerNearer() ? corner.Depth : corner.Depth - depth;
  return ApproximationTriangles::MakeVertex(
    corner.GetScreen(), front, depth, 0.5f * (center.Value + cell.GetValue(inner)));
}

//------------------------------------------------------------------------------
ApproximationTriangles::Vertex CentroidApproximation::AtCenter(
  const ProjectedTetrahedron& cell, const Center& center) const
{
  ProjectedPoints::Point middle{};
  for (int i = 0; i < 4; ++i)
  {
    const double weight = center.Sphere.Weights[i];
    middle.Ray += weight * cell.GetCorner(i).Ray;
    middle.Depth += weight * cell.GetCorner(i).Depth;
    middle.Length += weight * cell.GetCorner(i).Length;
  }
  const double half = 0.5 * this->By.Thickness * center.Sphere.Radius / middle.Length;
  return ApproximationTriangles::MakeVertex(
    middle.GetScreen(), middle.Depth - half, 2.0 * half, center.Value);
}

//------------------------------------------------------------------------------
ApproximationTriangles::Vertex CentroidApproximation::AtThickestPoint(
  const ProjectedTetrahedron& cell, const Center& center) const
{
  ApproximationTriangles::Vertex vertex = ShirleyTuchmanApproximation::MakeThickVertex(cell);
  const double length = this->From.Points.LengthAt(vertex.Screen);
  const double thickness = this->By.Thickness * center.Sphere.Radius / length;
  vertex.Front += static_cast<float>(0.5 * (vertex.Thickness - thickness));
  vertex.Thickness = static_cast<float>(thickness);
  return vertex;
}

//------------------------------------------------------------------------------
void CentroidApproximation::Append(
  const ProjectedTetrahedron& cell, ApproximationTriangles& triangles) const
{
  if (cell.GetClass() == 4)
  {
    ShirleyTuchmanApproximation(this->From.Points).Append(cell, triangles);
    return;
  }
  const Center center = this->FindCenter(cell);
  ApproximationTriangles::Vertex middle = cell.GetClass() == 1 ? this->AtInnerCorner(cell, center)
    : cell.GetClass() == 2                                     ? this->AtCenter(cell, center)
                                                               : this->AtThickestPoint(cell, center);
  const double length = this->By.Thickness * center.Sphere.Radius;
  const double opacity = -std::expm1(-middle.Value.a * length);
  middle.Value.a = static_cast<float>(opacity);
  const auto rim = static_cast<float>(this->By.RimOpacity * opacity);
  triangles.AppendFan(cell, middle, ApproximationTriangles::MakeRim(cell, rim));
}
