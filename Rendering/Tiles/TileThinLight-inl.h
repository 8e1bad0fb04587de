/**
 * The colours of thin, lit fragments that lie in one piece of the transfer function and along which
 * light changes little: most of them, where the function is smooth.
 *
 * Then nothing is cut, and light is looked at in two fixed places (ThinNodes). Only of grey
 * directional light in scenes with TileLighting::AllowsThin. Fragments that do not fit wait, each
 * alone, to be shaded as what is left of others is.
 */
#if defined(TileThinLight_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileThinLight_inl_h
#undef TileThinLight_inl_h
#else
#define TileThinLight_inl_h
#endif

#include "TileColors-inl.h"
#include "TileLighting.h"
#include "TileLitPieces-inl.h"
#include "TileMath-inl.h"
#include "TilePieces-inl.h"
#include "TileTask.h"
#include "TileThinCourses-inl.h"
#include "TileTransfer.h"

#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Sums over the lights at the two nodes.
struct ThinShine
{
  ShadeVector Factor[2], Highlight[2];
};

/// The transfer function's colours.
template <class LookUp>
class ThinColors
{
public:
  HWY_INLINE ThinColors(const LookUp& values, const TileTransfer& transfer)
    : Values(values)
    , Transfer(transfer)
  {
  }
  HWY_INLINE ShadeVector Slope(int k, ShadeIndex piece) const
  {
    return this->Values(this->Transfer.Slopes[k].data(), piece);
  }
  HWY_INLINE ShadeVector Offset(int k, ShadeIndex piece) const
  {
    return this->Values(this->Transfer.Offsets[k].data(), piece);
  }

private:
  const LookUp& Values;
  const TileTransfer& Transfer;
};

/// Of one piece they are looked up once.
template <>
class ThinColors<OnePieceLookUp>
{
public:
  HWY_INLINE ThinColors(const OnePieceLookUp& one, const TileTransfer& transfer)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Slopes[k] = one(transfer.Slopes[k].data(), hn::Zero(ShadeInt()));
      this->Offsets[k] = one(transfer.Offsets[k].data(), hn::Zero(ShadeInt()));
    }
  }
  HWY_INLINE ShadeVector Slope(int k, ShadeIndex) const { return this->Slopes[k]; }
  HWY_INLINE ShadeVector Offset(int k, ShadeIndex) const { return this->Offsets[k]; }

private:
  ShadeVector Slopes[3], Offsets[3];
};

class ThinLight
{
public:
  ThinLight(const TileTask& task, const TileRectangle& tile)
    : Transfer(*task.Transfer)
    , Lighting(*task.Lighting)
    , Courses(task, tile)
    , WeightOffset(static_cast<float>(task.View->WeightOffset))
    , Power(static_cast<int>(task.Lighting->Power))
  {
  }

  /// Vectors that go through the steps together: within one the steps wait for each other.
  static constexpr int Batch = hn::MaxLanes(ShadeFloat()) < 16 ? 8 : 4;

  /// Colours a batch of fragments from `at` on; what does not fit waits in `rest`.
  template <class LookUp>
  HWY_INLINE void Color(const LookUp& values, int at, TileFragments& q, TileLitPieces& rest)
  {
    constexpr int lanes = static_cast<int>(hn::MaxLanes(ShadeFloat()));
    const int count = std::min(Batch, (q.Count - at + lanes - 1) / lanes);
    ThinCourse courses[Batch];
    for (int i = 0; i < count; ++i)
    {
      this->Courses.Find(q, at + i * lanes, courses[i]);
    }
    if (this->FindOnePiece(courses, count))
    {
      this->ColorCourses(this->One, courses, count, at, q, rest);
    }
    else
    {
      this->ColorCourses(values, courses, count, at, q, rest);
    }
  }

private:
  /// Goes over to the piece that all lie in, if there is one.
  HWY_INLINE bool FindOnePiece(const ThinCourse* courses, int count)
  {
    auto least = courses[0].First, greatest = least;
    for (int i = 0; i < count; ++i)
    {
      least = hn::Min(least, hn::Min(courses[i].First, courses[i].Last));
      greatest = hn::Max(greatest, hn::Max(courses[i].First, courses[i].Last));
    }
    return this->One.Take(this->Transfer, least, greatest);
  }

