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

  /** Rays count between Far and Near, row by row of the viewport. */
  std::vector<float> Near, Far;

private:
  void SetRow(const TileView& view, const float* opaqueDepth, int y);
  void FindTileFar(const TileView& view);

  std::vector<glm::dvec4> Planes;
  /** The farthest Far of each tile's pixels; empty where nothing opaque is there. */
  std::vector<float> TileFar;
  int Tiles[2] = { 0, 0 };
};

#endif
