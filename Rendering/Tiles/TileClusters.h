/**
 * Runs of cells that follow each other in memory, and so lie close, with the box that holds them: one
 * that cannot be seen costs a test, not its cells, nor the points that they alone have.
 *
 * Not seen is what lies outside the viewport, the near or the far plane or a clipping plane, or behind
 * the opaque depth of every tile that its box touches. The tests err on the side of seen: no pixel
 * changes. Cells that the transfer function leaves empty are seen, since they order others, unless they
 * are most (TileMesh::IsSparse): then clusters of them alone are not.
 */
#ifndef TileClusters_h
#define TileClusters_h

#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

class TileLimits;
class TileMesh;
class TileView;

class TileClusters
{
public:
  /** Cells of a cluster, points of a block. */
  static constexpr int Shift = 7;
  static constexpr int Size = 1 << Shift;
  static constexpr int PointShift = 5;

  void Build(const TileMesh& mesh);
  /** Which cells are worth drawing is new. */
  void CountDrawn(const TileMesh& mesh);

  /** `planes`: view coordinates, the positive side stays; `limits` null for none. True where other
   *  clusters are seen than before. */
  bool FindSeen(
    const TileView& view, const std::vector<glm::vec4>& planes, const TileLimits* limits);

  bool IsSeen(int cell) const { return this->Seen[static_cast<std::size_t>(cell) >> Shift] != 0; }
  bool IsPointBlockSeen(std::size_t block) const { return this->SeenPoints[block] != 0; }

  /** Of the cells worth drawing, those in clusters that are not seen. */
  long long CountCellsOutside() const;
  /** All cells of clusters that are seen. */
  long long CountCellsSeen(const TileMesh& mesh) const;
  std::size_t GetMemorySize() const;

private:
  struct Box
  {
    float Low[3], High[3];
  };
  void FindBox(const TileMesh& mesh, int cluster);
  void ListPointBlocks(const TileMesh& mesh);
  void MarkPoints();
  /** Whether any of a box is on the positive side of every plane; before the opaque depth. */
  static bool IsWithin(const Box& box, const std::vector<glm::dvec4>& planes);
  static bool IsBefore(const Box& box, const TileView& view, const TileLimits& limits);

  std::vector<Box> Boxes;
  /** Blocks of points that a cluster's cells have: Blocks[BlocksBegin[i]] and on. */
  std::vector<int> BlocksBegin, Blocks;
  std::vector<glm::dvec4> Planes;
  std::vector<unsigned char> NumbersDrawn;
  /** Whether clusters with nothing to draw are not seen. */
  bool SkipsEmpty = false;
  std::vector<unsigned char> Seen, SeenBefore, SeenPoints;
};

#endif
