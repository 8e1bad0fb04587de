#include "EdgeThrough.h"

#include "BoxTree.h"
#include "vtkMath.h"

#include <algorithm>

namespace
{
// Most edges are apart from most triangles.
bool AreNear(const double from[3], const double to[3], const EdgeThrough::Triangle& triangle)
{
  BoxTree::Box way, box;
  way.Add(from);
  way.Add(to);
  std::for_each(triangle.begin(), triangle.end(), [&](const double* corner) { box.Add(corner); });
  return way.Overlaps(box);
}

// The line meets the triangle where it passes all three edges on the same side, and well so: the
// volumes are compared with those of the same lengths at right angles.
bool PassesInside(const double from[3], const double along[3],
  const EdgeThrough::Triangle& triangle, double slack)
{
  int positive = 0, negative = 0;
  for (int i = 0; i < 3 && std::max(positive, negative) == i; ++i)
  {
    const double* corner = triangle[i];
    double edge[3], toCorner[3], cross[3];
    vtkMath::Subtract(triangle[(i + 1) % 3], corner, edge);
    vtkMath::Subtract(corner, from, toCorner);
    vtkMath::Cross(edge, toCorner, cross);
    const double side = vtkMath::Dot(cross, along);
    const double bound = slack * vtkMath::Norm(edge) * vtkMath::Norm(along);
    positive += side > bound ? 1 : 0;
    negative += side < -bound ? 1 : 0;
  }
  return positive == 3 || negative == 3;
}

bool EndsOnBothSides(const double from[3], const double along[3],
  const EdgeThrough::Triangle& triangle, double slack)
{
  double edges[2][3], normal[3], relative[3];
  vtkMath::Subtract(triangle[1], triangle[0], edges[0]);
  vtkMath::Subtract(triangle[2], triangle[1], edges[1]);
  vtkMath::Cross(edges[0], edges[1], normal);
  const double bound = slack * vtkMath::Norm(normal);
  vtkMath::Subtract(from, triangle[0], relative);
  const double atFrom = vtkMath::Dot(normal, relative);
  const double atTo = atFrom + vtkMath::Dot(normal, along);
  return std::min(atFrom, atTo) < -bound && std::max(atFrom, atTo) > bound;
}
}

//------------------------------------------------------------------------------
bool EdgeThrough::Runs(
  const double from[3], const double to[3], const Triangle& triangle, double slack)
{
  if (!AreNear(from, to, triangle))
  {
    return false;
  }
  double along[3];
  vtkMath::Subtract(to, from, along);
  return PassesInside(from, along, triangle, slack) &&
         EndsOnBothSides(from, along, triangle, slack);
}
