/**
 * Where in a row of pixels a tetrahedron that is set up in double can be covered: most of the box of a long
 * thin one lies outside of it.
 *
 * Bounds alone, a pixel and what rounding may do too wide; whether a pixel is covered the planes themselves say.
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

  /** Moves the first and the last pixel of a row to where the cell may be; first > last where it is not. */
  void Narrow(int y, int& first, int& last) const;

private:
  /** u = A x + B y + E, of an entry or an exit. */
  struct Line
  {
    double A, B, E;
  };
  /** x = Slope y + Offset. */
  struct Edge
  {
    double Slope, Offset;
    bool IsLeft;
  };

  void AddEdge(const Line& entry, const Line& exit, const TileView& view);

  std::array<Edge, 8> Edges;
  int Count = 0;
};

#endif
