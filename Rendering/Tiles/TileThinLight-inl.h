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
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Sums over the lights at the two places.
struct ThinShine
{
  ShadeVector Factor[2], Highlight[2];
  ShadeMask StaysBefore; // no light is passed from one side to the other
};

/// To a power that is whole and at least 2.
HWY_INLINE void Raise(int power, ShadeVector (&bases)[2])
{
  int left = power;
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

/// What all lights need of the gradients: roots are taken twice as great, see TwiceInverseRoot.
struct ThinSights
{
  ShadeVector Inverse[2], Seen[2];
  ShadeVector PerEye, Depth;

  HWY_INLINE ThinSights(const ThinCourse& c, const ThinGradients& g, ShadeVector scale)
    : PerEye(hn::Mul(c.PerEye, scale))
    , Depth(c.Depth)
  {
    for (int i = 0; i < 2; ++i)
    {
      this->Inverse[i] = TwiceInverseRoot(ShadeFloat(), g.Square[i]);
      const auto toEye = hn::MulAdd(c.EyeX, g.At[i][0], hn::MulAdd(c.EyeY, g.At[i][1], g.At[i][2]));
      this->Seen[i] = hn::Mul(toEye, this->Inverse[i]);
    }
  }

  /// Whether both ends are on the same side, or what turns away is too little to be seen.
  HWY_INLINE ShadeMask StayBefore(const ShadeVector (&cosine)[2]) const
  {
    const ShadeFloat d;
    const auto apart = hn::Abs(hn::Sub(cosine[0], cosine[1]));
    const auto turned = hn::Mul(apart, hn::Set(d, 1.73205081f));
    const auto beyond = hn::Sub(turned, hn::Abs(hn::Add(cosine[0], cosine[1])));
    const auto seen = hn::MulSub(turned, this->Depth, hn::Set(d, 2.0f * LeastKink));
    return hn::Le(hn::Min(beyond, seen), hn::Zero(d));
  }

  /// Bases of highlights.
  HWY_INLINE void Mirror(const ShadeVector (&cosine)[2], ShadeVector toLight, ShadeVector (&mirrored)[2]) const
  {
    const ShadeFloat d;
    for (int i = 0; i < 2; ++i)
    {
      const auto above = hn::Max(hn::MulSub(cosine[i], this->Seen[i], toLight), hn::Zero(d));
      mirrored[i] = hn::Mul(above, this->PerEye);
    }
  }
};

/// One light along the view, with a highlight.
class ThinHeadlight
{
public:
  explicit ThinHeadlight(const TileLighting& lighting)
    : Power(static_cast<int>(lighting.Power))
    , Ambient(Spread(0.5f * lighting.Ambient[0]))
    , Diffuse(Spread(0.25f * lighting.Lights[0].Diffuse[0]))
    , Scale(Spread(0.25f * std::pow(0.5f * lighting.Lights[0].Specular[0], 1.0f / lighting.Power)))
    , ToLight(Spread(2.0f * lighting.Lights[0].Towards[2]))
  {
  }

  static bool Suits(const TileLighting& lighting)
  {
    return lighting.Lights.size() == 1 && lighting.Lights[0].IsAlongView && lighting.Lights[0].Specular[0] > 0.0f;
  }

  HWY_INLINE void Shine(const ThinCourse& c, const ThinGradients& g, ThinShine& shine) const
  {
    const ThinSights sights(c, g, this->Scale);
    const ShadeVector cosine[2] = { hn::Mul(g.At[0][2], sights.Inverse[0]),
      hn::Mul(g.At[1][2], sights.Inverse[1]) };
    shine.StaysBefore = sights.StayBefore(cosine);
    sights.Mirror(cosine, this->ToLight, shine.Highlight);
    Raise(this->Power, shine.Highlight);
    for (int i = 0; i < 2; ++i)
    {
      shine.Factor[i] = hn::MulAdd(hn::Abs(cosine[i]), this->Diffuse, this->Ambient);
    }
  }

private:
  static ShadeVector Spread(float value) { return hn::Set(ShadeFloat(), value); }

  const int Power;
  // Scale: of bases, whose powers have the light's strength then.
  const ShadeVector Ambient, Diffuse, Scale, ToLight;
};

/// Any lights.
class ThinLights
{
public:
  explicit ThinLights(const TileLighting& lighting)
    : Lighting(lighting)
    , Power(static_cast<int>(lighting.Power))
  {
  }

  HWY_INLINE void Shine(const ThinCourse& c, const ThinGradients& g, ThinShine& shine) const
  {
    const ShadeFloat d;
    const ThinSights sights(c, g, hn::Set(d, 0.25f));
    for (int i = 0; i < 2; ++i)
    {
      shine.Factor[i] = hn::Set(d, 0.5f * this->Lighting.Ambient[0]);
      shine.Highlight[i] = hn::Zero(d);
    }
    shine.StaysBefore = c.Fits;
    for (const TileLight& light : this->Lighting.Lights)
    {
      const auto diffuse = hn::Set(d, 0.25f * light.Diffuse[0]);
      ShadeVector cosine[2];
      for (int i = 0; i < 2; ++i)
      {
        cosine[i] = hn::Mul(Dot(g.At[i], light.Towards), sights.Inverse[i]);
        shine.Factor[i] = hn::MulAdd(hn::Abs(cosine[i]), diffuse, shine.Factor[i]);
      }
      shine.StaysBefore = hn::And(shine.StaysBefore, sights.StayBefore(cosine));
      if (this->Lighting.HasHighlight)
      {
        this->AddHighlight(c, light, cosine, sights, shine);
      }
    }
  }

private:
  HWY_INLINE void AddHighlight(const ThinCourse& c, const TileLight& light,
    const ShadeVector (&cosine)[2], const ThinSights& sights, ThinShine& shine) const
  {
    const ShadeFloat d;
    auto toLight = hn::Set(d, 2.0f * light.Towards[2]);
    toLight = hn::MulAdd(c.EyeX, hn::Set(d, 2.0f * light.Towards[0]), toLight);
    toLight = hn::MulAdd(c.EyeY, hn::Set(d, 2.0f * light.Towards[1]), toLight);
    ShadeVector mirrored[2];
    sights.Mirror(cosine, toLight, mirrored);
    Raise(this->Power, mirrored);
    const auto specular = hn::Set(d, 0.5f * light.Specular[0]);
    for (int i = 0; i < 2; ++i)
    {
      shine.Highlight[i] = hn::MulAdd(mirrored[i], specular, shine.Highlight[i]);
    }
  }

  const TileLighting& Lighting;
  const int Power;
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

template <class Lights>
class ThinLight
{
public:
  ThinLight(const TileTask& task, const TileRectangle& tile)
    : Transfer(*task.Transfer)
    , Courses(task, tile)
    , Shining(*task.Lighting)
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
    }
    const ThinColors<LookUp> colors(values, this->Transfer);
    for (int i = 0; i < count; ++i)
    {
      ShadeVector color[4];
      this->ColorCourse(colors, courses[i], at + i * lanes, q, rest, color);
      StoreColors(color, at + i * lanes, q);
    }
  }

  template <class LookUp>
  HWY_INLINE void ColorCourse(const ThinColors<LookUp>& colors, const ThinCourse& c, int at,
    const TileFragments& q, TileLitPieces& rest, ShadeVector (&color)[4])
  {
    ShadeVector mixed[ScreenGradients::Terms];
    const ShadeVector* rows = this->Courses.LoadRows(q, at, mixed);
    ThinGradients gradients;
    ThinCourses::FindGradients(rows, c, gradients);
    const auto turnsLittle = this->Courses.TurnsLittle(gradients, c.Depth);
    ThinShine shine;
    this->Shining.Shine(c, gradients, shine);
    this->Mix(colors, c, shine, color);
    const auto fits = hn::And(hn::And(c.Fits, shine.StaysBefore), turnsLittle);
    if (!hn::AllTrue(ShadeFloat(), fits))
    {
      // There is no colour yet: they wait.
      for (auto& component : color)
      {
        component = hn::IfThenElseZero(fits, component);
      }
      this->Leave(c, fits, rows, at, q, rest);
    }
  }

  /// What both nodes make of the transfer function's colours.
  template <class LookUp>
  HWY_INLINE void Mix(const ThinColors<LookUp>& colors, const ThinCourse& c, const ThinShine& shine,
    ShadeVector (&color)[4]) const
  {
    const ShadeFloat d;
    const auto before = hn::Mul(c.Before, shine.Factor[0]);
    const auto behind = hn::Mul(c.Behind, shine.Factor[1]);
    const auto factor = hn::Add(before, behind);
    const auto rise = hn::Sub(c.Last, c.First);
    const auto second = hn::MulAdd(rise, hn::Set(d, ThinPlaces[1]), c.First);
    const auto first = hn::MulAdd(rise, hn::Set(d, ThinPlaces[0]), c.First);
    const auto scalar = hn::MulAdd(before, first, hn::Mul(behind, second));
    const auto highlight =
      hn::MulAdd(c.Before, shine.Highlight[0], hn::Mul(c.Behind, shine.Highlight[1]));
    for (int k = 0; k < 3; ++k)
    {
      const auto even = hn::MulAdd(colors.Offset(k, c.Piece), factor, highlight);
      color[k] = hn::MulAdd(colors.Slope(k, c.Piece), scalar, even);
    }
    color[3] = hn::Neg(c.Alpha);
  }

  HWY_NOINLINE void Leave(const ThinCourse& c, ShadeMask fits, const ShadeVector* rows, int at,
    const TileFragments& q, TileLitPieces& rest) const
  {
    const ShadeFloat d;
    const ShadeInt di;
    const auto used = hn::FirstN(d, static_cast<std::size_t>(q.Count - at));
    const auto which = hn::AndNot(fits, used);
    const LanePacker<ShadeFloat> pack(d, which);
    const int to = rest.Count;
    hn::StoreU(pack(c.First), d, rest.First + to);
    hn::StoreU(pack(c.Last), d, rest.Last + to);
    hn::StoreU(pack(c.Length), d, rest.Length + to);
    hn::StoreU(hn::Set(d, 1.0f), d, rest.Through + to);
    ShadeVector begin[3], rise[3];
    this->Courses.FindRises(q, at, rows, c, begin, rise);
    for (int k = 0; k < 3; ++k)
    {
      hn::StoreU(pack(begin[k]), d, rest.Gradient[k] + to);
      hn::StoreU(pack(rise[k]), d, rest.GradientRise[k] + to);
    }
    hn::StoreU(pack(c.Piece), di, rest.Piece + to);
    hn::StoreU(pack(Ramp(di, at)), di, rest.Fragment + to);
    hn::StoreU(pack(hn::Load(di, q.Pixel + at)), di, rest.Pixel + to);
    rest.Count = to + static_cast<int>(hn::CountTrue(d, which));
  }

  const TileTransfer& Transfer;
  ThinCourses Courses;
  OnePieceLookUp One;
  const Lights Shining;
};
}
}
HWY_AFTER_NAMESPACE();

#endif
