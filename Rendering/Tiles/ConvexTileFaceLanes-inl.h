/**
 * Faces of convex cells on the screen from their corners, a vector of faces at a time: in floats those of
 * the whole mesh, in double those of single cells.
 */
#if defined(ConvexTileFaceLanes_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef ConvexTileFaceLanes_inl_h
#undef ConvexTileFaceLanes_inl_h
#else
#define ConvexTileFaceLanes_inl_h
#endif

#include "ConvexTileFaces.h"
#include "TileView.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// The bounds in units of the screen, and how numbers of a kind are rounded.
template <class Number>
struct FaceLimits
{
  Number Steep, SteepStep, Rounding, AreaRounding, Scalar, Pixel, WeightScale, WeightOffset;

  /// Half a step of a coordinate of the screen, and of products of two, in their own units.
  static constexpr double HalfStep = 0.25 * std::numeric_limits<Number>::epsilon();
  static constexpr double FloatHalfStep = 0.25 * std::numeric_limits<float>::epsilon();
  static constexpr double ProductRounding = 6.7 * HalfStep;
  /// What is let pass in a pixel's sum where a face's place is off by a rounding.
  static constexpr double StepError = 2e-5;
  static constexpr double AreaError = 2e-4;

  FaceLimits(const TileView& view, const ConvexTileFaces::Bounds& bounds)
  {
    const double pixel = HalfStep * std::max({ view.Width, view.Height, 64 });
    const double steep = bounds.Steep * (FloatHalfStep / HalfStep);
    this->Pixel = static_cast<Number>(pixel);
    this->Steep = static_cast<Number>(steep * view.Extent);
    this->SteepStep = static_cast<Number>(
      view.Extent * std::min(StepError / (pixel * bounds.Density), steep));
    this->Rounding = static_cast<Number>(view.Extent * std::min(AreaError / bounds.Density, 1.0));
    this->AreaRounding = static_cast<Number>(ProductRounding);
    this->Scalar = static_cast<Number>(bounds.ScalarError);
    this->WeightScale = static_cast<Number>(view.WeightScale);
    this->WeightOffset = static_cast<Number>(view.WeightOffset);
  }
};

/// One vector of faces: corners as x, y, u and scalar * weight; 1 to 3 from corner 0.
template <class D>
struct FaceLanes
{
  using Vector = hn::Vec<D>;
  Vector First[4], Edge[4][4];
  Vector LeastWeight, Areas[2], Terms;
  hn::Mask<D> HasTwo, UsesSecond;

  /// `corners`: fills x, y, u and the scalar of one of the four.
  template <class Corners>
  FaceLanes(const Corners& corners, hn::Mask<D> hasTwo, const FaceLimits<hn::TFromD<D>>& limits)
    : HasTwo(hasTwo)
  {
    const D d;
    const auto scale = hn::Set(d, limits.WeightScale), offset = hn::Set(d, limits.WeightOffset);
    for (int i = 0; i < 4; ++i)
    {
      corners(i, this->Edge[i]);
      const auto weight = hn::MulAdd(scale, this->Edge[i][2], offset);
      this->LeastWeight = i == 0 ? weight : hn::Min(this->LeastWeight, weight);
      this->Edge[i][3] = hn::Mul(this->Edge[i][3], weight);
    }
    for (int k = 0; k < 4; ++k)
    {
      this->First[k] = this->Edge[0][k];
      for (int i = 1; i < 4; ++i)
      {
        this->Edge[i][k] = hn::Sub(this->Edge[i][k], this->First[k]);
      }
    }
    this->FindAreas();
  }

  static Vector Area(const Vector (&a)[4], const Vector (&b)[4])
  {
    return hn::MulSub(a[0], b[1], hn::Mul(a[1], b[0]));
  }

  void FindAreas()
  {
    const D d;
    const auto& e = this->Edge;
    this->Areas[0] = Area(e[1], e[2]);
    this->Areas[1] = hn::IfThenElseZero(this->HasTwo, Area(e[2], e[3]));
    this->UsesSecond = hn::Gt(hn::Abs(this->Areas[1]), hn::Abs(this->Areas[0]));
    const auto reach = [&](int i) { return hn::Max(hn::Abs(e[i][0]), hn::Abs(e[i][1])); };
    this->Terms = hn::Mul(reach(2), hn::Max(reach(1), reach(3)));
    this->Terms = hn::Max(this->Terms, hn::Set(d, hn::TFromD<D>(1e-30)));
  }

  Vector Pick(int first, int second, int k) const
  {
    return hn::IfThenElse(this->UsesSecond, this->Edge[second][k], this->Edge[first][k]);
  }
  Vector BaseArea() const
  {
    return hn::IfThenElse(this->UsesSecond, this->Areas[1], this->Areas[0]);
  }
  Vector OtherArea() const
  {
    return hn::IfThenElse(this->UsesSecond, this->Areas[0], this->Areas[1]);
  }
  /// The range of a value over the corners, at most twice.
  Vector Range(int k) const
  {
    return hn::Max(
      hn::Abs(this->Edge[1][k]), hn::Max(hn::Abs(this->Edge[2][k]), hn::Abs(this->Edge[3][k])));
  }
};

/// A function over both triangles: A dx + B dy + Fold max(g, 0).
template <class D>
struct FaceFunction
{
  using Vector = hn::Vec<D>;
  Vector A, B, Fold;
  /// Its steepest change per pixel on either triangle.
  Vector Slope;

