#include "ExteriorCut.h"

#include "ExteriorGeometry.h"
#include "vtkMath.h"

#include <algorithm>

namespace
{
// Whether a face has corners below and above a plane.
struct Sides
{
  Sides(const ExteriorGeometry& geometry, const ExteriorFace& face, int plane)
  {
    for (const int corner : face.Corners)
    {
      const int side = geometry.SideOf(plane, corner);
      this->Below = this->Below || side < 0;
      this->Above = this->Above || side > 0;
    }
  }
  bool Below = false;
  bool Above = false;
};
}

//------------------------------------------------------------------------------
ExteriorCut::ExteriorCut(ExteriorGeometry& geometry, int plane, int cut)
  : Geometry(geometry)
  , Plane(plane)
  , Cut(cut)
{
}

//------------------------------------------------------------------------------
int ExteriorCut::CountSplits(const ExteriorGeometry& geometry, const ExteriorPart& part, int plane)
{
  return static_cast<int>(std::count_if(part.Faces.begin(), part.Faces.end(),
    [&](const ExteriorFace& face)
    {
      const Sides sides(geometry, face, plane);
      return sides.Below && sides.Above;
    }));
}

//------------------------------------------------------------------------------
void ExteriorCut::Run(const ExteriorPart& part, ExteriorPart& below, ExteriorPart& above)
{
  below.UsedPlanes = part.UsedPlanes;
  below.UsedPlanes.insert(
    std::upper_bound(below.UsedPlanes.begin(), below.UsedPlanes.end(), this->Plane), this->Plane);
  above.UsedPlanes = below.UsedPlanes;
  for (const ExteriorFace& face : part.Faces)
  {
    this->Distribute(face, below, above);
  }
  this->Close(below, above);
}

//------------------------------------------------------------------------------
void ExteriorCut::Distribute(const ExteriorFace& face, ExteriorPart& below, ExteriorPart& above)
{
  const Sides sides(this->Geometry, face, this->Plane);
  if (sides.Below && sides.Above)
  {
    for (const int side : { -1, 1 })
    {
      ExteriorFace clipped = this->Clip(face, side);
      if (clipped.Corners.size() > 2)
      {
        (side < 0 ? below : above).Faces.push_back(std::move(clipped));
      }
    }
    return;
  }
  bool isBelow = sides.Below;
  if (!sides.Below && !sides.Above)
  {
    // A face in the plane belongs to the volume behind it.
    const auto& normal = this->Geometry.Planes[this->Plane].Normal;
    const auto& own = this->Geometry.Planes[face.Plane].Normal;
    const double along = normal[0] * own[0] + normal[1] * own[1] + normal[2] * own[2];
    isBelow = along * face.Direction > 0.0;
  }
  (isBelow ? below : above).Faces.push_back(face);
}

//------------------------------------------------------------------------------
ExteriorFace ExteriorCut::Clip(const ExteriorFace& face, int side)
{
  ExteriorFace clipped = face;
  clipped.Corners.clear();
  const size_t count = face.Corners.size();
  for (size_t i = 0; i < count; ++i)
  {
    const int from = face.Corners[i];
    const int to = face.Corners[(i + 1) % count];
    const int atFrom = this->Geometry.SideOf(this->Plane, from);
    if (atFrom * side >= 0)
    {
      clipped.Corners.push_back(from);
    }
    if (atFrom * this->Geometry.SideOf(this->Plane, to) < 0)
    {
      clipped.Corners.push_back(this->FindIntersection(from, to));
    }
  }
  return clipped;
}

//------------------------------------------------------------------------------
int ExteriorCut::FindIntersection(int from, int to)
{
  // The same edge from either side must give the same point.
  const std::pair<int, int> key = std::minmax(from, to);
  const auto found = this->Intersections.find(key);
  if (found != this->Intersections.end())
  {
    return found->second;
  }
  const int point = this->Geometry.AddIntersection(key.first, key.second,
    this->Geometry.Distance(this->Plane, key.first),
    this->Geometry.Distance(this->Plane, key.second));
  this->Intersections.emplace(key, point);
  return point;
}

//------------------------------------------------------------------------------
PlaneDivision ExteriorCut::FindOutline(const ExteriorPart& half, bool turned, double& gap) const
{
  PlaneDivision outline;
  double sum[3] = { 0.0, 0.0, 0.0 };
  for (const ExteriorFace& face : half.Faces)
  {
    for (size_t i = 0; i < face.Corners.size(); ++i)
    {
      const int from = face.Corners[i];
      const int to = face.Corners[(i + 1) % face.Corners.size()];
      if (this->Geometry.SideOf(this->Plane, from) == 0 &&
          this->Geometry.SideOf(this->Plane, to) == 0)
      {
        outline.AddEdge(turned ? to : from, turned ? from : to);
        for (int k = 0; k < 3; ++k)
        {
          sum[k] += this->Geometry.At(to)[k] - this->Geometry.At(from)[k];
        }
      }
    }
  }
  gap = vtkMath::Norm(sum);
  return outline;
}

//------------------------------------------------------------------------------
void ExteriorCut::Close(ExteriorPart& below, ExteriorPart& above)
{
  // The section runs against the faces that it closes. Both halves have its outline; where a point
  // is hardly beyond the tolerance, one of them lacks an edge of it.
  double gapBelow = 0.0, gapAbove = 0.0;
  const PlaneDivision outlineBelow = this->FindOutline(below, true, gapBelow);
  const PlaneDivision outlineAbove = this->FindOutline(above, false, gapAbove);
  const PlaneDivision& outline =
    gapBelow <= gapAbove + this->Geometry.Tolerance ? outlineBelow : outlineAbove;
  ExteriorFace pattern;
  pattern.Plane = this->Plane;
  pattern.Cut = this->Cut;
  for (ExteriorFace& face : outline.Run(this->Geometry, pattern))
  {
    below.Faces.push_back(face);
    std::reverse(face.Corners.begin(), face.Corners.end());
    face.Direction = -1;
    above.Faces.push_back(std::move(face));
  }
}
