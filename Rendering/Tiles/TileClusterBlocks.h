/**
 * Blocks of points, or of faces, that each cluster's cells have (class TileClusters): those that no seen
 * cluster has need no place on the screen.
 */
#ifndef TileClusterBlocks_h
#define TileClusterBlocks_h

#include <cstddef>
#include <vector>

class TileClusterBlocks
{
public:
  /** Points, or faces, of a block. */
  static constexpr int Shift = 5;
  static constexpr int Size = 1 << Shift;

  /** `ids`: those of cluster i from `begins`[i] to `begins`[i + 1], each below `count`. None is seen. */
  void Build(
    const std::vector<int>& ids, const std::vector<std::size_t>& begins, std::size_t count);
  /** `clusters`: not 0 where seen. */
  void MarkSeen(const std::vector<unsigned char>& clusters);

  bool IsSeen(std::size_t block) const { return this->Seen[block] != 0; }
  std::size_t GetMemorySize() const;

private:
  /** Of a cluster: Blocks[BlocksBegin[i]] and on. */
  std::vector<int> BlocksBegin, Blocks;
  std::vector<unsigned char> Seen;
};

#endif
