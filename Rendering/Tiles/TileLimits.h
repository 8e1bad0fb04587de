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

  /** Rays count between Far and Near, row by row of the viewport. */
  std::vector<float> Near, Far;

private:
  void SetRow(const TileView& view, const float* opaqueDepth, int y);

  std::vector<glm::dvec4> Planes;
};

#endif
