#include "OracleWarpedCell.h"

#include <algorithm>
#include <limits>

//------------------------------------------------------------------------------
OracleWarpedCell::OracleWarpedCell(const std::vector<OracleFace>& faces)
  : Faces(faces)
{
}

//------------------------------------------------------------------------------
OracleWarpedCell::Projected::Projected(const OracleRay& ray, const OracleVector& vector)
  : Right(ray.Right.Dot(vector))
  , Up(ray.Up.Dot(vector))
  , Along(ray.Direction.Dot(vector))
{
}

//------------------------------------------------------------------------------
double OracleWarpedCell::Projected::Cross(const Projected& other) const
{
  return this->Right * other.Up - this->Up * other.Right;
}

//------------------------------------------------------------------------------
bool OracleWarpedCell::Clip(const OracleRay& ray, OracleSegment& segment) const
{
  const double infinity = std::numeric_limits<double>::infinity();
  OracleSegment whole = { infinity, -infinity, 0.0, 0.0 };
  const Projected nudge(ray, OracleRay::GetNudge());
  for (const OracleFace& face : this->Faces)
  {
    for (const OracleFace::Triangle& triangle : face.GetTriangles())
    {
      double t, scalar;
      if (Intersect(ray, nudge, triangle, t, scalar))
      {
        whole.EntryScalar = t < whole.Entry ? scalar : whole.EntryScalar;
        whole.ExitScalar = t > whole.Exit ? scalar : whole.ExitScalar;
        whole.Entry = std::min(whole.Entry, t);
        whole.Exit = std::max(whole.Exit, t);
      }
    }
  }
  segment.Entry = std::max(whole.Entry, ray.Near);
  segment.Exit = std::min(whole.Exit, ray.Far);
  if (!(segment.Entry < segment.Exit))
  {
    return false;
  }
  segment.Interpolate(whole, whole.EntryScalar, whole.ExitScalar);
  return true;
}

//------------------------------------------------------------------------------
bool OracleWarpedCell::Intersect(const OracleRay& ray, const Projected& nudge,
  const OracleFace::Triangle& triangle, double& t, double& scalar)
{
  const Projected a(ray, triangle[0].Position - ray.Origin);
  const Projected b(ray, triangle[1].Position - ray.Origin);
  const Projected c(ray, triangle[2].Position - ray.Origin);
  // An edge runs from its smaller id in all of its triangles, so that they see the same area.
  const double ab = a.Cross(b), bc = b.Cross(c), ac = a.Cross(c);
  const int side = GetSide(ab, a, b, nudge);
  if (side == 0 || GetSide(bc, b, c, nudge) != side || GetSide(ac, a, c, nudge) != -side)
  {
    return false;
  }
  const double sum = ab + bc - ac;
  if (sum == 0.0)
  {
    return false;
  }
  t = (bc * a.Along - ac * b.Along + ab * c.Along) / sum;
  scalar = (bc * triangle[0].Scalar - ac * triangle[1].Scalar + ab * triangle[2].Scalar) / sum;
  // One scalar at all corners stays what it is to the last bit: it may lie on a step.
  const auto [least, greatest] =
    std::minmax({ triangle[0].Scalar, triangle[1].Scalar, triangle[2].Scalar });
  scalar = std::clamp(scalar, least, greatest);
  return true;
}

//------------------------------------------------------------------------------
int OracleWarpedCell::GetSide(
  double area, const Projected& p, const Projected& q, const Projected& nudge)
{
  // A ray through the edge passes on the side to which it is nudged.
  const double tie = nudge.Up * (q.Right - p.Right) - nudge.Right * (q.Up - p.Up);
  const double decisive = area != 0.0 ? area : tie;
  return (decisive > 0.0) - (decisive < 0.0);
}
