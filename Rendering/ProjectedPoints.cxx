#include "ProjectedPoints.h"

#include "ViewRays.h"
#include "vtkSMPTools.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

//------------------------------------------------------------------------------
double ProjectedPoints::LengthAt(const glm::dvec2& screen) const
{
  const ViewRays& rays = *this->Rays;
  const glm::dvec2 size(rays.Size);
  const glm::dvec2 step = (0.5 * screen + 0.5) * size - glm::dvec2(rays.Pixel);
  return glm::length(glm::dvec3(rays.World[0]) + step.x * glm::dvec3(rays.World[1]) +
                     step.y * glm::dvec3(rays.World[2]));
}

//------------------------------------------------------------------------------
ProjectedPoints::Point ProjectedPoints::Project(const glm::dvec3& place) const
{
  const glm::dvec4 clip = glm::dmat4(this->Rays->MeshToClip) * glm::dvec4(place, 1.0);
  Point point;
  point.Ray = { clip.x, clip.y, clip.w };
  point.Depth = -(this->Rays->MeshToView * glm::dvec4(place, 1.0)).z - this->Rays->Reference;
  point.Place = place;
  point.Length = this->IsBeforeNearPlane(point) ? this->LengthAt(point.GetScreen()) : 0.0;
  return point;
}

//------------------------------------------------------------------------------
void ProjectedPoints::Build(const std::vector<float>& points, const ViewRays& rays)
{
  this->Rays = &rays;
  this->Near = rays.Near - rays.Reference;
  this->Points.resize(points.size() / 4);
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Points.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType id = begin; id < end; ++id)
      {
        this->Points[id] = this->Project(glm::dvec3(glm::make_vec3(&points[4 * id])));
      }
    });
}

//------------------------------------------------------------------------------
ProjectedPoints::Point ProjectedPoints::CutAtNearPlane(
  const Point& kept, const Point& lost, double& weight) const
{
  weight = std::clamp((kept.Depth - this->Near) / (kept.Depth - lost.Depth), 0.0, 1.0);
  Point point;
  point.Ray = glm::mix(kept.Ray, lost.Ray, weight);
  point.Depth = glm::mix(kept.Depth, lost.Depth, weight);
  point.Place = glm::mix(kept.Place, lost.Place, weight);
  point.Length = this->LengthAt(point.GetScreen());
  return point;
}
