// Fragments of thin parts, cut by a node or not, that begin and end anywhere or on nodes, against quadrature, for every
// instruction set that this machine has and for functions of few pieces and of many; those that are cut twice or are not
// thin must be left. And which pieces and depths vectors that go through the steps together have.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "TestTilesThinParts.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "TilePieces-inl.h"
#include "TileThinPieces-inl.h"
#include "TileTransfer.h"
#include "TransferFunction.h"

#ifndef TestTilesThinParts_Errors
#define TestTilesThinParts_Errors
struct ThinPartsErrors
{
  double Color = 0.0;
  /// Fragments that were wrongly said to have thin parts, or not; those that had.
  int Misjudged = 0;
  int Fitting = 0;
};
struct ThinBatchErrors
{
  double Depth = 0.0;
  /// Vectors with a piece that does not hold them, or that wait though it does, and batches.
  int Misjudged = 0, Mixed = 0, OfOnePiece = 0;
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
/// A zigzag of extinction, up and down.
TileTransfer MakeZigzag(int pieces);
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

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

struct ThinPartsEnds
{
  float First, Last, Length;
};

// Each anywhere.
ThinPartsEnds FindEnds(int i)
{
  return { (static_cast<float>(i % 31) + 0.3f) / 31.0f, (static_cast<float>(i / 31 % 29) + 0.6f) / 29.0f,
    0.05f + 0.1f * static_cast<float>(i % 7) };
}

// Where a piece begins and ends, or the scalars do.
float LowOf(const TileTransfer& transfer, int piece) { return std::max(transfer.Bounds[piece], -0.1f); }
float HighOf(const TileTransfer& transfer, int piece) { return std::min(transfer.Bounds[piece + 1], 1.1f); }

// On nodes, between them and where it began, across three nodes at most.
ThinPartsEnds FindEndsAtNodes(const TileTransfer& transfer, int i)
{
  const int places = 2 * transfer.NumberOfPieces - 1;
  auto placeOf = [&transfer](int place)
  {
    const float low = LowOf(transfer, place / 2), high = HighOf(transfer, place / 2);
    return place % 2 == 1 ? high : low + 0.37f * (high - low);
  };
  const int from = i % places, to = std::min(std::max(from + i / places % 9 - 4, 0), places - 1);
  return { placeOf(from), placeOf(to), 0.05f + 0.1f * static_cast<float>(i / places / 9 % 7) };
}

template <class Ends>
void Fill(int begin, const Ends& ends, ThinPartsVector& v)
{
  for (int k = 0; k < static_cast<int>(hn::Lanes(ShadeFloat())); ++k)
  {
    const ThinPartsEnds fragment = ends(begin + k);
    v.First[k] = fragment.First;
    v.Last[k] = fragment.Last;
    v.Length[k] = fragment.Length;
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

bool IsNode(const TileTransfer& transfer, float scalar)
{
  const auto begin = transfer.Bounds.begin();
  return std::find(begin, begin + transfer.NumberOfPieces + 1, scalar) != begin + transfer.NumberOfPieces + 1;
}

void Compare(const TileTransfer& transfer, const ThinPartsVector& v, ThinPartsErrors& errors)
{
  for (int k = 0; k < static_cast<int>(hn::Lanes(ShadeFloat())); ++k)
  {
    const ThinPartsRay ray = IntegrateRay(transfer, v.First[k], v.Last[k], v.Length[k]);
    const bool fits = v.Fits[k] != 0.0f, isCut = v.IsCut[k] != 0.0f;
    // Falling from a node it may begin with nothing of the piece above.
    const bool mayBeAbove = v.First[k] > v.Last[k] && IsNode(transfer, v.First[k]);
    const bool isClose = std::abs(ray.Deepest - DeepestThin) < 1e-3, isThin = ray.Deepest < DeepestThin;
    const bool mustFit = isThin && ray.Parts + (mayBeAbove ? 1 : 0) <= 2, mayFit = isThin && ray.Parts <= 2;
    errors.Misjudged += !isClose && ((mustFit && !fits) || (fits && !mayFit)) ? 1 : 0;
    errors.Misjudged += fits && !mayBeAbove && (ray.Parts == 2) != isCut ? 1 : 0;
    errors.Fitting += fits ? 1 : 0;
    for (int i = 0; i < 4 && fits; ++i)
    {
      errors.Color = std::max(errors.Color, std::abs(v.Color[i][k] - ray.Color[i]));
    }
  }
}

template <class Ends>
void MeasureFragments(const TileTransfer& transfer, int count, const Ends& ends, ThinPartsErrors& errors)
{
  for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(ShadeFloat())))
  {
    ThinPartsVector v;
    Fill(i, ends, v);
    WithLookUp(transfer, [&](auto values) { Shade(values, transfer, v); });
    Compare(transfer, v, errors);
  }
}

void MeasureThinParts(ThinPartsErrors& errors)
{
  const TileTransfer hat = HatOfFourPieces();
  MeasureFragments(hat, 31 * 29, FindEnds, errors);
  MeasureFragments(hat, 7 * 9 * 7, [&](int i) { return FindEndsAtNodes(hat, i); }, errors);
}

void MeasureZigzag(int pieces, ThinPartsErrors& errors)
{
  const TileTransfer zigzag = MakeZigzag(pieces);
  MeasureFragments(zigzag, (2 * pieces - 1) * 9 * 2, [&](int i) { return FindEndsAtNodes(zigzag, i); }, errors);
}

// Of all lanes of a vector: whether they lie in a piece, and the greatest error of their depths by it.
struct VectorOfPiece
{
  bool IsHeld = true;
  double Error = 0.0;

