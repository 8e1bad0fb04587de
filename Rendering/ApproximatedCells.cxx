#include "ApproximatedCells.h"

#include "CellApproximation.h"
#include "ProjectedPoints.h"
#include "TetrahedronParts.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace
{
// Cells of one task; tasks are joined in their order.
constexpr size_t BlockSize = 4096;

void AppendCell(const ApproximatedCells::Input& input, unsigned int cell,
  const CellApproximation& approximation, ApproximationTriangles& triangles)
{
  const int* ids = &input.Corners[4 * static_cast<size_t>(cell)];
  ProjectedTetrahedron::Corners corners;
  ProjectedTetrahedron::Values values;
  bool isWhole = true;
  for (int i = 0; i < 4; ++i)
  {
    corners[i] = input.Points[ids[i]];
    values[i] = input.Values[input.OnePerCell ? cell : static_cast<size_t>(ids[i])];
    isWhole = isWhole && input.Points.IsBeforeNearPlane(corners[i]);
  }
  auto append = [&](const ProjectedTetrahedron& tetrahedron)
  {
    if (tetrahedron.GetClass() != 0)
    {
      approximation.Append(tetrahedron, triangles);
    }
  };
  if (isWhole)
  {
    append(ProjectedTetrahedron(corners, values, static_cast<int>(cell)));
    return;
  }
  for (const ProjectedTetrahedron& part :
    TetrahedronParts::BeforeNearPlane(input.Points, corners, values, static_cast<int>(cell)))
  {
    append(part);
  }
}

ApproximationTriangles Join(const std::vector<ApproximationTriangles>& blocks)
{
  std::vector<size_t> vertices{ 0 }, indices{ 0 };
  for (const ApproximationTriangles& block : blocks)
  {
    vertices.push_back(vertices.back() + block.Vertices.size());
    indices.push_back(indices.back() + block.Indices.size());
  }
  ApproximationTriangles all;
  all.Vertices.resize(vertices.back());
  all.Indices.resize(indices.back());
  vtkSMPTools::For(0, static_cast<vtkIdType>(blocks.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const auto first = static_cast<unsigned int>(vertices[i]);
        std::copy(blocks[i].Vertices.begin(), blocks[i].Vertices.end(), &all.Vertices[vertices[i]]);
        std::transform(blocks[i].Indices.begin(), blocks[i].Indices.end(),
          &all.Indices[indices[i]], [first](unsigned int index) { return first + index; });
      }
    });
  return all;
}
}

//------------------------------------------------------------------------------
ApproximationTriangles ApproximatedCells::Build(
  const Input& input, const CellApproximation& approximation)
{
  std::vector<ApproximationTriangles> blocks((input.Order.size() + BlockSize - 1) / BlockSize);
  vtkSMPTools::For(0, static_cast<vtkIdType>(blocks.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i)
      {
        const size_t last = std::min((i + 1) * BlockSize, input.Order.size());
        blocks[i].Vertices.reserve(5 * BlockSize);
        blocks[i].Indices.reserve(11 * BlockSize);
        for (size_t at = i * BlockSize; at < last; ++at)
        {
          AppendCell(input, input.Order[at], approximation, blocks[i]);
        }
      }
    });
  return Join(blocks);
}