  template <class LookUp>
  HWY_INLINE void ColorCourses(const LookUp& values, ThinCourse (&courses)[Batch], int count, int at,
    TileFragments& q, TileLitPieces& rest)
  {
    constexpr int lanes = static_cast<int>(hn::MaxLanes(ShadeFloat()));
    for (int i = 0; i < count; ++i)
    {
      this->Courses.FindDepth(values, courses[i]);
      this->Courses.FindGradients(q, at + i * lanes, courses[i]);
    }
    ThinShine shines[Batch];
    for (int i = 0; i < count; ++i)
    {
      this->Shine(courses[i], shines[i]);
    }
    const ThinColors<LookUp> colors(values, this->Transfer);
    for (int i = 0; i < count; ++i)
    {
      ShadeVector color[4];
      Mix(colors, courses[i], shines[i], color);
      this->Leave(courses[i], at + i * lanes, q, rest, color);
      StoreColors(color, at + i * lanes, q);
    }
  }

  /// Light at both nodes; roots are taken twice as great, see TwiceInverseRoot.
  HWY_INLINE void Shine(const ThinCourse& c, ThinShine& shine) const
  {
    const ShadeFloat d;
    ShadeVector inverse[2], seen[2];
    for (int i = 0; i < 2; ++i)
    {
      inverse[i] = TwiceInverseRoot(d, c.Square[i]);
      const ShadeVector(&g)[3] = c.Gradient[i];
      seen[i] = hn::Mul(hn::MulAdd(c.EyeX, g[0], hn::MulAdd(c.EyeY, g[1], g[2])), inverse[i]);
      shine.Factor[i] = hn::Set(d, 0.5f * this->Lighting.Ambient[0]);
      shine.Highlight[i] = hn::Zero(d);
    }
    for (const TileLight& light : this->Lighting.Lights)
    {
      const auto diffuse = hn::Set(d, 0.25f * light.Diffuse[0]);
      ShadeVector cosine[2];
      for (int i = 0; i < 2; ++i)
      {
        cosine[i] = hn::Mul(SideOf(light, c.Gradient[i]), inverse[i]);
        shine.Factor[i] = hn::MulAdd(hn::Abs(cosine[i]), diffuse, shine.Factor[i]);
      }
      if (this->Lighting.HasHighlight)
      {
        this->AddHighlight(c, light, cosine, seen, shine);
      }
    }
  }

  HWY_INLINE void AddHighlight(const ThinCourse& c, const TileLight& light,
    const ShadeVector (&cosine)[2], const ShadeVector (&seen)[2], ThinShine& shine) const
  {
    const ShadeFloat d;
    auto toLight = hn::Set(d, 2.0f * light.Towards[2]);
    if (!light.IsAlongView)
    {
      toLight = hn::MulAdd(c.EyeX, hn::Set(d, 2.0f * light.Towards[0]), toLight);
      toLight = hn::MulAdd(c.EyeY, hn::Set(d, 2.0f * light.Towards[1]), toLight);
    }
    const auto perEye = hn::Mul(c.PerEye, hn::Set(d, 0.25f));
    ShadeVector mirrored[2];
    for (int i = 0; i < 2; ++i)
    {
      const auto above = hn::Max(hn::MulSub(cosine[i], seen[i], toLight), hn::Zero(d));
      mirrored[i] = hn::Mul(above, perEye);
    }
    this->Raise(mirrored);
    const auto specular = hn::Set(d, 0.5f * light.Specular[0]);
    for (int i = 0; i < 2; ++i)
    {
      shine.Highlight[i] = hn::MulAdd(mirrored[i], specular, shine.Highlight[i]);
    }
  }

  /// To the power, which is whole and at least 2.
  HWY_INLINE void Raise(ShadeVector (&bases)[2]) const
  {
    int left = this->Power;
    for (; (left & 1) == 0; left >>= 1)
    {
      bases[0] = hn::Mul(bases[0], bases[0]);
      bases[1] = hn::Mul(bases[1], bases[1]);
    }
    ShadeVector powers[2] = { bases[0], bases[1] };
    while ((left >>= 1) != 0)
    {
      powers[0] = hn::Mul(powers[0], powers[0]);
      powers[1] = hn::Mul(powers[1], powers[1]);
      if (left & 1)
      {
        bases[0] = hn::Mul(bases[0], powers[0]);
        bases[1] = hn::Mul(bases[1], powers[1]);
      }
    }
  }