  VectorOfPiece(const TileTransfer& transfer, int piece, const ThinPartsVector& v, const float* depths)
  {
    for (int k = 0; k < static_cast<int>(hn::Lanes(ShadeFloat())); ++k)
    {
      const double first = v.First[k], last = v.Last[k];
      const double depth = (transfer.Slopes[3][piece] * 0.5 * (first + last) + transfer.Offsets[3][piece]) * v.Length[k];
      const bool isInPiece = std::min(first, last) >= transfer.Bounds[piece] &&
        std::max(first, last) <= transfer.Bounds[piece + 1];
      this->IsHeld = this->IsHeld && isInPiece && depth <= DeepestThin;
      this->Error = std::max(this->Error, std::abs(depths[k] - depth));
    }
  }
};

// By turns: vectors that lie in a piece, with one end on each of its nodes, and others.
void FillBatch(std::mt19937& random, const TileTransfer& transfer, ThinPartsVector& v)
{
  std::uniform_real_distribution<float> share(0.0f, 1.0f);
  const int piece = static_cast<int>(random() % static_cast<unsigned int>(transfer.NumberOfPieces));
  const unsigned int kind = random() % 8;
  const float low = LowOf(transfer, piece), high = HighOf(transfer, piece);
  for (int k = 0; k < static_cast<int>(hn::Lanes(ShadeFloat())); ++k)
  {
    v.First[k] = low + (high - low) * share(random);
    v.Last[k] = kind == 1 ? (k % 2 == 0 ? low : high) : low + (high - low) * share(random);
    v.Length[k] = 0.3f * share(random);
  }
  const std::size_t lane = random() % hn::Lanes(ShadeFloat());
  v.Last[lane] = kind == 2 ? high + 0.01f : kind == 3 ? low - 0.01f : v.Last[lane];
  // One lane alone may take it for any number.
  const bool isNumber = kind != 4 || hn::Lanes(ShadeFloat()) == 1;
  v.First[lane] = isNumber ? v.First[lane] : std::numeric_limits<float>::quiet_NaN();
  v.Length[lane] = kind == 5 ? 100.0f : v.Length[lane];
}

void CompareBatch(const TileTransfer& transfer, const ThinBatch& batch, const ThinPartsVector* vectors,
  bool areMostOfOne, ThinBatchErrors& errors)
{
  int mixed = 0;
  for (int i = 0; i < batch.Count; ++i)
  {
    HWY_ALIGN float depths[16];
    hn::Store(batch.Depths[i], ShadeFloat(), depths);
    const int piece = static_cast<int>(batch.Lines[i].Piece - transfer.Lines.data());
    const bool isMixed = (batch.Mixed >> i & 1) != 0;
    mixed += isMixed ? 1 : 0;
    const VectorOfPiece own(transfer, piece, vectors[i], depths);
    bool isHeld = own.IsHeld;
    for (int any = 0; any < transfer.NumberOfPieces; ++any)
    {
      isHeld = isHeld || VectorOfPiece(transfer, any, vectors[i], depths).IsHeld;
    }
    errors.Misjudged += isMixed ? (isHeld ? 1 : 0) : (own.IsHeld ? 0 : 1);
    errors.Depth = std::max(errors.Depth, isMixed ? 0.0 : own.Error);
  }
  errors.Misjudged += areMostOfOne == (2 * mixed <= batch.Count) && batch.Mixed >> batch.Count == 0 ? 0 : 1;
  errors.Mixed += mixed;
  errors.OfOnePiece += batch.Count - mixed;
}

void MeasureBatches(int pieces, ThinBatchErrors& errors)
{
  const TileTransfer zigzag = MakeZigzag(pieces);
  const ShadeFloat d;
  std::mt19937 random(5);
  ThinLine line{ zigzag.Lines.data() };
  for (int round = 0; round < 100; ++round)
  {
    ThinPartsVector vectors[ThinBatch::Size];
    ThinBatch batch;
    batch.Count = 1 + round % ThinBatch::Size;
    for (int i = 0; i < batch.Count; ++i)
    {
      ThinPartsVector& v = vectors[i];
      FillBatch(random, zigzag, v);
      batch.Courses[i] = { hn::Load(d, v.First), hn::Load(d, v.Last), hn::Load(d, v.Length) };
    }
    const bool areMostOfOne =
      WithLookUp(zigzag, [&](auto values) { return batch.FindDepths(values, zigzag, line); });
    CompareBatch(zigzag, batch, vectors, areMostOfOne, errors);
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
HWY_EXPORT(MeasureZigzag);
HWY_EXPORT(MeasureBatches);
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

TileTransfer MakeZigzag(int pieces)
{
  std::vector<double> nodes;
  // Beyond both ends lies a piece each.
  for (int i = 0; i <= pieces - 2; ++i)
  {
    nodes.push_back(static_cast<double>(i) / (pieces - 2));
  }
  const double range[2] = { 0.0, 1.0 };
  TransferFunction function;
  function.Build(nodes,
    [&](double x)
    {
      const double node = x * (pieces - 2), up = std::abs(node - 2.0 * std::round(0.5 * node));
      return TransferFunction::Sample{ { x, 1.0 - x, 0.3 + 0.4 * up, 0.1 + 0.6 * up } };
    },
    range, range, 1.0);
  TileTransfer transfer;
  transfer.Build(function, 10.0);
  return transfer;
}

namespace
{
void CheckFragments(TestChecks& checks, const char* name, const ThinPartsErrors& errors, int least)
{
  std::cout << "  " << name << ": " << errors.Fitting << " fragments, " << errors.Color << "\n";
  CHECK_AT_MOST(errors.Color, 3e-6);
  CHECK(errors.Misjudged == 0);
  CHECK(errors.Fitting > least);
}

void CheckPieces(TestChecks& checks, int pieces)
{
  CHECK(MakeZigzag(pieces).NumberOfPieces == pieces);
  ThinPartsErrors zigzag;
  HWY_DYNAMIC_DISPATCH(CellProjectionTiles::MeasureZigzag)(pieces, zigzag);
  CheckFragments(checks, "zigzag", zigzag, 9 * pieces);
  ThinBatchErrors errors;
  HWY_DYNAMIC_DISPATCH(CellProjectionTiles::MeasureBatches)(pieces, errors);
  std::cout << "  " << pieces << " pieces: vectors of one piece " << errors.OfOnePiece << ", mixed "
            << errors.Mixed << ", depths " << errors.Depth << "\n";
  CHECK(errors.Misjudged == 0);
  CHECK_AT_MOST(errors.Depth, 1e-6);
  CHECK(errors.OfOnePiece > 100 && errors.Mixed > 100);
}
}

int TestTilesThinParts(int, char*[])
{
  TestChecks checks;
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    hwy::GetChosenTarget().Update(target);
    std::cout << hwy::TargetName(target) << "\n";
    ThinPartsErrors errors;
    HWY_DYNAMIC_DISPATCH(CellProjectionTiles::MeasureThinParts)(errors);
    CheckFragments(checks, "hat", errors, 700);
    // In registers or in memory, counted or searched.
    for (const int pieces : { 3, 7, 15, 40 })
    {
      CheckPieces(checks, pieces);
    }
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return checks.Result();
}
#endif
