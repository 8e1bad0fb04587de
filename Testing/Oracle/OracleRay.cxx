#include "OracleRay.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
OracleRay::OracleRay(const OracleVector& start, const OracleVector& end)
{
  const OracleVector chord = end - start;
  const double length = chord.Length();
  this->Direction = chord * (1.0 / length);
  const double nearest = -start.Dot(this->Direction);
  this->Origin = start + this->Direction * nearest;
  this->Near = -nearest;
  this->Far = length - nearest;

  // The axis that is least along the ray gives the best-conditioned basis.
  const OracleVector& d = this->Direction;
  const double x = std::abs(d.X), y = std::abs(d.Y), z = std::abs(d.Z);
  const bool alongX = x <= y && x <= z, alongY = !alongX && y <= z;
  const OracleVector axis = { alongX ? 1.0 : 0.0, alongY ? 1.0 : 0.0,
    alongX || alongY ? 0.0 : 1.0 };
  this->Right = d.Cross(axis);
  this->Right = this->Right * (1.0 / this->Right.Length());
  this->Up = this->Right.Cross(d);
}

//------------------------------------------------------------------------------
void OracleRay::EndAt(const OracleVector& end)
{
  this->Far = std::min(this->Far, (end - this->Origin).Dot(this->Direction));
}

//------------------------------------------------------------------------------
void OracleRay::ClipByPlane(const OracleVector& point, const OracleVector& normal)
{
  const double height = (this->Origin - point).Dot(normal);
  const double slope = this->Direction.Dot(normal);
  if (slope > 0.0)
  {
    this->Near = std::max(this->Near, -height / slope);
  }
  else if (slope < 0.0)
  {
    this->Far = std::min(this->Far, -height / slope);
  }
  else if (height < 0.0)
  {
    this->Far = this->Near;
  }
}
