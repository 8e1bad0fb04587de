/**
 * The colours of thin, lit fragments that lie in one piece of the transfer function and along which
 * light changes little: most of them, where the function is smooth.
 *
 * Then nothing is cut, and light is looked at in two fixed places (ThinNodes). Only of grey
 * directional light in scenes with TileLighting::AllowsThin. Fragments that do not fit wait, each
 * alone, to be shaded as what is left of others is; where only light changes too much, by class SteepLight.
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
#include "TileSteepLight-inl.h"
#include "TileTask.h"
#include "TileThinCourses-inl.h"
#include "TileThinShine-inl.h"
#include "TileTransfer.h"

#include <hwy/highway.h>

#include <algorithm>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

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
    : Task(task)
    , Transfer(*task.Transfer)
    , Courses(task, tile)
    , Shining(*task.Lighting)
  {
  }

  /// Vectors that go through the steps together: within one the steps wait for each other.
  static constexpr int Batch = hn::MaxLanes(ShadeFloat()) < 16 ? 8 : 4;

  /// Colours a batch of fragments from `at` on; what does not fit waits in `rest`, or where light alone does not in
  /// `steep`.
  template <class LookUp>
  HWY_INLINE void Color(const LookUp& values, int at, TileFragments& q, TileLitPieces& rest, TileLitPieces& steep)
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
      this->ColorCourses(this->One, courses, count, at, q, rest, steep);
    }
    else
    {
      this->ColorCourses(values, courses, count, at, q, rest, steep);
    }
  }

  /// Colours what waits where light alone does not fit.
  template <class LookUp>
  HWY_INLINE void ColorSteep(const LookUp& values, TileFragments& q, TileLitPieces& steep, TileShadeCount& more) const
  {
    if constexpr (HasSteep)
    {
      SteepLight<Lights>(this->Task, this->Courses, this->Shining).Color(values, steep, q, more);
    }
  }

private:
  static constexpr bool HasSteep = std::is_same_v<Lights, ThinHeadlight>;

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
    TileFragments& q, TileLitPieces& rest, TileLitPieces& steep)
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
      this->ColorCourse(colors, courses[i], at + i * lanes, q, rest, steep, color);
      StoreColors(color, at + i * lanes, q);
    }
  }

  template <class LookUp>
  HWY_INLINE void ColorCourse(const ThinColors<LookUp>& colors, const ThinCourse& c, int at,
    const TileFragments& q, TileLitPieces& rest, TileLitPieces& steep, ShadeVector (&color)[4])
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
      this->Leave(c, fits, rows, at, q, rest, steep);
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
    const TileFragments& q, TileLitPieces& rest, TileLitPieces& steep) const
  {
    const ShadeFloat d;
    const auto used = hn::FirstN(d, static_cast<std::size_t>(q.Count - at));
    const auto which = hn::AndNot(fits, used);
    const auto bends = HasSteep ? hn::And(which, c.Fits) : hn::Xor(which, which);
    this->Append(c, bends, rows, at, q, steep);
    this->Append(c, hn::Xor(which, bends), rows, at, q, rest);
  }

  HWY_INLINE void Append(const ThinCourse& c, ShadeMask which, const ShadeVector* rows, int at,
    const TileFragments& q, TileLitPieces& rest) const
  {
    const ShadeFloat d;
    const ShadeInt di;
    if (hn::AllFalse(d, which))
    {
      return;
    }
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

  const TileTask& Task;
  const TileTransfer& Transfer;
  ThinCourses Courses;
  OnePieceLookUp One;
  const Lights Shining;
};
}
}
HWY_AFTER_NAMESPACE();

#endif
