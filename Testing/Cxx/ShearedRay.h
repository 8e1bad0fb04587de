#ifndef ShearedRay_h
#define ShearedRay_h

#include <array>
#include <cmath>

/// A line, and the shear that makes it the third axis.
struct ShearedRay
{
  using Point = std::array<double, 3>;

  double Origin[3];
  int Axes[3];
  double Shear[2];
  double Sign;

  ShearedRay(const double origin[3], const double direction[3])
  {
    int main = 0;
    for (int i = 0; i < 3; ++i)
    {
      this->Origin[i] = origin[i];
      main = std::abs(direction[i]) > std::abs(direction[main]) ? i : main;
    }
    this->Axes[0] = (main + 1) % 3;
    this->Axes[1] = (main + 2) % 3;
    this->Axes[2] = main;
    this->Shear[0] = direction[this->Axes[0]] / direction[main];
    this->Shear[1] = direction[this->Axes[1]] / direction[main];
    this->Sign = direction[main] < 0.0 ? -1.0 : 1.0;
  }

  Point Transform(const Point& p) const
  {
    const double depth = p[this->Axes[2]] - this->Origin[this->Axes[2]];
    return { { p[this->Axes[0]] - this->Origin[this->Axes[0]] - this->Shear[0] * depth,
      p[this->Axes[1]] - this->Origin[this->Axes[1]] - this->Shear[1] * depth,
      this->Sign * depth } };
  }

  /// Corners of a triangle by ascending ids, in the frame of a ray.
  static bool Hit(const Point& a, const Point& b, const Point& c, double& depth)
  {
    // Always from the smaller id to the larger: two triangles of an edge agree to the last bit.
    const double ab = a[0] * b[1] - a[1] * b[0];
    const double bc = b[0] * c[1] - b[1] * c[0];
    const double ac = a[0] * c[1] - a[1] * c[0];
    const bool sideA = bc >= 0.0, sideB = !(ac >= 0.0), sideC = ab >= 0.0;
    const double total = bc - ac + ab;
    if (sideA != sideB || sideB != sideC || total == 0.0)
    {
      return false;
    }
    depth = (bc * a[2] - ac * b[2] + ab * c[2]) / total;
    return true;
  }
};

#endif
