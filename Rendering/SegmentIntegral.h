#ifndef SegmentIntegral_h
#define SegmentIntegral_h

#include <array>
#include <vector>

class TransferFunction;

/**
 * @class SegmentIntegral
 * @brief Emission and absorption along segments on which the scalar is linear, in double.
 *
 * The scalars at both ends are normalised as the transfer function's. Split at the function's
 * nodes, exact alpha, Gauss quadrature in the colour: what cpIntegral.glsl does for a fragment.
 */
class SegmentIntegral
{
public:
  SegmentIntegral(const TransferFunction& function, double front, double back);

  /// Over the segment; the optical depth is this times its length.
  double GetMeanExtinction() const { return this->MeanExtinction; }

  /// The colour that a segment of this length has where it hides what is behind it: premultiplied
  /// colour over alpha.
  std::array<double, 3> FindColor(double length) const;

private:
  /// A part of the segment within one interval: red, green, blue, extinction at both ends.
  struct Piece
  {
    std::array<double, 4> Front;
    std::array<double, 4> Back;
    double Share;
  };
  struct Sum
  {
    std::array<double, 3> Color{ { 0.0, 0.0, 0.0 } };
    double Alpha = 0.0;
  };
  static void AddStep(const Piece& piece, double from, double to, double length, Sum& sum);
  std::array<double, 3> FindThinColor() const;

  std::vector<Piece> Pieces;
  double MeanExtinction = 0.0;
};

#endif
