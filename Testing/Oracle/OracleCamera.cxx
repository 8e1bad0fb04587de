#include "OracleCamera.h"

//------------------------------------------------------------------------------
OracleCamera::OracleCamera(const std::array<double, 16>& clipToView,
  const std::array<double, 16>& viewToWorld, const OracleVector& center, int width, int height)
  : ClipToView(clipToView)
  , ViewToWorld(viewToWorld)
  , Center(center)
  , Width(width)
  , Height(height)
{
}

//------------------------------------------------------------------------------
void OracleCamera::AddClippingPlane(const OracleVector& point, const OracleVector& normal)
{
  this->Planes.push_back({ point - this->Center, normal });
}

//------------------------------------------------------------------------------
OracleVector OracleCamera::GetPoint(double x, double y, double z) const
{
  const std::array<double, 16>& c = this->ClipToView;
  const double w = c[12] * x + c[13] * y + c[14] * z + c[15];
  const OracleVector p = { (c[0] * x + c[1] * y + c[2] * z + c[3]) / w,
    (c[4] * x + c[5] * y + c[6] * z + c[7]) / w, (c[8] * x + c[9] * y + c[10] * z + c[11]) / w };
  // The eye is moved to the mesh's centre first: that difference keeps its digits at UTM sizes.
  const std::array<double, 16>& m = this->ViewToWorld;
  const OracleVector eye = OracleVector{ m[3], m[7], m[11] } - this->Center;
  return eye + OracleVector{ m[0] * p.X + m[1] * p.Y + m[2] * p.Z,
    m[4] * p.X + m[5] * p.Y + m[6] * p.Z, m[8] * p.X + m[9] * p.Y + m[10] * p.Z };
}

//------------------------------------------------------------------------------
OracleRay OracleCamera::GetRay(int column, int row, double windowDepth) const
{
  const double x = (2.0 * column + 1.0) / this->Width - 1.0;
  const double y = (2.0 * row + 1.0) / this->Height - 1.0;
  OracleRay ray(this->GetPoint(x, y, -1.0), this->GetPoint(x, y, 1.0));
  if (windowDepth < 1.0)
  {
    ray.EndAt(this->GetPoint(x, y, 2.0 * windowDepth - 1.0));
  }
  for (const Plane& plane : this->Planes)
  {
    ray.ClipByPlane(plane.Point, plane.Normal);
  }
  return ray;
}
