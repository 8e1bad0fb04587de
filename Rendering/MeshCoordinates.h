#ifndef MeshCoordinates_h
#define MeshCoordinates_h

#include <array>
#include <vector>

class vtkUnstructuredGrid;

/**
 * @class MeshCoordinates
 * @brief A mesh's points about its centre, in units of its size, as floats.
 *
 * Data = Center + Scale * mesh coordinates; Scale is a power of two, so that it costs no digit.
 */
class MeshCoordinates
{
public:
  /// Centre and size are those of the points that cells use.
  void Build(vtkUnstructuredGrid* mesh);
  /// The same cells with other points. Points that are not finite do not count either.
  void Move(vtkUnstructuredGrid* mesh);

  std::array<double, 3> Center{ { 0.0, 0.0, 0.0 } };
  double Scale = 1.0;
  /// Of the box of all used points about the centre, in mesh coordinates.
  std::array<double, 3> HalfLengths{ { 0.0, 0.0, 0.0 } };
  /// x, y, z and an unused fourth per point.
  std::vector<float> Points;

private:
  void SetExtent(const double bounds[6]);
  template <class Array>
  void TakePoints(Array* array);

  std::vector<unsigned char> UsedPoints;
};

#endif
