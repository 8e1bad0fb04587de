/**
 * Functions of vectors in fast forms, each with its error.
 */
#if defined(TileMath_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileMath_inl_h
#undef TileMath_inl_h
#else
#define TileMath_inl_h
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// first, first + 1, ... : hn::Iota may write the lanes one by one and wait for them.
template <class D>
HWY_INLINE hn::Vec<D> Ramp(D d, hn::TFromD<D> first)
{
  HWY_ALIGN static constexpr hn::TFromD<D> steps[16] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12,
    13, 14, 15 };
  return hn::Add(hn::Load(d, steps), hn::Set(d, first));
}

/// 1 / v; relative error below 5e-7 for normal numbers.
template <class D, class Vector>
HWY_INLINE Vector Reciprocal(D d, Vector v)
{
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
  const auto rough = hn::ApproximateReciprocal(v);
  return hn::Mul(rough, hn::NegMulAdd(v, rough, hn::Set(d, 2.0f)));
#else
  return hn::Div(hn::Set(d, 1.0f), v);
#endif
}

/// 1 - exp(-depth) for a depth in [0, 1]; relative error below 3e-7.
template <class D, class Vector>
HWY_INLINE Vector Absorption(D d, Vector depth)
{
  auto sum = hn::MulAdd(depth, hn::Set(d, -0.00090715819f), hn::Set(d, 0.00782370940f));
  sum = hn::MulAdd(sum, depth, hn::Set(d, -0.0414066017f));
  sum = hn::MulAdd(sum, depth, hn::Set(d, 0.166605219f));
  sum = hn::MulAdd(sum, depth, hn::Set(d, -0.499994576f));
  return hn::Mul(depth, hn::MulAdd(sum, depth, hn::Set(d, 0.99999994f)));
}

/// Where along a piece its light is absorbed in the mean, from 0 to 1: of an optical depth in [0,
/// 1] whose extinction changes linearly by `lean` = (back - front) / (back + front); error below
/// 1e-5.
template <class D, class Vector>
HWY_INLINE Vector AbsorptionMean(D d, Vector depth, Vector lean)
{
  const auto square = hn::Mul(lean, lean);
  const auto first = hn::MulAdd(square, hn::Set(d, 0.0166699961f), hn::Set(d, -0.0833260566f));
  const auto second =
    hn::Mul(lean, hn::MulAdd(square, hn::Set(d, 0.00115666119f), hn::Set(d, -0.00271274615f)));
  const auto third = hn::MulAdd(square, hn::Set(d, -0.000323603483f), hn::Set(d, 0.00134092639f));
  const auto bend = hn::MulAdd(hn::MulAdd(third, depth, second), depth, first);
  return hn::MulAdd(bend, depth, hn::MulAdd(lean, hn::Set(d, 1.0f / 6.0f), hn::Set(d, 0.5f)));
}

/// The greatest optical depth of a piece that is thin.
constexpr float DeepestThin = 0.25f;

/// (1 - exp(-depth)) / depth of a thin piece; relative error below 4e-7.
template <class D, class Vector>
HWY_INLINE Vector ThinAlphaPerDepth(D d, Vector depth)
{
  auto sum = hn::MulAdd(depth, hn::Set(d, -0.03765174f), hn::Set(d, 0.16603504f));
  sum = hn::MulAdd(sum, depth, hn::Set(d, -0.49996795f));
  return hn::MulAdd(sum, depth, hn::Set(d, 0.99999979f));
}

/// What a thin piece absorbs whose extinction changes linearly. `bend`: half of what its extinction
/// is greater by at its back than at its front, times its length.
template <class Vector>
struct ThinAbsorption
{
  /// Alpha = 1 - exp(-depth), relative error below 4e-7. Moment: that times where it is absorbed in
  /// the mean, error of the place below 3e-5.
  Vector Alpha, Moment;

  template <class D>
  HWY_INLINE ThinAbsorption(D d, Vector depth, Vector bend)
  {
    const auto perDepth = ThinAlphaPerDepth(d, depth);
    this->Alpha = hn::Mul(perDepth, depth);
    const auto even = hn::MulAdd(depth, hn::Set(d, -0.083233634f), hn::Set(d, 0.5f));
    const auto odd = hn::MulAdd(bend, hn::Set(d, 0.016598028f),
      hn::MulAdd(depth, hn::Set(d, -0.00053190661f), hn::Set(d, 0.16668927f)));
    this->Moment = hn::MulAdd(this->Alpha, even, hn::Mul(hn::Mul(perDepth, bend), odd));
  }
};

/// 2 / sqrt(v); relative error below 1e-6 for normal numbers.
template <class D, class Vector>
HWY_INLINE Vector TwiceInverseRoot(D d, Vector v)
{
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
  const auto rough = hn::ApproximateReciprocalSqrt(v);
  return hn::Mul(rough, hn::NegMulAdd(hn::Mul(v, rough), rough, hn::Set(d, 3.0f)));
#else
  return hn::Div(hn::Set(d, 2.0f), hn::Sqrt(v));
#endif
}

/// Two places along a thin piece, 1/2 - 1/sqrt(12) and 1/2 + 1/sqrt(12), and twice the shares of its
/// alpha that stand for them; depth and bend as of ThinAbsorption. Exact as far as that is for what
/// is linear along the piece; per alpha the mean of (place - 1/2)^2 is wrong by 5e-3 at most, that of
/// its cube by 1.2e-2, both where extinction rises from zero.
template <class Vector>
struct ThinNodes
{
  Vector Alpha, Before, Behind;

  template <class D>
  HWY_INLINE ThinNodes(D d, Vector depth, Vector bend)
  {
    const auto perDepth = ThinAlphaPerDepth(d, depth);
    this->Alpha = hn::Mul(perDepth, depth);
    // The root of 12 times what the moment of ThinAbsorption differs by from half of alpha.
    const auto odd = hn::MulAdd(bend, hn::Set(d, 0.0574972553f),
      hn::MulAdd(depth, hn::Set(d, -0.00184257817f), hn::Set(d, 0.577428562f)));
    const auto even = hn::Mul(depth, hn::Set(d, -0.288329766f));
    const auto lean = hn::Mul(perDepth, hn::MulAdd(even, depth, hn::Mul(bend, odd)));
    this->Before = hn::Sub(this->Alpha, lean);
    this->Behind = hn::Add(this->Alpha, lean);
  }
};
}
}
HWY_AFTER_NAMESPACE();

#endif
