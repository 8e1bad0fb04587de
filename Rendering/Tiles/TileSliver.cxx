#include "TileSliver.h"

#include "TileMesh.h"
#include "TileVertices.h"
#include "TileView.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace
{
using Point = std::array<double, 2>;

// How far rounding may move a coordinate, as its share.
constexpr double Rounding = 1.0 / (1 << 24);

// Whether a pixel lies within `margin` of the edge, across the axis that it runs along.
bool IsNearPixel(const Point& from, const Point& to, double margin, const TileView& view)
{
  const int along = std::abs(to[0] - from[0]) < std::abs(to[1] - from[1]) ? 1 : 0;
  const int across = 1 - along;
  const double slope = (to[across] - from[across]) / (to[along] - from[along]);
  const double begin = std::ceil(std::max(std::min(from[along], to[along]) - margin, 0.0));
  const double last = (along == 0 ? view.Width : view.Height) - 1.0;
  const double end = std::min(std::max(from[along], to[along]) + margin, last);
  bool isNear = false;
  for (double pixel = begin; !isNear && pixel <= end; pixel += 1.0)
  {
    const double at = from[across] + (pixel - from[along]) * slope;
    isNear = std::abs(at - std::round(at)) <= margin;
  }
  return isNear;
}

bool FaceMeetsPixel(const Point (&corners)[3], const TileView& view)
{
  double extent = 0.0, farthest = 0.0, longest = 0.0;
  int first = 0;
  for (int i = 0; i < 3; ++i)
  {
    const Point &a = corners[i], &b = corners[(i + 1) % 3];
    const double x = std::abs(b[0] - a[0]), y = std::abs(b[1] - a[1]);
    farthest = std::max({ farthest, std::abs(a[0]), std::abs(a[1]) });
    extent = std::max(extent, x + y);
    first = std::max(x, y) > longest ? i : first;
    longest = std::max({ longest, x, y });
  }
  const Point &a = corners[0], &b = corners[1], &c = corners[2];
  const double area = std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  if (area > 2.0 * TileSliver::AreaRounding * extent * farthest)
  {
    return false;
  }
  // The third corner lies so far from the longest edge, and each where rounding has moved it.
  const double margin = area / longest + 4.0 * Rounding * farthest;
  return !(longest > 0.0) || IsNearPixel(corners[first], corners[(first + 1) % 3], margin, view);
}
}

//------------------------------------------------------------------------------
bool TileSliver::MeetsPixel(
  const TileMesh& mesh, const TileView& view, const TileVertices& vertices, int cell)
{
  return std::any_of(std::begin(TileMesh::FaceCorners), std::end(TileMesh::FaceCorners),
    [&](const int (&side)[3])
    {
      Point corners[3];
      for (int i = 0; i < 3; ++i)
      {
        const int corner = mesh.Corners[4 * static_cast<std::size_t>(cell) + side[i]];
        const float* at = &vertices.Values[4 * static_cast<std::size_t>(corner)];
        corners[i] = { at[0], at[1] };
      }
      return FaceMeetsPixel(corners, view);
    });
}
