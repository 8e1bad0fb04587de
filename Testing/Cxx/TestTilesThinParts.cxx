// Fragments of thin parts, cut by a node or not, against quadrature, for every instruction set that this machine has; those
// that are cut twice or are not thin must be left.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "TestTilesThinParts.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "TilePieces-inl.h"
#include "TileThinPieces-inl.h"
#include "TileTransfer.h"

#ifndef TestTilesThinParts_Errors
#define TestTilesThinParts_Errors
struct ThinPartsErrors
{
  double Color = 0.0;
  /// Fragments that were wrongly said to have thin parts, or not; those that had.
  int Misjudged = 0;
  int Fitting = 0;
};
struct ThinPartsRay
{
  /// And minus alpha.
  double Color[4] = { 0.0, 0.0, 0.0, 0.0 };
  /// The greatest optical depth of a part.
  double Deepest = 0.0;
  int Parts = 1;
};
/// By quadrature.
ThinPartsRay IntegrateRay(const TileTransfer& transfer, float first, float last, float length);
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
// A hat of extinction, between constants.
TileTransfer HatOfFourPieces()
{
  TileTransfer transfer;
  transfer.NumberOfPieces = 4;
  transfer.SearchSteps = 2;
  transfer.Bounds.assign(64, 3e38f);
  const float bounds[5] = { -1e30f, 0.2f, 0.5f, 0.8f, 1e30f };
  const float slopes[4] = { 0.0f, 2.0f, -1.5f, 0.0f }, offsets[4] = { 0.1f, -0.3f, 1.45f, 0.25f };
  std::copy_n(bounds, 5, transfer.Bounds.begin());
  for (int k = 0; k < 4; ++k)
  {
    const float share = k == 3 ? 1.0f : 0.3f * static_cast<float>(k + 1);
    transfer.Slopes[k].assign(64, 0.0f);
    transfer.Offsets[k].assign(64, 0.0f);
    for (int piece = 0; piece < 4; ++piece)
    {
      transfer.Slopes[k][piece] = share * slopes[piece];
      transfer.Offsets[k][piece] = share * offsets[piece];
    }
  }
  return transfer;
}

struct ThinPartsVector
{
  HWY_ALIGN float First[16], Last[16], Length[16], Color[4][16], Fits[16], IsCut[16];
};

// Fragments from the number `begin` on.
void Fill(int begin, ThinPartsVector& v)
{
  for (int k = 0; k < static_cast<int>(hn::Lanes(ShadeFloat())); ++k)
  {
    const int i = begin + k;
    v.First[k] = (static_cast<float>(i % 31) + 0.3f) / 31.0f;
    v.Last[k] = (static_cast<float>(i / 31 % 29) + 0.6f) / 29.0f;
    v.Length[k] = 0.05f + 0.1f * static_cast<float>(i % 7);
  }
}

template <class LookUp>
void Shade(const LookUp& values, const TileTransfer& transfer, ThinPartsVector& v)
{
  const ShadeFloat d;
  const ShadeCourse course{ hn::Load(d, v.First), hn::Load(d, v.Last), hn::Load(d, v.Length) };
  const ThinParts<LookUp> parts(values, transfer);
  ShadeVector color[4];
  ShadeMask isCut;
  const auto fits = parts.Color(course, hn::FirstN(d, hn::Lanes(d)), color, isCut);
  hn::Store(hn::IfThenElseZero(fits, hn::Set(d, 1.0f)), d, v.Fits);
  hn::Store(hn::IfThenElseZero(isCut, hn::Set(d, 1.0f)), d, v.IsCut);
  for (int i = 0; i < 4; ++i)
  {
    hn::Store(color[i], d, v.Color[i]);
  }
}

void Compare(const TileTransfer& transfer, const ThinPartsVector& v, ThinPartsErrors& errors)
{
  for (int k = 0; k < static_cast<int>(hn::Lanes(ShadeFloat())); ++k)
  {
    const ThinPartsRay ray = IntegrateRay(transfer, v.First[k], v.Last[k], v.Length[k]);
    const bool shouldFit = ray.Parts <= 2 && ray.Deepest < DeepestThin, fits = v.Fits[k] != 0.0f;
    const bool isClose = std::abs(ray.Deepest - DeepestThin) < 1e-3;
    errors.Misjudged += !isClose && shouldFit != fits ? 1 : 0;
    errors.Misjudged += fits && (ray.Parts == 2) != (v.IsCut[k] != 0.0f) ? 1 : 0;
    errors.Fitting += fits ? 1 : 0;
    for (int i = 0; i < 4 && fits; ++i)
    {
      errors.Color = std::max(errors.Color, std::abs(v.Color[i][k] - ray.Color[i]));
    }
  }
}

void MeasureThinParts(ThinPartsErrors& errors)
{
  const TileTransfer hat = HatOfFourPieces();
  for (int i = 0; i < 31 * 29; i += static_cast<int>(hn::Lanes(ShadeFloat())))
  {
    ThinPartsVector v;
    Fill(i, v);
    WithLookUp(hat, [&](auto values) { Shade(values, hat, v); });
    Compare(hat, v, errors);
  }
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "TestScene.h"

#include <hwy/targets.h>

#include <iostream>

namespace CellProjectionTiles
{
HWY_EXPORT(MeasureThinParts);
}

ThinPartsRay IntegrateRay(const TileTransfer& transfer, float first, float last, float length)
{
  ThinPartsRay ray;
  constexpr int Steps = 3000;
  double depth = 0.0, through = 1.0;
  int before = -1;
  for (int i = 0; i < Steps; ++i)
  {
    const double scalar = first + (last - first) * (i + 0.5) / Steps;
    int piece = 0;
    while (scalar >= transfer.Bounds[piece + 1])
    {
      ++piece;
    }
    auto value = [&](int k) { return transfer.Slopes[k][piece] * scalar + transfer.Offsets[k][piece]; };
    const double step = value(3) * length / Steps;
    const double absorbed = through * -std::expm1(-step);
    const bool begins = before >= 0 && piece != before;
    ray.Parts += begins ? 1 : 0;
    depth = begins ? step : depth + step;
    ray.Deepest = std::max(ray.Deepest, depth);
    for (int k = 0; k < 3; ++k)
    {
      ray.Color[k] += absorbed * value(k);
    }
    ray.Color[3] -= absorbed;
    through -= absorbed;
    before = piece;
  }
  return ray;
}

int TestTilesThinParts(int, char*[])
{
  TestChecks checks;
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    hwy::GetChosenTarget().Update(target);
    ThinPartsErrors errors;
    HWY_DYNAMIC_DISPATCH(CellProjectionTiles::MeasureThinParts)(errors);
    std::cout << hwy::TargetName(target) << ": " << errors.Fitting << " fragments, " << errors.Color << "\n";
    CHECK_AT_MOST(errors.Color, 3e-6);
    CHECK(errors.Misjudged == 0);
    CHECK(errors.Fitting > 500);
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return checks.Result();
}
#endif
