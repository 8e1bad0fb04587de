/**
 * Which blocks of a tile's pixels hide what lies behind them, and from where on.
 *
 * A pixel hides the cells behind its last piece once next to no light comes through it. A block of
 * pixels hides what all of its pixels hide: the empty ones at a mesh's silhouette keep their own
 * blocks open, not the tile. What a cell hides in a pixel of proven order it hides wherever it comes,
 * so that the proof needs none of the cells that are left out; a pixel that is done again takes them
 * all.
 */
#ifndef TileOcclusion_h
#define TileOcclusion_h

#include "TileFragments.h"

#include <array>
#include <cstdint>

struct TileBuffer;
struct TileRectangle;
struct TileTask;

class TileOcclusion
{
public:
  /** Less than this of the light is next to none: ten times the brightest colour behind it change no
   *  channel by more than 1e-6, and the pieces of one cell are followed no farther either. */
  static constexpr float NextToNone = 1e-7f;

  /** Nothing hides anything. `isInOrder`: what comes later lies behind. */
  void Clear(const TileTask& task, const TileRectangle& tile, bool isInOrder);

  /** After fragments are laid over each other: finds the blocks that hide where about as many fragments
   *  as that costs were in vain, judged by the pixels of two of each queue. */
  void Watch(const TileFragments& fragments, const TileBuffer& buffer);

  /** Of the next queue: short as soon as any was in vain. */
  int QueueLength() const
  {
    return this->InVain > 0 || this->Hides ? TileFragments::Shortest : TileFragments::Longest;
  }
  bool HidesAny() const { return this->Hides; }
  /** Whether blocks hide all of a cell; `box`: its pixels in the tile, a TileBox. */
  bool HidesCell(
    const TileTask& task, const TileRectangle& tile, int cell, std::uint32_t& box) const;

private:
  static constexpr int Shift = 3;
  static constexpr int Size = 1 << Shift;
  static constexpr int InRow = 8;
  void FindBlocks(const TileBuffer& buffer);
  void FindBlock(const TileBuffer& buffer, int x, int y);
  bool HidesBox(
    const int (&first)[2], const int (&last)[2], float nearest, std::uint32_t& box) const;

  /** Of each block: u behind which nothing is seen; Open where all is. */
  std::array<float, InRow * (TileSize::MostRows >> Shift)> Depths{};
  /** The tile's last column and row. */
  std::array<int, 2> Last{};
  int InVain = 0;
  bool MayHide = false, Hides = false, IsInOrder = false;
};

#endif
