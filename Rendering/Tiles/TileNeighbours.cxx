#include "TileNeighbours.h"

#include "TileMesh.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace
{
struct Face
{
  // The points but the smallest.
  std::array<int, 2> Others;
  // 4 * cell + face.
  int Place;
};


void Link(Face* begin, Face* end, std::vector<int>& neighbours)
{
  std::sort(begin, end,
    [](const Face& a, const Face& b)
    { return a.Others != b.Others ? a.Others < b.Others : a.Place < b.Place; });
  for (Face* face = begin; face < end - 1; ++face)
  {
    if (face[0].Others == face[1].Others)
    {
      neighbours[face[0].Place] = face[1].Place / 4;
      neighbours[face[1].Place] = face[0].Place / 4;
      ++face;
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<int> TileNeighbours::Find(const std::vector<int>& corners, int numberOfPoints)
{
  std::vector<std::size_t> first(static_cast<std::size_t>(numberOfPoints) + 2, 0);
  // A cell's smallest point has three of its faces, the next one the fourth.
  for (std::size_t at = 0; at < corners.size(); at += 4)
  {
    first[corners[at] + 2] += 3;
    first[corners[at + 1] + 2] += 1;
  }
  for (std::size_t point = 2; point < first.size(); ++point)
  {
    first[point] += first[point - 1];
  }
  std::vector<Face> faces(corners.size());
  for (std::size_t at = 0; at < corners.size(); ++at)
  {
    const int* own = &corners[at - at % 4];
    const int* side = TileMesh::FaceCorners[at % 4];
    faces[first[own[side[0]] + 1]++] = { { { own[side[1]], own[side[2]] } }, static_cast<int>(at) };
  }
  std::vector<int> neighbours(corners.size(), -1);
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        Link(faces.data() + first[point], faces.data() + first[point + 1], neighbours);
      }
    });
  return neighbours;
}
