#include "NumberedTriangles.h"

//------------------------------------------------------------------------------
NumberedTriangles::NumberedTriangles(
  const std::vector<int>& triangles, std::size_t numberOfVertices)
{
  std::vector<int> numbers(numberOfVertices, -1);
  const auto count = static_cast<int>(triangles.size() / 3);
  for (int triangle = 0; triangle < count; ++triangle)
  {
    const int* ids = &triangles[3 * static_cast<std::size_t>(triangle)];
    int last = 0;
    while (last < 2 && numbers[ids[last]] >= 0)
    {
      ++last;
    }
    numbers[ids[last]] = triangle;
    this->AppendCorners(ids[(last + 1) % 3], ids[(last + 2) % 3], ids[last]);
  }
  for (std::size_t vertex = 0; vertex < numberOfVertices; ++vertex)
  {
    if (numbers[vertex] < 0)
    {
      const auto id = static_cast<int>(vertex);
      numbers[vertex] = static_cast<int>(this->Corners.size() / 4);
      this->AppendCorners(id, id, id);
    }
  }
  for (int triangle = 0; triangle < count; ++triangle)
  {
    const int* ids = &this->Corners[4 * static_cast<std::size_t>(triangle)];
    this->Indices.insert(this->Indices.end(), { numbers[ids[0]], numbers[ids[1]], triangle });
  }
}

//------------------------------------------------------------------------------
void NumberedTriangles::AppendCorners(int a, int b, int c)
{
  this->Corners.insert(this->Corners.end(), { a, b, c, 0 });
}
