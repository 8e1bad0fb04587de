#include "TileVertices.h"

#include "TileView.h"
#include "vtkSMPTools.h"

#include <glm/vec4.hpp>

#include <cmath>

namespace
{
void TransformPoint(const TileView& view, const float* point, float* out)
{
  const glm::dvec4 screen = view.MeshToScreen * glm::dvec4(point[0], point[1], point[2], 1.0);
  const double inverse = 1.0 / screen.w;
  const double x = screen.x * inverse, y = screen.y * inverse, u = screen.z * inverse;
  const bool inside = screen.w > 0.0 && u < view.NearU && u > view.FarU &&
                      std::abs(x) < TileVertices::Farthest && std::abs(y) < TileVertices::Farthest;
  out[0] = inside ? static_cast<float>(x) : TileVertices::OffScreen;
  out[1] = inside ? static_cast<float>(y) : TileVertices::OffScreen;
  out[2] = inside ? static_cast<float>(u) : 0.0f;
  out[3] = point[3];
}
}

//------------------------------------------------------------------------------
void TileVertices::Transform(const std::vector<float>& points, const TileView& view)
{
  this->Values.resize(points.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(points.size() / 4),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        TransformPoint(view, &points[4 * i], &this->Values[4 * i]);
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
