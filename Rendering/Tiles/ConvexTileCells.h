/**
 * Where convex cells lie on the screen.
 */
#ifndef ConvexTileCells_h
#define ConvexTileCells_h

#include <array>
#include <cstdint>
#include <vector>

class ConvexTileFaces;
class ConvexTileMesh;
class TileClusters;
class TileVertices;
class TileView;

class ConvexTileCells
{
public:
  /** Cells that are not drawn, or in clusters that are not seen, get no tile, and nothing else is said
   *  of them. `allExact`: whether all are set up in double. */
  void Project(const ConvexTileMesh& mesh, const TileView& view, const TileVertices& vertices,
    const TileClusters& clusters, const ConvexTileFaces& faces, bool allExact);

  /** As those of class TileCells. */
  std::vector<std::uint32_t> Tiles;
  /** First and last pixel column, first and last row. */
  std::vector<std::array<short, 4>> Boxes;
  /** u of its corners; without bounds where one of them has no place on the screen. */
  struct Depths
  {
    float Farthest, Nearest;
  };
  std::vector<Depths> Ranges;
  /** Not 0: floats do not serve the cell. */
  enum Doubt : unsigned char
  {
    None,
    /** All corners have a place on the screen: planes in double may serve. */
    OnScreen,
    /** It needs class ConvexTileExactCell. */
    AlongRays
  };
  std::vector<Doubt> Exact;

  /** A ray's weight (class TileView) falls to a lesser share within no cell that floats serve; what
   *  is drawn in double is cut into parts, at most so many. */
  static constexpr double LeastShare = 0.125;
  static constexpr int MostParts = 16;

private:
  void ProjectCell(const ConvexTileMesh& mesh, const TileView& view, const TileVertices& vertices,
    const ConvexTileFaces& faces, bool isExact, int cell);
  void SetBox(int cell, const std::array<int, 4>& box);
};

#endif
