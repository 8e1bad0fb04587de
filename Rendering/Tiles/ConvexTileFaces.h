/**
 * The faces of convex cells on the screen, in floats, once per frame: both cells of a face read the
 * same numbers.
 *
 * A face is a triangle, or two that meet at the diagonal from its first point. u and scalar * weight
 * are linear in x and y on each (class TileView), so that over the whole face
 *
 *     u = U + UA dx + UB dy + CU max(g, 0)        dx, dy: pixels from the first point
 *     s = S + SA dx + SB dy + CS max(g, 0)        g = GX dx + GY dy, 0 on the diagonal
 */
#ifndef ConvexTileFaces_h
#define ConvexTileFaces_h

#include <vector>

class ConvexTileMesh;
class TileClusterBlocks;
class TileVertices;
class TileView;

template <class Number>
struct alignas(64) ConvexTileFaceOf
{
  Number X, Y, U, UA;
  Number UB, S, SA, SB;
  Number GX, GY, CU, CS;
  /** 1 where the points of its larger triangle run counterclockwise, -1 clockwise, 0 where such numbers
   *  do not serve. */
  Number Side;
  /** Not 0: the other triangle runs the other way round; it is u + CU g all over. The diagonal ends at
   *  X + IsMixed GY, Y - IsMixed GX. */
  Number IsMixed;
  Number Unused[2];
};

/// One line of a cache.
using ConvexTileFace = ConvexTileFaceOf<float>;

class ConvexTileFaces
{
public:
  /** How far floats are to be trusted. */
  struct Bounds
  {
    /** Depths of the mesh that the scalar's effect is multiplied by, at most: the optical depth of
     *  its extent where emission is summed up. */
    double Density = 1.0;
    /** What is let pass in a normalised scalar. */
    double ScalarError = 1e-5;
    /** Change of u per pixel beyond which its rounding shows, as a share of the mesh's extent. */
    double Steep = 1.0;

    bool operator==(const Bounds& other) const
    {
      return this->Density == other.Density && this->ScalarError == other.ScalarError &&
             this->Steep == other.Steep;
    }
  };

  /** Those in `blocks` that are not seen are left as they are. */
  void Project(const ConvexTileMesh& mesh, const TileView& view, const TileVertices& vertices,
    const TileClusterBlocks& blocks, const Bounds& bounds);

  /** One per face. */
  std::vector<ConvexTileFace> Values;
  /** Not 0: floats do not serve. */
  std::vector<unsigned char> InDoubt;
};

#endif
