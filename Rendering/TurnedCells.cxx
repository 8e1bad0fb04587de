#include "TurnedCells.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <numeric>

namespace
{
signed char SideOf(const std::vector<float>& points, const int* corners)
{
  glm::dvec3 p[4];
  for (int i = 0; i < 4; ++i)
  {
    p[i] = glm::dvec3(glm::make_vec3(&points[4 * static_cast<size_t>(corners[i])]));
  }
  const double volume = glm::dot(p[1] - p[0], glm::cross(p[2] - p[0], p[3] - p[0]));
  return static_cast<signed char>(volume > 0.0 ? 1 : volume < 0.0 ? -1 : 0);
}
}

//------------------------------------------------------------------------------
void TurnedCells::TakeSides(const std::vector<float>& points, const std::vector<int>& corners)
{
  this->Sides.resize(corners.size() / 4);
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Sides.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        this->Sides[cell] = SideOf(points, &corners[4 * cell]);
      }
    });
}

//------------------------------------------------------------------------------
template <class CellAt>
vtkIdType TurnedCells::CountAmong(vtkIdType count, const std::vector<float>& points,
  const std::vector<int>& corners, const CellAt& cellAt) const
{
  vtkSMPThreadLocal<vtkIdType> turned(0);
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType& found = turned.Local();
      for (vtkIdType i = begin; i < end; ++i)
      {
        const vtkIdType cell = cellAt(i);
        found += this->Sides[cell] * SideOf(points, &corners[4 * cell]) < 0 ? 1 : 0;
      }
    });
  return std::accumulate(turned.begin(), turned.end(), vtkIdType(0));
}

//------------------------------------------------------------------------------
vtkIdType TurnedCells::Count(
  const std::vector<float>& points, const std::vector<int>& corners) const
{
  return this->CountAmong(
    static_cast<vtkIdType>(this->Sides.size()), points, corners, [](vtkIdType i) { return i; });
}

//------------------------------------------------------------------------------
vtkIdType TurnedCells::Count(const std::vector<float>& points, const std::vector<int>& corners,
  const std::vector<int>& cells) const
{
  return this->CountAmong(static_cast<vtkIdType>(cells.size()), points, corners,
    [&cells](vtkIdType i) { return static_cast<vtkIdType>(cells[i]); });
}
