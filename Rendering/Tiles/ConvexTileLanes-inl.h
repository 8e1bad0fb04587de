/**
 * What class ConvexTileExactCell finds for one ray, for the rays of a row of pixels at a time.
 *
 * Rays that see the face they cross edge-on, or that cross a face of more than two triangles beyond
 * its first two, are left to that class: see LanePassage::Odd.
 */
#if defined(ConvexTileLanes_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef ConvexTileLanes_inl_h
#undef ConvexTileLanes_inl_h
#else
#define ConvexTileLanes_inl_h
#endif

#include "ConvexTileEnds-inl.h"
#include "ConvexTileExactCell.h"
#include "ConvexTileRays.h"
#include "TileMath-inl.h"

#include <glm/vec3.hpp>
#include <hwy/highway.h>

#include <array>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// A point or a direction for every lane.
struct LanePoint
{
  LaneVector X, Y, Z;

  /// first + x * step
  static HWY_INLINE LanePoint Along(const glm::dvec3& first, const glm::dvec3& step, LaneVector x)
  {
    const LaneDouble d;
    return { hn::MulAdd(hn::Set(d, step.x), x, hn::Set(d, first.x)),
      hn::MulAdd(hn::Set(d, step.y), x, hn::Set(d, first.y)),
      hn::MulAdd(hn::Set(d, step.z), x, hn::Set(d, first.z)) };
  }
  HWY_INLINE LanePoint Moved(LaneVector by, const LanePoint& along) const
  {
    return { hn::MulAdd(by, along.X, this->X), hn::MulAdd(by, along.Y, this->Y),
      hn::MulAdd(by, along.Z, this->Z) };
  }
  /// From here to one of two points.
  HWY_INLINE LanePoint To(LaneMask second, const glm::dvec3& a, const glm::dvec3& b) const
  {
    const LaneDouble d;
    auto choose = [&](double one, double other)
    { return hn::IfThenElse(second, hn::Set(d, other), hn::Set(d, one)); };
    return { hn::Sub(choose(a.x, b.x), this->X), hn::Sub(choose(a.y, b.y), this->Y),
      hn::Sub(choose(a.z, b.z), this->Z) };
  }
};

HWY_INLINE LaneVector Dot(const LanePoint& a, const LanePoint& b)
{
  return hn::MulAdd(a.X, b.X, hn::MulAdd(a.Y, b.Y, hn::Mul(a.Z, b.Z)));
}

HWY_INLINE LaneVector Dot(const glm::dvec3& a, const LanePoint& b)
{
  const LaneDouble d;
  return hn::MulAdd(
    hn::Set(d, a.x), b.X, hn::MulAdd(hn::Set(d, a.y), b.Y, hn::Mul(hn::Set(d, a.z), b.Z)));
}

HWY_INLINE LanePoint Cross(const LanePoint& a, const LanePoint& b)
{
  return { hn::MulSub(a.Y, b.Z, hn::Mul(a.Z, b.Y)), hn::MulSub(a.Z, b.X, hn::Mul(a.X, b.Z)),
    hn::MulSub(a.X, b.Y, hn::Mul(a.Y, b.X)) };
}

/// Rays through one cell: depths from the plane through the mesh's centre, scalars at both ends.
class LanePassage
{
public:
  LaneMask Covered, Odd;
  LaneVector Entry, Exit, ScalarIn, ScalarOut;

  /// `x`: pixel columns of row `y`.
  LanePassage(
    const ConvexTileExactCell& cell, const ConvexTileRays& rays, LaneVector x, double y)
    : Cell(cell)
  {
    const LaneDouble d;
    const glm::dvec3 point = rays.Point[0] + y * rays.Point[2] - cell.Center;
    const LanePoint offset = LanePoint::Along(point, rays.Point[1], x);
    this->Direction =
      LanePoint::Along(rays.Direction[0] + y * rays.Direction[2], rays.Direction[1], x);
    this->Square = Dot(this->Direction, this->Direction);
    const auto depth = hn::Neg(hn::Div(Dot(offset, this->Direction), this->Square));
    this->Place = offset.Moved(depth, this->Direction);
    this->Parallel =
      hn::Mul(hn::Set(d, ConvexTileExactCell::Rounding), hn::Sqrt(this->Square));
    this->Odd = hn::FirstN(d, 0);
    this->CutAtPlanes();
    const auto begin = hn::Max(this->Depths[0], hn::Sub(hn::Set(d, rays.Near), depth));
    const auto end = hn::Min(this->Depths[1], hn::Sub(hn::Set(d, rays.Far), depth));
    const auto zero = hn::Zero(d);
    this->Covered = hn::And(hn::Lt(begin, end),
      hn::And(hn::Ge(this->Pieces[0], zero), hn::Ge(this->Pieces[1], zero)));
    this->Entry = hn::Add(depth, begin);
    this->Exit = hn::Add(depth, end);
    this->FindScalars(begin, end);
  }

private:
  static constexpr double FarAway = ConvexTileExactCell::FarAway;

