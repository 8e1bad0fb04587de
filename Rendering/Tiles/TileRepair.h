/**
 * Pixels whose pieces did not come from front to back: their fragments, gathered and put in order.
 *
 * Pieces that overlap come in the order of the depths of their middles.
 */
#ifndef TileRepair_h
#define TileRepair_h

#include <cstddef>
#include <cstdint>
#include <vector>

class TileView;
struct TileBuffer;
struct TileFragments;
struct TileRectangle;

class TileRepair
{
public:
  /** Takes the pixels that are wrong; returns their number. */
  int Find(const TileBuffer& tile);
  /** The part of a tile that holds them. */
  TileRectangle Box(const TileRectangle& tile) const;
  /** Keeps the cells that may cover marked pixels; `boxes`: see TileBox. */
  void KeepCells(std::vector<int>& cells, const std::vector<std::uint32_t>& boxes) const;
  /** Keeps what belongs to marked pixels. */
  void Collect(const TileFragments& fragments);
  /** Puts what was collected in order, pixel by pixel. */
  void Sort(const TileView& view);
  /** Clears marked pixels; their fragments are to be composited again. */
  void Clear(TileBuffer& tile) const;
  /** Moves the next ones into the queue; false where none are left. */
  bool Take(TileFragments& out);

  std::size_t GetMemorySize() const;

private:
  struct Fragment
  {
    float Entry, Extent, ScalarIn, ScalarOut;
    int Pixel, Cell;
  };
  /** How far a fragment's middle is, and which one it is. */
  struct Key
  {
    float Depth;
    std::uint32_t Fragment;
  };

  static float DepthOf(const Fragment& fragment, const TileView& view);
  static void SortPixel(Key* first, Key* last, Key* spare);

  std::vector<unsigned char> Marked;
  std::vector<Fragment> Fragments;
  // Pixel after pixel, and as many to merge into; where the keys of each pixel end.
  std::vector<Key> Keys, Spare;
  std::vector<std::uint32_t> Ends;
  std::size_t Taken = 0;
};

#endif
