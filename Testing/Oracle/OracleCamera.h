/**
 * The rays of an image, one through every pixel centre (column + 1/2, row + 1/2), row 0 at the
 * bottom.
 *
 * Rays run from the near to the far plane, in world lengths and in coordinates relative to the
 * mesh's centre. Clipping planes shorten all of them, a window depth shortens one.
 */

#ifndef OracleCamera_h
#define OracleCamera_h

#include "OracleRay.h"

#include <array>
#include <vector>

class OracleCamera
{
public:
  /**
   * `clipToView` and `viewToWorld` are the inverses of the projection and view matrices, 16 values
   * row by row; clip space is [-1, 1] in all three directions. `center` is the mesh's centre.
   */
  OracleCamera(const std::array<double, 16>& clipToView, const std::array<double, 16>& viewToWorld,
    const OracleVector& center, int width, int height);

  /** Keeps the side of the plane to which `normal` points; `point` is in world coordinates. */
  void AddClippingPlane(const OracleVector& point, const OracleVector& normal);

  const OracleVector& GetCenter() const { return this->Center; }

  /** The ray of one pixel up to the window depth in [0, 1], where 1 is the far plane. */
  OracleRay GetRay(int column, int row, double windowDepth) const;

private:
  struct Plane
  {
    OracleVector Point;
    OracleVector Normal;
  };

  OracleVector GetPoint(double x, double y, double z) const;

  std::array<double, 16> ClipToView;
  std::array<double, 16> ViewToWorld;
  OracleVector Center;
  int Width;
  int Height;
  std::vector<Plane> Planes;
};

#endif
