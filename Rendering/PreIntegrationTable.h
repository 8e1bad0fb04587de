#ifndef PreIntegrationTable_h
#define PreIntegrationTable_h

#include <vector>

class TransferFunction;

/**
 * @class PreIntegrationTable
 * @brief Emission and absorption of segments by front scalar, back scalar and length.
 *
 * Paper: Roettger, Guthe, Schieber and Ertl, "Convexification of unstructured grids", 2004,
 * section 8. Lengths l enter as 1 - 2^-l, so that one table holds for all of them; its unit is the
 * length over which the greatest extinction makes an optical depth of 1. Stored are the mean
 * extinction, from which the opacity is rebuilt exactly, and the colour over that opacity.
 *
 * A lit table has the paper's twelve entries: ambient colour and extinction; diffuse colour by the
 * light at the front, and the weight w of the front's gradient in that of the highlight; diffuse
 * colour by the light at the back, and in place of the highlight's strength, which over the opacity
 * is 1 where one specular coefficient holds for all scalars, the spread of w: light is taken at
 * w - spread and w + spread. (The paper's text has the front at t = 1 and the weight of
 * the first integral missing: here the front's weight is 1 - t.)
 *
 * Texels: Size x Size x Size / 4 x 4 floats, front scalar fastest: red, green, blue, extinction.
 * Front and back scalar i stand for Low + i (High - Low) / (Size - 1), length k for
 * 1 - 2^-l = k / (Size / 4). Read with linear interpolation. Where the transfer function bends the
 * error is of first order in 1 / Size.
 */
class PreIntegrationTable
{
public:
  /// `range`: the normalised scalars that occur. Uses all threads. False, and no texels, where
  /// memory does not hold them.
  bool Build(const TransferFunction& function, const float range[2], int size, bool isLit);

  bool IsLit() const { return this->Lit; }

  /// The longest segment that the table holds, in units of its length.
  double GetGreatestLength() const;

  std::vector<float> Texels;
  /// Of a lit table: red, green, blue, w and red, green, blue, spread; else empty.
  std::vector<float> Front;
  std::vector<float> Back;
  int Size = 0;
  float Range[2] = { 0.0f, 1.0f };
  float GreatestExtinction = 0.0f;

private:
  bool Allocate();
  void FillRow(const TransferFunction& function, int back);

  bool Lit = false;
};

#endif
