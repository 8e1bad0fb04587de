#ifndef MeshBlocks_h
#define MeshBlocks_h

#include "vtkType.h"

#include <cstddef>
#include <vector>

/**
 * @class MeshBlock
 * @brief A run of tetrahedra with points of its own: its corners count in PointIds.
 */
struct MeshBlock
{
  vtkIdType Begin = 0;
  vtkIdType End = 0;
  std::vector<int> PointIds;
  std::vector<int> Corners;
};

/**
 * @class MeshBlocks
 * @brief A mesh cut into runs of cells, of which one at a time is on the GPU.
 */
class MeshBlocks
{
public:
  /// No block is smaller, whatever the limit.
  static constexpr size_t LeastBytes = 16384;

  /// `corners`: 4 ids per cell. A block's points and scalars take up to `bytes`.
  void Build(const std::vector<int>& corners, size_t numberOfPoints, bool onePerCell, size_t bytes);

  /// What the whole mesh takes.
  static size_t CountBytes(size_t numberOfPoints, size_t numberOfScalars);

  std::vector<MeshBlock> Blocks;
};

#endif
