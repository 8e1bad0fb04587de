/**
 * Emission, the product of colour and extinction, as the tiles read it.
 *
 * Between two nodes of the transfer function both factors are linear in the scalar: per piece and
 * colour the product is C0 + C1 x + C2 x x, x = scalar - Origin.
 */
#ifndef EmissionTable_h
#define EmissionTable_h

#include <cstddef>
#include <vector>

class TransferFunction;

class EmissionTable
{
public:
  void Build(const TransferFunction& function);

  int NumberOfPieces = 0;
  /** Steps of a binary search over all pieces. */
  int SearchSteps = 0;
  float GreatestEmission = 0.0f;
  /** The steepest change of the emission with the scalar; steps do not count. */
  float GreatestSlope = 0.0f;

  /** Piece i covers Bounds[i] to Bounds[i + 1]; beyond the last one there is 3e38. All arrays are
   *  padded, so that a whole vector can be read from their start. */
  std::vector<float> Bounds;
  std::vector<float> Origins;
  /** Red, green and blue. */
  std::vector<float> C0[3], C1[3], C2[3];

  /** No vector is longer. */
  static constexpr std::size_t Padding = 64;
};

#endif
