#include "TetrahedronParts.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>

namespace
{
struct Corner
{
  ProjectedPoints::Point Point;
  glm::vec4 Value;
};

ProjectedTetrahedron MakePart(const Corner& a, const Corner& b, const Corner& c, const Corner& d)
{
  return ProjectedTetrahedron({ { a.Point, b.Point, c.Point, d.Point } },
    { { a.Value, b.Value, c.Value, d.Value } }, -1);
}

// Two triangles and the edges between their corners of one number, as three tetrahedra in a row.
std::vector<ProjectedTetrahedron> SplitPrism(
  const std::array<Corner, 3>& p, const std::array<Corner, 3>& q)
{
  const ProjectedTetrahedron first = MakePart(p[0], p[1], p[2], q[0]);
  const ProjectedTetrahedron middle = MakePart(p[1], p[2], q[0], q[1]);
  const ProjectedTetrahedron last = MakePart(p[2], q[0], q[1], q[2]);
  // Each shares the face opposite its first corner with the next: where the eye sees that face, the
  // next one lies before it.
  std::vector<ProjectedTetrahedron> parts{ middle };
  parts.insert(first.IsFrontFace(0) ? parts.begin() : parts.end(), first);
  parts.insert(middle.IsFrontFace(0) ? parts.end() : parts.begin(), last);
  return parts;
}
}

namespace TetrahedronParts
{
//------------------------------------------------------------------------------
std::vector<ProjectedTetrahedron> BeforeNearPlane(const ProjectedPoints& points,
  const ProjectedTetrahedron::Corners& corners, const ProjectedTetrahedron::Values& values,
  int cell)
{
  std::vector<Corner> kept, lost;
  for (int i = 0; i < 4; ++i)
  {
    (points.IsBeforeNearPlane(corners[i]) ? kept : lost).push_back({ corners[i], values[i] });
  }
  auto cut = [&](int k, int l)
  {
    double weight = 0.0;
    const ProjectedPoints::Point point =
      points.CutAtNearPlane(kept[k].Point, lost[l].Point, weight);
    return Corner{ point, glm::mix(kept[k].Value, lost[l].Value, static_cast<float>(weight)) };
  };
  switch (kept.size())
  {
    case 0:
      return {};
    case 1:
      return { MakePart(kept[0], cut(0, 0), cut(0, 1), cut(0, 2)) };
    case 2:
      return SplitPrism(
        { { kept[0], cut(0, 0), cut(0, 1) } }, { { kept[1], cut(1, 0), cut(1, 1) } });
    case 3:
      return SplitPrism(
        { { kept[0], kept[1], kept[2] } }, { { cut(0, 0), cut(1, 0), cut(2, 0) } });
    default:
      return { ProjectedTetrahedron(corners, values, cell) };
  }
}
}
