#include "MeshBlocks.h"

#include <algorithm>

namespace
{
constexpr size_t BytesPerPoint = 4 * sizeof(float);
constexpr size_t BytesPerScalar = sizeof(float);
}

//------------------------------------------------------------------------------
size_t MeshBlocks::CountBytes(size_t numberOfPoints, size_t numberOfScalars)
{
  return BytesPerPoint * numberOfPoints + BytesPerScalar * numberOfScalars;
}

//------------------------------------------------------------------------------
void MeshBlocks::Build(
  const std::vector<int>& corners, size_t numberOfPoints, bool onePerCell, size_t bytes)
{
  const size_t room = std::max(bytes, LeastBytes);
  const auto cells = static_cast<vtkIdType>(corners.size() / 4);
  // The number of a point within the last block that took it.
  std::vector<int> numbers(numberOfPoints, 0);
  std::vector<int> takenBy(numberOfPoints, -1);
  this->Blocks.clear();
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    const auto fits = [&](const MeshBlock& block)
    {
      const size_t points = block.PointIds.size() + 4;
      return CountBytes(points, onePerCell ? cell + 1 - block.Begin : points) <= room;
    };
    if (this->Blocks.empty() || !fits(this->Blocks.back()))
    {
      this->Blocks.push_back({ cell, cell, {}, {} });
    }
    MeshBlock& block = this->Blocks.back();
    for (const int* id = &corners[4 * cell]; id != &corners[4 * cell] + 4; ++id)
    {
      const int number = static_cast<int>(this->Blocks.size()) - 1;
      if (takenBy[*id] != number)
      {
        takenBy[*id] = number;
        numbers[*id] = static_cast<int>(block.PointIds.size());
        block.PointIds.push_back(*id);
      }
      block.Corners.push_back(numbers[*id]);
    }
    block.End = cell + 1;
  }
}
