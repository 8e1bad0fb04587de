#include "TileVertices.h"

#include "TileClusterBlocks.h"
#include "TileView.h"
#include "vtkSMPTools.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
// Share of the near plane's u by which rounding may take a point on it for one behind it.
constexpr double Rounding = 1e-14;

void TransformPoint(const TileView& view, const float* point, float* out)
{
  const glm::dvec4 screen = view.MeshToScreen * glm::dvec4(point[0], point[1], point[2], 1.0);
  const double inverse = 1.0 / screen.w;
  const double x = screen.x * inverse, y = screen.y * inverse, u = screen.z * inverse;
  const double nearest = view.NearU - Rounding * std::abs(view.NearU);
  const bool inside = screen.w > 0.0 && u < nearest && u > view.FarU &&
                      std::abs(x) < TileVertices::Farthest && std::abs(y) < TileVertices::Farthest;
  out[0] = inside ? static_cast<float>(x) : TileVertices::OffScreen;
  out[1] = inside ? static_cast<float>(y) : TileVertices::OffScreen;
  out[2] = inside ? static_cast<float>(u) : 0.0f;
  out[3] = point[3];
}
}

//------------------------------------------------------------------------------
void TileVertices::Transform(
  const std::vector<float>& points, const TileView& view, const TileClusterBlocks* blocks)
{
  this->Values.resize(points.size());
  const std::size_t count = points.size() / 4;
  constexpr std::size_t Block = TileClusterBlocks::Size;
  vtkSMPTools::For(0, static_cast<vtkIdType>((count + Block - 1) / Block),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto block = static_cast<std::size_t>(begin); block < static_cast<std::size_t>(end); ++block)
      {
        if (blocks && !blocks->IsSeen(block))
        {
          continue;
        }
        for (std::size_t i = block * Block; i < std::min((block + 1) * Block, count); ++i)
        {
          TransformPoint(view, &points[4 * i], &this->Values[4 * i]);
        }
      }
    });
}

//------------------------------------------------------------------------------
void TileVertices::CopyScalars(const std::vector<float>& points)
{
  for (std::size_t i = 3; i < this->Values.size(); i += 4)
  {
    this->Values[i] = points[i];
  }
}
