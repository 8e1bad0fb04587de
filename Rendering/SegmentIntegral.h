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

  /// What reaches the eye of a segment, over its opacity: means over the segment, weighted by the
  /// absorption that is not hidden.
  struct Means
  {
    std::array<double, 3> Color{ { 0.0, 0.0, 0.0 } };
    /// Of the colour times the share of the segment that is still ahead: 1 at the front.
    std::array<double, 3> Front{ { 0.0, 0.0, 0.0 } };
    /// Of that share, and of its square.
    double Ahead = 0.0;
    double AheadSquared = 0.0;
  };
  Means FindMeans(double length) const;

private:
  /// A part of the segment within one interval: red, green, blue, extinction at both ends; where it
  /// begins and how much of the segment it is.
  struct Piece
  {
    std::array<double, 4> Front;
    std::array<double, 4> Back;
    double Begin;
    double Share;
  };
  struct Sum : Means
  {
    double Alpha = 0.0;

    /// A colour at a share of the segment, with its weight.
    void Add(const std::array<double, 4>& value, double share, double weight);
    void Divide(double total);
  };
  static void AddStep(const Piece& piece, double from, double to, double length, Sum& sum);
  Sum FindThin() const;

  std::vector<Piece> Pieces;
  double MeanExtinction = 0.0;
};

#endif
