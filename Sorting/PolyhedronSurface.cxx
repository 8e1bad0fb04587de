#include "PolyhedronSurface.h"

#include <algorithm>
#include <tuple>

namespace
{
vtkIdType CountDistinct(std::vector<vtkIdType> ids)
{
  std::sort(ids.begin(), ids.end());
  return std::unique(ids.begin(), ids.end()) - ids.begin();
}
}

bool PolyhedronSurface::Read(
  const vtkIdType* stream, vtkIdType length, const vtkIdType* canonical, vtkIdType numberOfPoints)
{
  this->Corners.clear();
  this->Offsets.assign(1, 0);
  vtkIdType at = 1;
  for (vtkIdType left = length > 0 ? stream[0] : 0; left > 0; --left)
  {
    const vtkIdType count = at < length ? stream[at] : 0;
    if (count < 3 || count > length - at - 1 ||
        !this->AddFace(stream + at + 1, count, canonical, numberOfPoints))
    {
      return false;
    }
    at += 1 + count;
  }
  this->NumberVertices();
  return at == length && stream[0] > 0;
}

bool PolyhedronSurface::AddFace(
  const vtkIdType* points, vtkIdType count, const vtkIdType* canonical, vtkIdType numberOfPoints)
{
  const auto exists = [=](vtkIdType id) { return id >= 0 && id < numberOfPoints; };
  if (!std::all_of(points, points + count, exists) || CountDistinct({ points, points + count }) < 3)
  {
    return false;
  }
  std::vector<vtkIdType> face;
  for (vtkIdType i = 0; i < count; ++i)
  {
    face.push_back(canonical[points[i]]);
  }
  const bool known = *std::min_element(face.begin(), face.end()) >= 0;
  face.erase(std::unique(face.begin(), face.end()), face.end());
  while (face.size() > 1 && face.front() == face.back())
  {
    face.pop_back();
  }
  if (known && face.size() < 3)
  {
    return true;
  }
  this->Corners.insert(this->Corners.end(), face.begin(), face.end());
  this->Offsets.push_back(static_cast<int>(this->Corners.size()));
  // A face that meets itself has no inside.
  return !known || CountDistinct(face) == static_cast<vtkIdType>(face.size());
}

void PolyhedronSurface::NumberVertices()
{
  this->Ids = this->Corners;
  std::sort(this->Ids.begin(), this->Ids.end());
  this->Ids.erase(std::unique(this->Ids.begin(), this->Ids.end()), this->Ids.end());
  this->Vertices.clear();
  for (const vtkIdType id : this->Corners)
  {
    const auto found = std::lower_bound(this->Ids.begin(), this->Ids.end(), id);
    this->Vertices.push_back(static_cast<int>(found - this->Ids.begin()));
  }
}

int PolyhedronSurface::Next(int position) const
{
  const int face = this->Faces[position];
  return position + 1 < this->Offsets[face + 1] ? position + 1 : this->Offsets[face];
}

PolyhedronSurface::Defect PolyhedronSurface::Orient()
{
  const int faces = static_cast<int>(this->Offsets.size()) - 1;
  this->Faces.clear();
  for (int face = 0; face < faces; ++face)
  {
    this->Faces.resize(this->Offsets[face + 1], face);
  }
  this->Turned.assign(faces, 0);
  return this->FindMates() ? this->TurnFromFirst() : Defect::Open;
}

bool PolyhedronSurface::FindMates()
{
  std::vector<std::tuple<int, int, int>> edges;
  for (int position = 0; position < static_cast<int>(this->Vertices.size()); ++position)
  {
    const auto ends =
      std::minmax({ this->Vertices[position], this->Vertices[this->Next(position)] });
    edges.emplace_back(ends.first, ends.second, position);
  }
  std::sort(edges.begin(), edges.end());
  this->Mates.resize(edges.size());
  const auto same = [&edges](std::size_t i, std::size_t j)
  {
    return j < edges.size() && std::get<0>(edges[i]) == std::get<0>(edges[j]) &&
           std::get<1>(edges[i]) == std::get<1>(edges[j]);
  };
  for (std::size_t i = 0; i < edges.size(); i += 2)
  {
    if (!same(i, i + 1) || same(i, i + 2))
    {
      return false;
    }
    const int first = std::get<2>(edges[i]), second = std::get<2>(edges[i + 1]);
    this->Mates[first] = second;
    this->Mates[second] = first;
  }
  return true;
}

PolyhedronSurface::Defect PolyhedronSurface::TurnFromFirst()
{
  std::vector<char> reached(this->Turned.size(), 0);
  std::vector<int> waiting;
  if (!reached.empty())
  {
    reached[0] = 1;
    waiting.push_back(0);
  }
  std::size_t count = waiting.size();
  while (!waiting.empty())
  {
    const int face = waiting.back();
    waiting.pop_back();
    for (int position = this->Offsets[face]; position < this->Offsets[face + 1]; ++position)
    {
      const int mate = this->Mates[position];
      const int other = this->Faces[mate];
      const char along = this->Vertices[position] == this->Vertices[mate];
      const char turned = this->Turned[face] ^ along;
      if (!reached[other])
      {
        reached[other] = 1;
        this->Turned[other] = turned;
        waiting.push_back(other);
        ++count;
      }
      else if (this->Turned[other] != turned)
      {
        return Defect::Open;
      }
    }
  }
  for (int face = 0; face < static_cast<int>(this->Turned.size()); ++face)
  {
    if (this->Turned[face])
    {
      this->TurnFace(face);
    }
  }
  return count == reached.size() ? Defect::None : Defect::SeveralPieces;
}

void PolyhedronSurface::TurnFace(int face)
{
  // The first corner stays the first.
  std::reverse(this->Vertices.begin() + this->Offsets[face] + 1,
    this->Vertices.begin() + this->Offsets[face + 1]);
}

void PolyhedronSurface::Turn()
{
  for (int face = 0; face < static_cast<int>(this->Turned.size()); ++face)
  {
    this->TurnFace(face);
    this->Turned[face] ^= 1;
  }
}

int PolyhedronSurface::GetNumberOfTurnedFaces() const
{
  return static_cast<int>(std::count(this->Turned.begin(), this->Turned.end(), 1));
}

TetrahedralSplit::Solid PolyhedronSurface::GetSolid() const
{
  return { static_cast<int>(this->Ids.size()), static_cast<int>(this->Offsets.size()) - 1,
    this->Offsets.data(), this->Vertices.data() };
}