  FaceFunction(const FaceLanes<D>& f, int k, Vector gx, Vector gy)
  {
    const D d;
    // Base triangle: corners 0, 1, 2 or 0, 2, 3.
    const Vector p[3] = { f.Pick(1, 2, 0), f.Pick(1, 2, 1), f.Pick(1, 2, k) };
    const Vector q[3] = { f.Pick(2, 3, 0), f.Pick(2, 3, 1), f.Pick(2, 3, k) };
    const auto inverse = hn::Div(hn::Set(d, hn::TFromD<D>(1)), f.BaseArea());
    this->A = hn::Mul(hn::MulSub(p[2], q[1], hn::Mul(q[2], p[1])), inverse);
    this->B = hn::Mul(hn::MulSub(q[2], p[0], hn::Mul(p[2], q[0])), inverse);
    const auto beyond = hn::NegMulAdd(
      this->A, f.Pick(3, 1, 0), hn::NegMulAdd(this->B, f.Pick(3, 1, 1), f.Pick(3, 1, k)));
    this->Fold = hn::IfThenElseZero(f.HasTwo, hn::Div(beyond, hn::Abs(f.OtherArea())));
    const auto here = hn::Add(hn::Abs(this->A), hn::Abs(this->B));
    const auto there = hn::Add(hn::Abs(hn::MulAdd(this->Fold, gx, this->A)),
      hn::Abs(hn::MulAdd(this->Fold, gy, this->B)));
    this->Slope = hn::Max(here, there);
  }
};

/// Where floats serve: comparisons fail for what is not a number.
template <class D>
hn::Mask<D> IsTrusted(const FaceLanes<D>& f, const FaceFunction<D>& u, const FaceFunction<D>& s,
  hn::Mask<D> isStep, hn::Mask<D> isWarped, const FaceLimits<hn::TFromD<D>>& limits)
{
  const D d;
  const auto square = hn::Mul(f.LeastWeight, f.LeastWeight);
  const auto steep =
    hn::IfThenElse(isStep, hn::Set(d, limits.SteepStep), hn::Set(d, limits.Steep));
  const auto scalarError = hn::Mul(hn::Set(d, limits.Scalar), f.LeastWeight);
  auto good = hn::Le(u.Slope, hn::Mul(steep, square));
  good = hn::And(good, hn::Le(hn::Mul(s.Slope, hn::Set(d, limits.Pixel)), scalarError));
  const auto least = hn::IfThenElse(f.HasTwo,
    hn::Min(hn::Abs(f.Areas[0]), hn::Abs(f.Areas[1])), hn::Abs(f.Areas[0]));
  const auto rounded = hn::Mul(f.Terms, hn::Set(d, limits.AreaRounding));
  const auto depthError = hn::Mul(hn::Set(d, limits.Rounding), square);
  good = hn::And(good, hn::Le(hn::Mul(rounded, f.Range(2)), hn::Mul(depthError, least)));
  good = hn::And(good, hn::Le(hn::Mul(rounded, f.Range(3)), hn::Mul(scalarError, least)));
  // The sign of both areas is beyond doubt, and the same but for warped faces.
  const auto doubt = hn::MulAdd(hn::Set(d, 8 * limits.Pixel),
    hn::Add(f.Range(0), f.Range(1)), rounded);
  good = hn::And(good, hn::Lt(doubt, least));
  const auto agree = hn::Ge(hn::Mul(f.Areas[0], f.Areas[1]), hn::Zero(d));
  return hn::And(good, hn::Or(agree, isWarped));
}

/// Beside their corners.
template <class D>
struct FaceKinds
{
  hn::Mask<D> HasTwo, IsWarped, IsStep;
};

/// The numbers of one face, of what ProjectFaceLanes stores.
template <class Number, std::size_t Count>
void CopyFace(const Number (&stored)[4][Count][4], int k, ConvexTileFaceOf<Number>& face)
{
  for (int part = 0; part < 4; ++part)
  {
    std::memcpy(&face.X + 4 * part, stored[part][k], 4 * sizeof(Number));
  }
}

/// Four by four the numbers of class ConvexTileFace, of as many faces as a vector has lanes, to `out`.
template <class D, class Corners>
void ProjectFaceLanes(D d, const Corners& corners, const FaceKinds<D>& kinds,
  const FaceLimits<hn::TFromD<D>>& limits, hn::TFromD<D>* const (&out)[4])
{
  const FaceLanes<D> f(corners, kinds.HasTwo, limits);
  // Above 0 on the other triangle's side of the diagonal.
  const auto side = hn::IfThenElse(
    f.UsesSecond, hn::Neg(f.Areas[0]), f.Areas[1]);
  const auto gx = hn::CopySign(hn::Abs(f.Edge[2][1]), hn::Neg(hn::Mul(f.Edge[2][1], side)));
  const auto gy = hn::CopySign(hn::Abs(f.Edge[2][0]), hn::Mul(f.Edge[2][0], side));
  FaceFunction<D> u(f, 2, gx, gy);
  u.Fold = hn::IfThenElseZero(kinds.IsWarped, u.Fold);
  const FaceFunction<D> s(f, 3, gx, gy);
  const auto good = IsTrusted(f, u, s, kinds.IsStep, kinds.IsWarped, limits);
  const auto one = hn::Set(d, hn::TFromD<D>(1)), zero = hn::Zero(d);
  const auto mixed = hn::IfThenElseZero(
    hn::Lt(hn::Mul(f.Areas[0], f.Areas[1]), zero), hn::CopySign(one, side));
  hn::StoreInterleaved4(f.First[0], f.First[1], f.First[2], u.A, d, out[0]);
  hn::StoreInterleaved4(u.B, f.First[3], s.A, s.B, d, out[1]);
  hn::StoreInterleaved4(gx, gy, u.Fold, s.Fold, d, out[2]);
  hn::StoreInterleaved4(
    hn::IfThenElseZero(good, hn::CopySign(one, f.BaseArea())), mixed, zero, zero, d, out[3]);
}
}
}
HWY_AFTER_NAMESPACE();

#endif
