#ifndef TileSpanOracle_h
#define TileSpanOracle_h

#include <vector>

class TileExactCell;
class TileView;
struct TileGroup;

/// Which rays are in a tetrahedron, from where to where, by its planes one by one and in double.
class TileSpanOracle
{
public:
  /// A cell of a group that is set up in floats; x and y count from the corner of its box.
  TileSpanOracle(const TileGroup& group, int k);
  /// A cell in double, between the near and the far plane; x and y are pixels of the viewport.
  TileSpanOracle(const TileExactCell& cell, const TileView& view);

  struct Ray
  {
    double Entry = 1e300, Exit = -1e300;
    /// How far inside the outline, in pixels.
    double Inside = 1e300;
    /// What rounding is a share of.
    double Terms = 0.0;
  };
  Ray Cross(double x, double y) const;

  /// scalar * weight, and what its rounding is a share of.
  struct Scalar
  {
    double Value, Terms;
  };
  Scalar ScalarAt(double x, double y, double u) const;

  /// Along a row, of a cell in double. Planes that are seen edge-on bound nothing, nor do two that are as good as level
  /// there: all of the row or nothing. Whether all of the outline bounds rows, but for the near plane and the far one.
  bool BoundsRows() const;
  /// By how many pixels of its row a pixel lies outside, beside what the rounding of planes is many times over.
  double FindOutside(double x, double y) const;

private:
  enum Kind
  {
    Face,
    EdgeOn,
    /// Where the function cuts a cell, and the near and the far plane.
    Cut,
    End
  };
  struct Plane
  {
    double A, B, P;
    Kind Is;

    double At(double x, double y) const { return this->A * x + this->B * y + this->P; }
    double TermsAt(double x, double y) const;
  };
  double RoundingOf(const Plane& in, const Plane& out) const;
  bool IsLevel(const Plane& in, const Plane& out) const;

  std::vector<Plane> Entries, Exits;
  double ScalarA, ScalarB, ScalarP, ScalarU;
  int Width = 0, Height = 0;
};

#endif
