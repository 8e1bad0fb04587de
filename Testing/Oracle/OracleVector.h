/**
 * Three doubles with the few operations that the oracle's geometry needs.
 */

#ifndef OracleVector_h
#define OracleVector_h

#include <cmath>

struct OracleVector
{
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;

  OracleVector operator+(const OracleVector& other) const
  {
    return { this->X + other.X, this->Y + other.Y, this->Z + other.Z };
  }
  OracleVector operator-(const OracleVector& other) const
  {
    return { this->X - other.X, this->Y - other.Y, this->Z - other.Z };
  }
  OracleVector operator*(double factor) const
  {
    return { this->X * factor, this->Y * factor, this->Z * factor };
  }
  double Dot(const OracleVector& other) const
  {
    return this->X * other.X + this->Y * other.Y + this->Z * other.Z;
  }
  OracleVector Cross(const OracleVector& other) const
  {
    return { this->Y * other.Z - this->Z * other.Y, this->Z * other.X - this->X * other.Z,
      this->X * other.Y - this->Y * other.X };
  }
  double Length() const { return std::sqrt(this->Dot(*this)); }
  bool IsFinite() const
  {
    return std::isfinite(this->X) && std::isfinite(this->Y) && std::isfinite(this->Z);
  }
};

#endif
