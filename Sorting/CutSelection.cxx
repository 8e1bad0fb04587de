#include "CutSelection.h"

#include "ExteriorCut.h"
#include "ExteriorGeometry.h"

#include <algorithm>
#include <unordered_map>

namespace
{
void SortUnique(std::vector<int>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

// Whether one of these points lies outside of a face's plane.
bool IsAnyOutside(
  const ExteriorGeometry& geometry, const ExteriorFace& face, const std::vector<int>& points)
{
  return std::any_of(points.begin(), points.end(),
    [&](int point) { return face.Direction * geometry.SideOf(face.Plane, point) > 0; });
}
}

//------------------------------------------------------------------------------
CutSelection::CutSelection(const ExteriorGeometry& geometry, int numberOfCandidates)
  : Geometry(geometry)
  , NumberOfCandidates(std::max(1, numberOfCandidates))
{
}

//------------------------------------------------------------------------------
int CutSelection::Choose(const ExteriorPart& part)
{
  std::vector<int> planes = this->FindPlanesAtConcaveEdges(part);
  if (planes.empty())
  {
    planes = this->FindPlanesWithPointsOutside(part);
  }
  int best = -1;
  int fewest = -1;
  for (int tried = 0; tried < this->NumberOfCandidates && !planes.empty() && fewest != 0; ++tried)
  {
    std::swap(planes[this->Random() % planes.size()], planes.back());
    const int plane = planes.back();
    planes.pop_back();
    const int splits = ExteriorCut::CountSplits(this->Geometry, part, plane);
    if (fewest < 0 || splits < fewest)
    {
      fewest = splits;
      best = plane;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
bool CutSelection::CanCut(const ExteriorPart& part, int plane) const
{
  // Everything lies within the planes of the enclosure.
  return this->Geometry.Planes[plane].Triangle >= 0 && !part.HasUsed(plane);
}

//------------------------------------------------------------------------------
std::vector<int> CutSelection::FindPlanesAtConcaveEdges(const ExteriorPart& part) const
{
  const auto key = [](int from, int to) { return (static_cast<long long>(from) << 32) | to; };
  std::unordered_map<long long, const ExteriorFace*> faceOfEdge;
  for (const ExteriorFace& face : part.Faces)
  {
    for (size_t i = 0; i < face.Corners.size(); ++i)
    {
      faceOfEdge[key(face.Corners[i], face.Corners[(i + 1) % face.Corners.size()])] = &face;
    }
  }
  std::vector<int> planes;
  for (const ExteriorFace& face : part.Faces)
  {
    for (size_t i = 0; i < face.Corners.size() && this->CanCut(part, face.Plane); ++i)
    {
      const auto found =
        faceOfEdge.find(key(face.Corners[(i + 1) % face.Corners.size()], face.Corners[i]));
      if (found != faceOfEdge.end() && IsAnyOutside(this->Geometry, face, found->second->Corners))
      {
        planes.push_back(face.Plane);
        break;
      }
    }
  }
  SortUnique(planes);
  return planes;
}

//------------------------------------------------------------------------------
std::vector<int> CutSelection::FindPlanesWithPointsOutside(const ExteriorPart& part) const
{
  const std::vector<int> points = part.GetPoints();
  std::vector<int> seen, planes;
  for (const ExteriorFace& face : part.Faces)
  {
    const int key = 2 * face.Plane + (face.Direction > 0);
    if (!this->CanCut(part, face.Plane) || std::find(seen.begin(), seen.end(), key) != seen.end())
    {
      continue;
    }
    seen.push_back(key);
    if (IsAnyOutside(this->Geometry, face, points))
    {
      planes.push_back(face.Plane);
    }
  }
  SortUnique(planes);
  return planes;
}
