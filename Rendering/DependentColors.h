#ifndef DependentColors_h
#define DependentColors_h

#include "TransferFunction.h"
#include "vtkTimeStamp.h"

#include <vector>

struct PreparedVolume;
class VolumePropertyReader;

/**
 * @class DependentColors
 * @brief The colour of scalars whose components belong together: the last is the opacity's.
 *
 * Of two components the first is the scalar of the colour function, of four the first three are
 * red, green and blue: of 0 to 255 in an array of unsigned char, as they are in any other.
 */
class DependentColors
{
public:
  enum Kinds
  {
    None,
    Scalar,
    Direct
  };

  /// Reads them again where scalars or functions changed.
  void Prepare(const PreparedVolume& prepared, VolumePropertyReader& reader);

  Kinds Kind = None;
  bool OnePerCell = false;
  /// 4 per point or cell: colour, or the colour function's normalised scalar, in the first.
  std::vector<float> Values;
  /// Its colour is that of the normalised scalar.
  TransferFunction Function;
  vtkTimeStamp Time;

private:
  void ReadScalar(const PreparedVolume& prepared, VolumePropertyReader& reader);
  void ReadColors(const PreparedVolume& prepared);
};

#endif
