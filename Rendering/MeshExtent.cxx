#include "MeshExtent.h"

#include "MeshCoordinates.h"
#include "RasterView.h"
#include "ScreenBox.h"
#include "ViewRays.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
// Corner i of the box, in mesh coordinates.
glm::dvec3 CornerOf(const MeshCoordinates& coordinates, int i)
{
  const std::array<double, 3>& half = coordinates.HalfLengths;
  return { (i & 1) != 0 ? half[0] : -half[0], (i & 2) != 0 ? half[1] : -half[1],
    (i & 4) != 0 ? half[2] : -half[2] };
}
}

namespace MeshExtent
{
//------------------------------------------------------------------------------
double FindDiagonal(const MeshCoordinates& coordinates, const RasterView& view)
{
  double longest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec4 diagonal(2.0 * CornerOf(coordinates, i), 0.0);
    longest = std::max(longest, glm::length(glm::dvec3(view.Rays->MeshToWorld * diagonal)));
  }
  return longest;
}

//------------------------------------------------------------------------------
std::array<float, 2> FindDepths(const MeshCoordinates& coordinates, const RasterView& view)
{
  const glm::dmat4& meshToView = view.Rays->MeshToView;
  const double middle = -meshToView[3].z - view.Rays->Reference;
  double half = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec4 corner(CornerOf(coordinates, i), 0.0);
    half = std::max(half, std::abs((meshToView * corner).z));
  }
  // A little more, for what rounding puts beyond.
  half *= 1.001;
  return { { static_cast<float>(middle - half), static_cast<float>(2.0 * half) } };
}

//------------------------------------------------------------------------------
std::array<int, 4> FindScreenBox(const MeshCoordinates& coordinates, const RasterView& view)
{
  std::vector<float> points;
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec3 corner = CornerOf(coordinates, i);
    points.insert(points.end(), { static_cast<float>(corner.x), static_cast<float>(corner.y),
                                  static_cast<float>(corner.z), 0.0f });
  }
  const std::vector<int> corners = { 0, 1, 2, 3, 4, 5, 6, 7 };
  const unsigned int cells[2] = { 0, 1 };
  return ScreenBox::Around(
    points, corners, cells, 2, { view.Rays->MeshToClip, view.Width, view.Height });
}
}