  /// What both nodes make of the transfer function's colours.
  template <class LookUp>
  static HWY_INLINE void Mix(const ThinColors<LookUp>& colors, const ThinCourse& c,
    const ThinShine& shine, ShadeVector (&color)[4])
  {
    const ShadeFloat d;
    const ThinNodes<ShadeVector> nodes(d, c.Depth, c.Bend);
    const auto before = hn::Mul(nodes.Before, shine.Factor[0]);
    const auto behind = hn::Mul(nodes.Behind, shine.Factor[1]);
    const auto factor = hn::Add(before, behind);
    const auto rise = hn::Mul(hn::Sub(c.Last, c.First), hn::Set(d, 0.5f * ThinApart));
    const auto moment = hn::Mul(rise, hn::Sub(behind, before));
    const auto highlight = hn::MulAdd(
      nodes.Before, shine.Highlight[0], hn::Mul(nodes.Behind, shine.Highlight[1]));
    const auto mean = hn::Mul(hn::Add(c.First, c.Last), hn::Set(d, 0.5f));
    for (int k = 0; k < 3; ++k)
    {
      const auto slope = colors.Slope(k, c.Piece);
      const auto middle = hn::MulAdd(slope, mean, colors.Offset(k, c.Piece));
      color[k] = hn::MulAdd(slope, moment, hn::MulAdd(middle, factor, highlight));
    }
    color[3] = hn::Neg(nodes.Alpha);
  }

  /// Where fragments do not fit there is no colour yet: they wait.
  HWY_INLINE void Leave(const ThinCourse& c, int at, const TileFragments& q, TileLitPieces& rest,
    ShadeVector (&color)[4]) const
  {
    const ShadeFloat d;
    if (hn::AllTrue(d, c.Fits))
    {
      return;
    }
    for (auto& component : color)
    {
      component = hn::IfThenElseZero(c.Fits, component);
    }
    const auto used = hn::FirstN(d, static_cast<std::size_t>(q.Count - at));
    this->Append(c, hn::AndNot(c.Fits, used), at, q, rest);
  }

  HWY_NOINLINE void Append(
    const ThinCourse& c, ShadeMask which, int at, const TileFragments& q, TileLitPieces& rest) const
  {
    const ShadeFloat d;
    const ShadeInt di;
    const LanePacker<ShadeFloat> pack(d, which);
    const int to = rest.Count;
    hn::StoreU(pack(c.First), d, rest.First + to);
    hn::StoreU(pack(c.Last), d, rest.Last + to);
    hn::StoreU(pack(c.Length), d, rest.Length + to);
    hn::StoreU(hn::Set(d, 1.0f), d, rest.Through + to);
    const auto half = hn::Mul(c.Inverse, hn::Set(d, 0.5f * this->WeightOffset * this->WeightOffset));
    for (int k = 0; k < 3; ++k)
    {
      const auto middle = hn::Mul(hn::Add(c.Gradient[1][k], c.Gradient[0][k]), half);
      const auto apart = hn::Mul(hn::Sub(c.Gradient[1][k], c.Gradient[0][k]), half);
      const auto rise = hn::Mul(apart, hn::Set(d, 2.0f / ThinApart));
      const auto begin = hn::NegMulAdd(rise, hn::Set(d, 0.5f), middle);
      hn::StoreU(pack(begin), d, rest.Gradient[k] + to);
      hn::StoreU(pack(rise), d, rest.GradientRise[k] + to);
    }
    hn::StoreU(pack(c.Piece), di, rest.Piece + to);
    hn::StoreU(pack(Ramp(di, at)), di, rest.Fragment + to);
    hn::StoreU(pack(hn::Load(di, q.Pixel + at)), di, rest.Pixel + to);
    rest.Count = to + static_cast<int>(hn::CountTrue(d, which));
  }

  const TileTransfer& Transfer;
  const TileLighting& Lighting;
  ThinCourses Courses;
  OnePieceLookUp One;
  const float WeightOffset;
  const int Power;
};
}
}
HWY_AFTER_NAMESPACE();

#endif
