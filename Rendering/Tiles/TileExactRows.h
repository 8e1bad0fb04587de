/**
 * Where in a row of pixels a tetrahedron that is set up in double can be covered: most of the box of a long
 * thin one lies outside of it.
 *
 * Bounds alone, a 64th of a pixel and what rounding may do too wide; whether a pixel is covered the planes themselves say.
 */
#ifndef TileExactRows_h
#define TileExactRows_h

#include "TileExactCell.h"

#include <algorithm>
#include <array>

class TileView;

class TileExactRows
{
public:
  TileExactRows(const TileExactCell& cell, const TileView& view);

  /** Moves the first and the last pixel of a row to where the cell may be; first > last where it is not. */
  void Narrow(int y, int& first, int& last) const
  {
    double begin = first, end = last;
    for (int i = 0; i < this->Left.Count; ++i)
    {
      begin = std::max(begin, this->Left.Edges[i].At(y));
    }
    for (int i = 0; i < this->Right.Count; ++i)
    {
      end = std::min(end, this->Right.Edges[i].At(y));
    }
    // Back to whole pixels of the row.
    first = WholeFrom(std::min(begin, last + 1.0));
    last = -WholeFrom(-std::max(end, first - 1.0));
  }

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

    double At(double y) const { return this->Slope * y + this->Offset; }
  };
  /** Those that bound rows on one side. */
  struct Side
  {
    std::array<Edge, 8> Edges;
    int Count = 0;
  };

  /** The first whole number that is not less: std::ceil is a call where the machine may be an old one. */
  static int WholeFrom(double value)
  {
    const int near = static_cast<int>(value);
    return near + (near < value ? 1 : 0);
  }

  void AddEdge(const Line& entry, const Line& exit, const TileView& view);

  Side Left, Right;
};

#endif
