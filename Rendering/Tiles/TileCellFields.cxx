#include "TileCellFields.h"

#include "TileMesh.h"
#include "vtkSMPTools.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace
{
// Of the values at the corners: a greater slope leaves a float too few digits.
constexpr double GreatestSlope = 1e5;
}

//------------------------------------------------------------------------------
void TileCellFields::Build(
  const TileMesh& mesh, const std::vector<float>& values, bool onePerCell)
{
  const int cells = mesh.GetNumberOfCells();
  this->Values.assign(Stride * static_cast<std::size_t>(cells), 0.0f);
  vtkSMPTools::For(0, cells,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        if (!onePerCell)
        {
          this->BuildCell(mesh, values, static_cast<int>(cell));
          continue;
        }
        for (int k = 0; k < Functions; ++k)
        {
          this->Values[Stride * cell + 4 * k + 3] =
            values[4 * static_cast<std::size_t>(mesh.Source[cell]) + k];
        }
      }
    });
}

//------------------------------------------------------------------------------
void TileCellFields::BuildCell(const TileMesh& mesh, const std::vector<float>& values, int cell)
{
  glm::dvec3 points[4], ends[4];
  for (int i = 0; i < 4; ++i)
  {
    const auto corner =
      static_cast<std::size_t>(mesh.Corners[4 * static_cast<std::size_t>(cell) + i]);
    points[i] = glm::dvec3(glm::make_vec3(&mesh.Points[4 * corner]));
    const auto source = static_cast<std::size_t>(mesh.PointSource[corner]);
    ends[i] = glm::dvec3(glm::make_vec3(&values[4 * source]));
  }
  const glm::dvec3 edges[3] = { points[1] - points[0], points[2] - points[0],
    points[3] - points[0] };
  const double volume = glm::dot(edges[0], glm::cross(edges[1], edges[2]));
  for (int k = 0; k < Functions; ++k)
  {
    glm::dvec3 slope(0.0);
    double greatest = std::abs(ends[0][k]), mean = 0.25 * ends[0][k];
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec3 normal = glm::cross(edges[(i + 1) % 3], edges[(i + 2) % 3]);
      slope += (ends[i + 1][k] - ends[0][k]) / volume * normal;
      greatest = std::max(greatest, std::abs(ends[i + 1][k]));
      mean += 0.25 * ends[i + 1][k];
    }
    const bool fits = glm::length(slope) <= GreatestSlope * greatest;
    const glm::dvec4 row = fits ? glm::dvec4(slope, ends[0][k] - glm::dot(slope, points[0]))
                                : glm::dvec4(0.0, 0.0, 0.0, mean);
    for (int i = 0; i < 4; ++i)
    {
      this->Values[Stride * static_cast<std::size_t>(cell) + 4 * k + i] =
        static_cast<float>(row[i]);
    }
  }
}
