#ifndef TileSpanOracle_h
#define TileSpanOracle_h

#include <vector>

class TileExactCell;
struct TileGroup;

/// Which rays are in a tetrahedron, from where to where, by its planes one by one and in double.
class TileSpanOracle
{
public:
  /// A cell of a group that is set up in floats; x and y count from the corner of its box.
  TileSpanOracle(const TileGroup& group, int k);
  /// A cell in double; x and y are pixels of the viewport.
  explicit TileSpanOracle(const TileExactCell& cell);

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

private:
  struct Plane
  {
    double A, B, P;
    bool IsCut;

    double At(double x, double y) const { return this->A * x + this->B * y + this->P; }
    double TermsAt(double x, double y) const;
  };
  std::vector<Plane> Entries, Exits;
  double ScalarA, ScalarB, ScalarP, ScalarU;
};

#endif
