/**
 * Faces that are seen so nearly edge-on that the rounding of their corners may turn them.
 *
 * What such a face says of the order of its two cells is a matter of chance, and wrong only for rays through
 * the little that it covers: it matters where that may be a pixel. Most slivers of small cells meet none.
 */
#ifndef TileSliver_h
#define TileSliver_h

class TileMesh;
class TileVertices;
class TileView;

class TileSliver
{
public:
  /** The share of a corner's coordinates and of a face's extent that may turn it: more than floats lose. */
  static constexpr float AreaRounding = 6.0f / (1 << 24);

  /** Whether a face of the cell is a sliver that may cover a pixel of the viewport. All corners have a place on
   *  the screen. */
  static bool MeetsPixel(
    const TileMesh& mesh, const TileView& view, const TileVertices& vertices, int cell);
};

#endif
