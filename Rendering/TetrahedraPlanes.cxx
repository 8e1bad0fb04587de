#include "TetrahedraPlanes.h"

#include "ScalarField.h"
#include "vtkSMPTools.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include <algorithm>

namespace
{
void SetUpCell(const glm::dvec3 (&p)[4], float* planes)
{
  const glm::dvec3 normals[4] = { glm::cross(p[2] - p[1], p[3] - p[1]),
    glm::cross(p[2] - p[0], p[3] - p[0]), glm::cross(p[1] - p[0], p[3] - p[0]),
    glm::cross(p[1] - p[0], p[2] - p[0]) };
  for (int i = 0; i < 4; ++i)
  {
    // Of unit length: products of edges of a small cell would leave the range of a float.
    const double length = glm::length(normals[i]);
    const glm::vec3 normal(length > 0.0 ? normals[i] / length : glm::dvec3(0.0));
    const double height = glm::dot(glm::dvec3(normal), p[i] - (i == 0 ? p[1] : p[0]));
    std::copy_n(glm::value_ptr(normal), 3, planes + 4 * i);
    planes[4 * i + 3] = height != 0.0 ? static_cast<float>(1.0 / height) : 0.0f;
  }
  const glm::vec3 anchors[2] = { glm::vec3(p[0]), glm::vec3(p[1]) };
  std::copy_n(glm::value_ptr(anchors[0]), 3, planes + 16);
  std::copy_n(glm::value_ptr(anchors[1]), 3, planes + 20);
}
}

//------------------------------------------------------------------------------
std::vector<float> TetrahedraPlanes::Planes(
  const std::vector<float>& points, const std::vector<int>& corners)
{
  const auto cells = static_cast<vtkIdType>(corners.size() / 4);
  std::vector<float> planes(24 * static_cast<size_t>(cells), 0.0f);
  vtkSMPTools::For(0, cells,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        glm::dvec3 p[4];
        for (int i = 0; i < 4; ++i)
        {
          p[i] =
            glm::dvec3(glm::make_vec3(&points[4 * static_cast<size_t>(corners[4 * cell + i])]));
        }
        SetUpCell(p, &planes[24 * cell]);
      }
    });
  return planes;
}

//------------------------------------------------------------------------------
vtkIdType TetrahedraPlanes::CountFlatCells(const std::vector<float>& planes)
{
  vtkIdType flat = 0;
  for (size_t cell = 0; cell < planes.size(); cell += 24)
  {
    flat += planes[cell + 3] == 0.0f ? 1 : 0;
  }
  return flat;
}

//------------------------------------------------------------------------------
std::vector<float> TetrahedraPlanes::Scalars(
  const ScalarField& scalars, const std::vector<int>& corners)
{
  std::vector<float> values(corners.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(corners.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        values[i] = scalars.Values[scalars.OnePerCell ? i / 4 : corners[i]];
      }
    });
  return values;
}
