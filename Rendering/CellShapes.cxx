#include "CellShapes.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>

#include <cmath>

namespace
{
struct Measure
{
  double Volume = 0.0;
  /// Of the faces opposite the corners.
  glm::dvec4 Areas{ 0.0 };

  double GetArea() const
  {
    return this->Areas.x + this->Areas.y + this->Areas.z + this->Areas.w;
  }
};

Measure MeasureCell(const CellShapes::Corners& corners, const glm::dmat3& meshToWorld)
{
  const glm::dvec3 a = meshToWorld * (corners[1] - corners[0]);
  const glm::dvec3 b = meshToWorld * (corners[2] - corners[0]);
  const glm::dvec3 c = meshToWorld * (corners[3] - corners[0]);
  const glm::dvec3 ab = glm::cross(a, b);
  Measure measure;
  measure.Volume = std::abs(glm::dot(ab, c)) / 6.0;
  measure.Areas = 0.5 * glm::dvec4(glm::length(glm::cross(b - a, c - a)),
                          glm::length(glm::cross(b, c)), glm::length(glm::cross(a, c)),
                          glm::length(ab));
  return measure;
}

CellShapes::Sphere SphereOf(const Measure& measure)
{
  const double area = measure.GetArea();
  CellShapes::Sphere sphere;
  if (area > 0.0)
  {
    sphere.Weights = glm::vec4(measure.Areas / area);
    sphere.Radius = static_cast<float>(3.0 * measure.Volume / area);
  }
  return sphere;
}
}

//------------------------------------------------------------------------------
CellShapes::Sphere CellShapes::InscribedSphere(
  const Corners& corners, const glm::dmat4& meshToWorld)
{
  return SphereOf(MeasureCell(corners, glm::dmat3(meshToWorld)));
}

//------------------------------------------------------------------------------
void CellShapes::Build(const std::vector<float>& points, const std::vector<int>& corners,
  const glm::dmat4& meshToWorld)
{
  const glm::dmat3 linear(meshToWorld);
  this->Spheres.resize(corners.size() / 4);
  vtkSMPThreadLocal<glm::dvec2> sums(glm::dvec2(0.0));
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Spheres.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      glm::dvec2& sum = sums.Local();
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        Corners places;
        for (int i = 0; i < 4; ++i)
        {
          const auto id = static_cast<size_t>(corners[4 * cell + i]);
          places[i] = glm::dvec3(glm::make_vec3(&points[4 * id]));
        }
        const Measure measure = MeasureCell(places, linear);
        this->Spheres[cell] = SphereOf(measure);
        sum += glm::dvec2(measure.Volume, measure.GetArea());
      }
    });
  glm::dvec2 total(0.0);
  for (const glm::dvec2& sum : sums)
  {
    total += sum;
  }
  this->MeanChord = total.y > 0.0 ? 4.0 * total.x / total.y : 0.0;
}
