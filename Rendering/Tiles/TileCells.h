/**
 * Where a mesh's cells lie on the screen, and which of their faces look away from the eye.
 *
 * The sign of a face is found from its points in ascending order, so that both of its cells agree.
 */
#ifndef TileCells_h
#define TileCells_h

#include <cstdint>
#include <vector>

class TileClusters;
class TileMesh;
class TileVertices;
class TileView;

/** Tiles are squares of pixels, or two of them, one above the other. */
namespace TileSize
{
constexpr int Shift = 6;
constexpr int Pixels = 1 << Shift;
constexpr int TallShift = Shift + 1;
constexpr int MostRows = 1 << TallShift;
/** Their numbers must fit a byte. */
constexpr int LargestImage = 256 << Shift;

/** Tiles of 1 << shift pixels in a row or column of so many. */
constexpr int CountOf(int pixels, int shift = Shift)
{
  return (pixels + (1 << shift) - 1) >> shift;
}

/** Tall tiles cut fewer cells: where that leaves some for every thread, and the cells of one do not fill its caches. The
 *  answer must not hang on the number of threads. */
constexpr int LeastTall = 128;
constexpr int MostCellsInTall = 16384;
constexpr int RowShiftOf(int width, int height, int cells)
{
  const int tiles = CountOf(width) * CountOf(height, TallShift);
  return tiles >= LeastTall && cells / tiles <= MostCellsInTall ? TallShift : Shift;
}

constexpr bool IsImage(int width, int height)
{
  return width > 0 && height > 0 && width <= LargestImage && height <= LargestImage;
}
}

class TileCells
{
public:
  /** Cells of clusters that are not seen get no tile, nor do those of a sparse mesh that are not
   *  drawn. */
  void Project(const TileMesh& mesh, const TileView& view, const TileVertices& vertices,
    const TileClusters& clusters);

  /** Of Boxes: first and last tile in x, first and last in y, a byte each from the lowest; first is
   *  greater than last where no pixel is covered. */
  static constexpr std::uint32_t NoTile = 0x00ff00ffu;
  /** Of Faces: bit f for face f, through which rays leave towards a neighbour. */
  static constexpr std::uint8_t ExitFaces = 15;
  /** Of Faces: rays enter the mesh through a face of the cell. */
  static constexpr std::uint8_t Entered = 16;
  /** Of Faces: what its faces say of the order is not certain: one is seen edge-on, or so nearly that
   *  rounding may turn it at a pixel (class TileSliver), or the cell is flat or lies over a neighbour. Exact cells are not certain either. */
  static constexpr std::uint8_t Unsure = 32;
  /** Of Faces: the cell needs class TileExactCell. */
  static constexpr std::uint8_t Exact = 128;

  std::vector<std::uint32_t> Boxes;
  std::vector<std::uint8_t> Faces;

private:
  void ProjectRange(const TileMesh& mesh, const TileView& view, const TileVertices& vertices,
    int first, int last);
  void ProjectExactly(const TileMesh& mesh, const TileView& view, int cell);
};

#endif
