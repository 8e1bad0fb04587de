#include "CutCells.h"

#include "ConvexCellSelection.h"
#include "ViewRays.h"
#include "vtkSMPTools.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include <algorithm>

namespace
{
// Mesh coordinates; a plane this close to a corner goes through it.
constexpr float Touch = 1e-6f;

// Bit 2 i: some corner is not clearly behind plane i; bit 2 i + 1: some is not clearly before it.
unsigned int SidesOf(const glm::vec3& point, const std::vector<glm::vec4>& planes)
{
  unsigned int sides = 0;
  for (size_t i = 0; i < planes.size(); ++i)
  {
    const float height = glm::dot(glm::vec3(planes[i]), point) + planes[i].w;
    sides |= (height > -Touch ? 1u : 0u) << (2 * i);
    sides |= (height < Touch ? 2u : 0u) << (2 * i);
  }
  return sides;
}

// `isWanted` is given the sides of all corners of a cell.
template <class Predicate>
std::vector<unsigned int> FindBySides(const std::vector<float>& points,
  const ConvexCellFaces::Rows& corners, const ConvexCellSelection& selection,
  const std::vector<glm::vec4>& planes, Predicate isWanted)
{
  std::vector<unsigned int> sides(points.size() / 4);
  vtkSMPTools::For(0, static_cast<vtkIdType>(sides.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        sides[i] = SidesOf(glm::make_vec3(&points[4 * i]), planes);
      }
    });
  std::vector<unsigned int> found;
  for (const unsigned int cell : selection.DrawnCells)
  {
    const int row = static_cast<int>(cell);
    unsigned int all = 0;
    for (int i = 0; i < corners.GetSize(row); ++i)
    {
      all |= sides[corners.GetRow(row)[i]];
    }
    if (isWanted(all))
    {
      found.push_back(cell);
    }
  }
  return found;
}

glm::vec4 OfUnitLength(const glm::dvec4& plane)
{
  const double length = glm::length(glm::dvec3(plane));
  return glm::vec4(length > 0.0 ? plane / length : plane);
}
}

namespace CutCells
{
//------------------------------------------------------------------------------
std::vector<glm::vec4> Planes(const ViewRays& rays, const std::vector<glm::vec4>& clippingPlanes)
{
  const glm::dvec4 clipZ = glm::row(glm::dmat4(rays.MeshToClip), 2);
  const glm::dvec4 clipW = glm::row(glm::dmat4(rays.MeshToClip), 3);
  std::vector<glm::vec4> planes{ OfUnitLength(clipW + clipZ), OfUnitLength(clipW - clipZ) };
  for (const glm::vec4& plane : clippingPlanes)
  {
    // A plane is a row vector.
    planes.push_back(OfUnitLength(glm::dvec4(plane) * rays.MeshToView));
  }
  return planes;
}

//------------------------------------------------------------------------------
std::vector<unsigned int> Find(const std::vector<float>& points,
  const ConvexCellFaces::Rows& corners, const ConvexCellSelection& selection,
  const std::vector<glm::vec4>& planes)
{
  // Both bits of a pair.
  return FindBySides(points, corners, selection, planes,
    [](unsigned int sides) { return (sides & (sides >> 1) & 0x55555555u) != 0; });
}

//------------------------------------------------------------------------------
std::vector<unsigned int> FindBehind(const std::vector<float>& points,
  const ConvexCellFaces::Rows& corners, const ConvexCellSelection& selection,
  const glm::vec4& plane)
{
  return FindBySides(
    points, corners, selection, { plane }, [](unsigned int sides) { return (sides & 1u) == 0; });
}
}
