/**
 * A mesh's points on the screen in floats: x, y, u and the scalar.
 *
 * Points before or on the near plane, behind the far plane, or so far off the viewport that a float loses
 * the pixel's fractions have x = y = OffScreen; their cells are set up in double from the mesh
 * (class TileExactCell).
 */
#ifndef TileVertices_h
#define TileVertices_h

#include <vector>

class TileClusterBlocks;
class TileView;

class TileVertices
{
public:
  /** `points`: x, y, z, scalar. Those in `blocks` that are not seen are left as they are; null: all
   *  are seen. */
  void Transform(const std::vector<float>& points, const TileView& view,
    const TileClusterBlocks* blocks = nullptr);
  /** New scalars, the same view. */
  void CopyScalars(const std::vector<float>& points);

  static constexpr float OffScreen = 3e38f;
  /** Pixels; farther off a float's step is over 1e-3. */
  static constexpr double Farthest = 8192.0;

  std::vector<float> Values;
};

#endif