  void CutAtPlanes()
  {
    const LaneDouble d;
    this->Depths[0] = hn::Set(d, -FarAway);
    this->Depths[1] = hn::Set(d, FarAway);
    this->Pieces[0] = this->Pieces[1] = hn::Set(d, -1.0);
    for (const ConvexTileExactCell::Plane& plane : this->Cell.Planes)
    {
      const Crossing at = this->CrossPlane(plane);
      this->Move(0, hn::And(at.Enters, hn::Lt(this->Depths[0], at.Depth)), at.Depth, plane.Piece);
      this->Move(1, hn::And(at.Leaves, hn::Lt(at.Depth, this->Depths[1])), at.Depth, plane.Piece);
      this->Depths[1] = hn::IfThenElse(at.Misses, hn::Set(d, -FarAway), this->Depths[1]);
    }
    const std::vector<ConvexTileExactCell::Plane>& valleys = this->Cell.Valleys;
    // Twice: an end that a later face moves may come to lie in the gap of an earlier one.
    for (std::size_t i = 0; i < 2 * valleys.size(); i += 2)
    {
      this->CutAtValley(&valleys[i % valleys.size()]);
    }
  }

  /// Where the rays cross a plane, and to which side.
  struct Crossing
  {
    LaneMask Enters, Leaves;
    /// Along the plane, outside.
    LaneMask Misses;
    LaneVector Depth;
  };
  HWY_INLINE Crossing CrossPlane(const ConvexTileExactCell::Plane& plane) const
  {
    const LaneDouble d;
    const auto slope = Dot(plane.Normal, this->Direction);
    const auto height = hn::Add(Dot(plane.Normal, this->Place), hn::Set(d, plane.Offset));
    const auto along = hn::Le(hn::Abs(slope), this->Parallel);
    const auto isClear = hn::Gt(hn::Abs(height), hn::Set(d, ConvexTileExactCell::Rounding));
    const auto side = hn::IfThenElse(isClear, height, hn::Set(d, plane.Nudge));
    const auto zero = hn::Zero(d);
    return { hn::AndNot(along, hn::Gt(slope, zero)), hn::AndNot(along, hn::Lt(slope, zero)),
      hn::And(along, hn::Lt(side, zero)), hn::Neg(hn::Div(height, slope)) };
  }

  HWY_INLINE void Move(int end, LaneMask which, LaneVector depth, int piece)
  {
    const LaneDouble d;
    this->Depths[end] = hn::IfThenElse(which, depth, this->Depths[end]);
    this->Pieces[end] = hn::IfThenElse(which, hn::Set(d, piece), this->Pieces[end]);
  }

  /// As ConvexTileExactCell::CutAtValley.
  HWY_INLINE void CutAtValley(const ConvexTileExactCell::Plane* planes)
  {
    const LaneDouble d;
    const Crossing a = this->CrossPlane(planes[0]), b = this->CrossPlane(planes[1]);
    const auto none = hn::Set(d, FarAway);
    const auto enterA = hn::IfThenElse(a.Enters, a.Depth, hn::Neg(none));
    const auto enterB = hn::IfThenElse(b.Enters, b.Depth, hn::Neg(none));
    auto leaveOf = [&](const Crossing& at)
    {
      return hn::IfThenElse(
        at.Misses, hn::Neg(none), hn::IfThenElse(at.Leaves, at.Depth, none));
    };
    const auto leaveA = leaveOf(a), leaveB = leaveOf(b);
    const auto bothEnter = hn::And(a.Enters, b.Enters), anyEnters = hn::Or(a.Enters, b.Enters);
    const auto enter =
      hn::IfThenElse(bothEnter, hn::Min(enterA, enterB), hn::Max(enterA, enterB));
    const auto leave = hn::IfThenElse(anyEnters, hn::Min(leaveA, leaveB), hn::Max(leaveA, leaveB));
    // A ray may leave the cell and enter it again: it reaches from the first to the last point.
    const auto alike = hn::Or(bothEnter, hn::Not(anyEnters));
    const auto later = hn::And(
      hn::Lt(this->Depths[0], enter), hn::Or(alike, hn::Lt(leave, this->Depths[0])));
    this->Move(0, later, enter, planes[0].Piece);
    const auto sooner = hn::And(
      hn::Lt(leave, this->Depths[1]), hn::Or(alike, hn::Lt(this->Depths[1], enter)));
    this->Move(1, sooner, leave, planes[0].Piece);
  }

