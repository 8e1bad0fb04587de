#include "PlaneDivision.h"

#include "ExteriorGeometry.h"

#include <cstdlib>

//------------------------------------------------------------------------------
std::vector<ExteriorFace> PlaneDivision::Run(
  ExteriorGeometry& geometry, const ExteriorFace& pattern) const
{
  std::vector<PlanarRegion::Segment> segments;
  std::vector<int> points;
  for (const auto& edge : this->Edges)
  {
    const PlanarRegion::Point low = geometry.Project(pattern.Plane, edge.first.first);
    const PlanarRegion::Point high = geometry.Project(pattern.Plane, edge.first.second);
    for (int i = 0; i < std::abs(edge.second); ++i)
    {
      segments.push_back(
        edge.second > 0 ? PlanarRegion::Segment{ low, high } : PlanarRegion::Segment{ high, low });
    }
    if (edge.second != 0)
    {
      points.push_back(edge.first.first);
      points.push_back(edge.first.second);
    }
  }
  std::vector<ExteriorFace> faces;
  for (const PlanarRegion::Polygon& polygon : PlanarRegion::Partition(segments, geometry.Tolerance))
  {
    ExteriorFace face = pattern;
    face.Corners.clear();
    for (const PlanarRegion::Point& at : polygon)
    {
      const int point = geometry.FindPoint(pattern.Plane, at, points);
      points.push_back(point);
      if (face.Corners.empty() || (face.Corners.back() != point && face.Corners.front() != point))
      {
        face.Corners.push_back(point);
      }
    }
    if (face.Corners.size() > 2)
    {
      faces.push_back(std::move(face));
    }
  }
  return faces;
}
