/**
 * Where opaque geometry and clipping planes cut the rays, per pixel, as u.
 */
#ifndef TileLimits_h
#define TileLimits_h

#include <glm/vec4.hpp>

#include <vector>

class TileView;

class TileLimits
{
public:
  /** `opaqueDepth`: window depths of every pixel, 1 where nothing is; null for none. `planes`: view
   *  coordinates, normal and offset; the positive side stays. False where nothing cuts. */
  bool Build(const TileView& view, const float* opaqueDepth, const std::vector<glm::vec4>& planes);

  /** Whether opaque geometry hides anything. */
  bool HasOpaque() const { return !this->TileFar.empty(); }
  /** Whether a box of pixels from `first` to `last`, whose nearest u that is, may be seen before the
   *  opaque depth. Where HasOpaque. */
  bool IsBeforeAny(const double (&first)[2], const double (&last)[2], double nearest) const;

  /** Finds what CutsOff reads, once a frame, after Build. */
  void FindBlocks(const TileView& view);
  /** Whether nothing of a cell is left in a box of pixels, first and last included: whether in every
   *  block of pixels there the cell, whose u lies from `farthest` to `nearest`, is behind the opaque
   *  depth or cut away. Errs on the side of no. */
  bool CutsOff(
    const int (&first)[2], const int (&last)[2], float farthest, float nearest) const;

  /** Rays count between Far and Near, row by row of the viewport. */
  std::vector<float> Near, Far;

private:
  void SetRow(const TileView& view, const float* opaqueDepth, int y);
  void FindTileFar(const TileView& view);
  void FindBlockRow(const TileView& view, int y);

  std::vector<glm::dvec4> Planes;
  /** The farthest Far of each tile's pixels; empty where nothing opaque is there. */
  std::vector<float> TileFar;
  int Tiles[2] = { 0, 0 };
  /** Blocks of pixels: where the last of its rays begins to count and the first one ends. */
  static constexpr int BlockShift = 3;
  struct Block
  {
    float Near, Far;
  };
  std::vector<Block> Blocks;
  int BlocksInRow = 0;
  /** What is added to a u for its rounding. */
  float Rounding = 0.0f;
};

#endif