  void FindScalars(LaneVector begin, LaneVector end)
  {
    const LaneDouble d;
    this->ScalarIn = this->ScalarOut = hn::Set(d, this->Cell.CellScalar);
    if (this->Cell.HasCellScalar || hn::AllFalse(d, this->Covered))
    {
      return;
    }
    LaneVector* const scalars[2] = { &this->ScalarIn, &this->ScalarOut };
    for (int i = 0; i < 2; ++i)
    {
      auto open = this->Covered;
      for (std::size_t piece = 0; !hn::AllFalse(d, open); ++piece)
      {
        const auto here = hn::And(open, hn::Eq(this->Pieces[i], hn::Set(d, double(piece))));
        if (!hn::AllFalse(d, here))
        {
          const auto value = this->ScalarOnFace(this->Cell.Pieces[piece], i, here);
          *scalars[i] = hn::IfThenElse(here, value, *scalars[i]);
          open = hn::AndNot(here, open);
        }
      }
    }
    const auto change = hn::Div(
      hn::Sub(this->ScalarOut, this->ScalarIn), hn::Sub(this->Depths[1], this->Depths[0]));
    this->ScalarIn = hn::MulAdd(hn::Sub(begin, this->Depths[0]), change, this->ScalarIn);
    this->ScalarOut = hn::NegMulAdd(hn::Sub(this->Depths[1], end), change, this->ScalarOut);
  }

  /// As ConvexTileExactCell::FindScalar, of lanes that cross a face at the end.
  LaneVector ScalarOnFace(const ConvexTileExactCell::Piece& piece, int end, LaneMask which)
  {
    const LaneDouble d;
    const auto zero = hn::Zero(d);
    const LanePoint place = this->Place.Moved(this->Depths[end], this->Direction);
    const glm::dvec3 first = piece.First - this->Cell.Center;
    const auto at = place.To(hn::FirstN(d, 0), first, first);
    const auto u = hn::Neg(Dot(piece.GradientU, at)), w = hn::Neg(Dot(piece.GradientW, at));
    if (piece.GoesOn)
    {
      const auto next = hn::And(hn::Lt(zero, w), hn::Lt(u, hn::Mul(hn::Set(d, piece.U3), w)));
      this->Odd = hn::Or(this->Odd, hn::And(which, next));
    }
    const auto beyond = piece.HasTwo ? hn::Lt(zero, w) : hn::FirstN(d, 0);
    const std::array<glm::dvec3, 4>& corners = piece.Corners;
    const glm::dvec3& center = this->Cell.Center;
    const LanePoint a = at;
    const LanePoint b = place.To(beyond, corners[1] - center, corners[2] - center);
    const LanePoint c = place.To(beyond, corners[2] - center, corners[3] - center);
    auto scalarOf = [&](int one, int other)
    {
      return hn::IfThenElse(
        beyond, hn::Set(d, piece.Scalars[other]), hn::Set(d, piece.Scalars[one]));
    };
    LaneVector weights[3] = { Dot(this->Direction, Cross(b, c)), Dot(this->Direction, Cross(c, a)),
      Dot(this->Direction, Cross(a, b)) };
    const auto whole = hn::Add(hn::Add(weights[0], weights[1]), weights[2]);
    const auto isTurned = hn::Le(whole, zero);
    for (LaneVector& weight : weights)
    {
      weight = hn::Max(hn::IfThenElse(isTurned, hn::Neg(weight), weight), zero);
    }
    const auto sum = hn::Add(hn::Add(weights[0], weights[1]), weights[2]);
    const auto extent = hn::Max(Dot(a, a), hn::Max(Dot(b, b), Dot(c, c)));
    const auto least = hn::Mul(this->Parallel, extent);
    this->Odd = hn::Or(this->Odd, hn::And(which, hn::Le(hn::Abs(whole), least)));
    const auto scalar = hn::MulAdd(weights[0], hn::Set(d, piece.Scalars[0]),
      hn::MulAdd(weights[1], scalarOf(1, 2), hn::Mul(weights[2], scalarOf(2, 3))));
    return hn::Div(scalar, sum);
  }

  const ConvexTileExactCell& Cell;
  LanePoint Place, Direction;
  LaneVector Square, Parallel;
  /// Beside the point next to the cell's centre, and the first pieces of both ends' faces.
  LaneVector Depths[2], Pieces[2];
};
}
}
HWY_AFTER_NAMESPACE();

#endif
