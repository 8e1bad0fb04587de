#include "ExteriorPart.h"

#include "ExteriorGeometry.h"
#include "vtkMath.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <unordered_map>

namespace
{
// Sets that are joined one by one; `Find` names the one that an element is in.
class DisjointSets
{
public:
  explicit DisjointSets(size_t count)
    : Parents(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }
  int Find(int element)
  {
    while (this->Parents[element] != element)
    {
      this->Parents[element] = this->Parents[this->Parents[element]];
      element = this->Parents[element];
    }
    return element;
  }
  void Join(int a, int b) { this->Parents[this->Find(a)] = this->Find(b); }

private:
  std::vector<int> Parents;
};
}

//------------------------------------------------------------------------------
double ExteriorPart::GetVolume(const ExteriorGeometry& geometry) const
{
  double volume = 0.0;
  if (this->Faces.empty())
  {
    return volume;
  }
  const double* origin = geometry.At(this->Faces.front().Corners.front());
  for (const ExteriorFace& face : this->Faces)
  {
    double corners[3][3];
    vtkMath::Subtract(geometry.At(face.Corners[0]), origin, corners[0]);
    for (size_t i = 2; i < face.Corners.size(); ++i)
    {
      vtkMath::Subtract(geometry.At(face.Corners[i - 1]), origin, corners[1]);
      vtkMath::Subtract(geometry.At(face.Corners[i]), origin, corners[2]);
      volume += vtkMath::Determinant3x3(corners[0], corners[1], corners[2]) / 6.0;
    }
  }
  return volume;
}

//------------------------------------------------------------------------------
bool ExteriorPart::IsClosed() const
{
  std::map<std::pair<int, int>, int> edges;
  for (const ExteriorFace& face : this->Faces)
  {
    for (size_t i = 0; i < face.Corners.size(); ++i)
    {
      const int from = face.Corners[i];
      const int to = face.Corners[(i + 1) % face.Corners.size()];
      edges[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

//------------------------------------------------------------------------------
std::vector<ExteriorPart> ExteriorPart::FindComponents() const
{
  DisjointSets sets(this->Faces.size());
  std::unordered_map<int, int> faceOfPoint;
  for (int f = 0; f < static_cast<int>(this->Faces.size()); ++f)
  {
    for (const int point : this->Faces[f].Corners)
    {
      const auto inserted = faceOfPoint.emplace(point, f);
      sets.Join(f, inserted.first->second);
    }
  }
  std::unordered_map<int, int> partOfSet;
  std::vector<ExteriorPart> parts;
  for (int f = 0; f < static_cast<int>(this->Faces.size()); ++f)
  {
    const auto inserted = partOfSet.emplace(sets.Find(f), static_cast<int>(parts.size()));
    if (inserted.second)
    {
      parts.emplace_back();
      parts.back().UsedPlanes = this->UsedPlanes;
    }
    parts[inserted.first->second].Faces.push_back(this->Faces[f]);
  }
  return parts;
}

//------------------------------------------------------------------------------
std::vector<ExteriorPart> ExteriorPart::Separate(const ExteriorGeometry& geometry) const
{
  std::vector<ExteriorPart> separate;
  ExteriorPart rest;
  rest.UsedPlanes = this->UsedPlanes;
  for (ExteriorPart& part : this->FindComponents())
  {
    if (!part.IsClosed())
    {
      std::move(part.Faces.begin(), part.Faces.end(), std::back_inserter(rest.Faces));
      continue;
    }
    if (part.GetVolume(geometry) < 0.0)
    {
      return { *this };
    }
    separate.push_back(std::move(part));
  }
  if (!rest.Faces.empty())
  {
    separate.push_back(std::move(rest));
  }
  return separate;
}

//------------------------------------------------------------------------------
std::vector<int> ExteriorPart::GetPoints() const
{
  std::vector<int> points;
  for (const ExteriorFace& face : this->Faces)
  {
    points.insert(points.end(), face.Corners.begin(), face.Corners.end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

//------------------------------------------------------------------------------
bool ExteriorPart::HasUsed(int plane) const
{
  return std::binary_search(this->UsedPlanes.begin(), this->UsedPlanes.end(), plane);
}
