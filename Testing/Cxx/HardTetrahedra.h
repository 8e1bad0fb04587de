#ifndef HardTetrahedra_h
#define HardTetrahedra_h

#include <random>
#include <vector>

/// Random tetrahedra about a tile of 64 x 64 pixels, of kinds that are hard to find the pixels of.
class HardTetrahedra
{
public:
  enum Kind
  {
    Any,
    /// Edges that lie in a row of pixels, in a column, in both or in all; corners on pixels.
    OnRows,
    OnColumns,
    OnPixels,
    /// Of a pixel, or a row or a column of them, or less.
    Pixel,
    Row,
    Column,
    /// Thinner than a pixel, in any direction.
    Slivers,
    /// All but flat: what is before and behind lies close together.
    Flat,
    /// Larger than the tile.
    Large,
    NumberOfKinds
  };
  static const char* GetName(int kind);

  HardTetrahedra(int kind, int count, unsigned int seed);

  /// Per corner x and y in pixels, u from -1 to 1 and a scalar that is all but linear in them.
  std::vector<float> Corners;

private:
  double Random(double least, double greatest);
  void AddCell(int kind);
  void Place(int kind, double (&corners)[4][3]);
  void Snap(int kind, double (&corners)[4][3]);

  std::mt19937 Generator;
};

#endif
