/**
 * Runs of cells that follow each other in memory, and so lie close, with the box that holds them: one
 * that cannot be seen costs a test, not its cells, nor the points that they alone have.
 *
 * Not seen is what lies outside the viewport, the near or the far plane or a clipping plane, or behind
 * the opaque depth of every tile that its box touches. The tests err on the side of seen: no pixel
 * changes. Tetrahedra that the transfer function leaves empty are seen, since they order others, unless
 * they are most (TileMesh::IsSparse): then clusters of them alone are not. Of convex cells, which nothing
 * orders, clusters of empty ones are never seen.
 */
#ifndef TileClusters_h
#define TileClusters_h

#include "TileClusterBlocks.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

class ConvexTileMesh;
class TileLimits;
class TileMesh;
class TileView;

class TileClusters
{
public:
  /** Cells of a cluster. */
  static constexpr int Shift = 7;
  static constexpr int Size = 1 << Shift;

  void Build(const TileMesh& mesh);
  void Build(const ConvexTileMesh& mesh);
  /** Which cells are worth drawing is new. */
  void CountDrawn(const TileMesh& mesh);
  void CountDrawn(const ConvexTileMesh& mesh);

  /** `planes`: view coordinates, the positive side stays; `limits` null for none. True where other
   *  clusters are seen than before. */
  bool FindSeen(
    const TileView& view, const std::vector<glm::vec4>& planes, const TileLimits* limits);

  /** All of them are seen; true where that is new. */
  bool SeeAll();

  bool IsSeen(int cell) const { return this->Seen[static_cast<std::size_t>(cell) >> Shift] != 0; }
  const TileClusterBlocks& GetPoints() const { return this->Points; }
  /** Of convex cells alone. */
  const TileClusterBlocks& GetFaces() const { return this->Faces; }

  /** Of the cells worth drawing, those in clusters that are not seen. */
  long long CountCellsOutside() const;
  /** All cells of clusters that are seen. */
  long long CountCellsSeen() const;
  std::size_t GetMemorySize() const;

private:
  /** Marks blocks; true where other clusters are seen than before. */
  bool TakeSeen();
  struct Box
  {
    float Low[3], High[3];
  };
  /** `corners`: point ids, those of cluster i from `begins`[i] to `begins`[i + 1]. */
  void Build(const std::vector<float>& points, const std::vector<int>& corners,
    const std::vector<std::size_t>& begins, int cells);
  static Box FindBox(const std::vector<float>& points, const int* begin, const int* end);
  void CountDrawn(const std::vector<unsigned char>& drawn, bool skipsEmpty);
  /** Whether any of a box is on the positive side of every plane; before the opaque depth. */
  static bool IsWithin(const Box& box, const std::vector<glm::dvec4>& planes);
  static bool IsBefore(const Box& box, const TileView& view, const TileLimits& limits);

  std::vector<Box> Boxes;
  TileClusterBlocks Points, Faces;
  std::vector<glm::dvec4> Planes;
  int NumberOfCells = 0;
  std::vector<unsigned char> NumbersDrawn;
  /** Whether clusters with nothing to draw are not seen. */
  bool SkipsEmpty = false;
  std::vector<unsigned char> Seen, SeenBefore;
};

#endif
