/**
 * The affine function h(x) = Gradient.x + Constant that stands for the sphere of a cell: the power
 * of a point with regard to the sphere is |x|^2 - h(x).
 */
#ifndef PowerLift_h
#define PowerLift_h

struct PowerLift
{
  double Gradient[3];
  double Constant;

  /** `point`: x, y, z, 1 for a point, 0 for a direction. */
  double Evaluate(const double point[4]) const
  {
    return this->Gradient[0] * point[0] + this->Gradient[1] * point[1] +
           this->Gradient[2] * point[2] + this->Constant * point[3];
  }
};

#endif
