/**
 * Where in a row of pixels a tetrahedron that is set up in double can be covered: most of the box of a long
 * thin one lies outside of it.
 *
 * Bounds are a 64th of a pixel and what rounding may do too wide; whether a pixel is covered the surfaces say, and the
 * planes seen edge-on.
 */
#ifndef TileExactRows_h
#define TileExactRows_h

#include "TileExactCell.h"

#include <array>

class TileView;

class TileExactRows
{
public:
  TileExactRows(const TileExactCell& cell, const TileView& view);

  /** u = A x + B y + E, of an entry or an exit. */
  struct Line
  {
    double A, B, E;
  };
  /** The near plane and the entries, or the far plane and the exits, without planes seen edge-on. */
  struct Surface
  {
    std::array<Line, 5> Lines;
    int Count = 1;
  };
  Surface Entries, Exits;
  bool HasEdgeOn = false;

  /** x = Slope y + Offset. */
  struct Edge
  {
    double Slope, Offset;
  };
  /** Those that bound rows on one side. */
  struct Side
  {
    std::array<Edge, 8> Edges;
    int Count = 0;
  };
  Side Left, Right;

private:
  /** Whether rounding leaves it its place. */
  bool AddEdge(const Line& entry, const Line& exit, const TileView& view);
};

#endif
