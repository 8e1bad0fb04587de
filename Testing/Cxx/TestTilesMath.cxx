// The fast functions of the Tiles engine against their closed forms, for every instruction set that
// this machine has.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "TestTilesMath.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "TileCompositing-inl.h"
#include "TileMath-inl.h"
#include "TilePacking-inl.h"
#include "TilePieces-inl.h"

#ifndef TestTilesMath_Errors
#define TestTilesMath_Errors
struct TilesMathErrors
{
  double Reciprocal = 0.0;
  double Absorption = 0.0;
  double Mean = 0.0;
  double ThinAbsorption = 0.0;
  double ThinMean = 0.0;
  /// Lanes that were not packed where they belong.
  int Packed = 0;
  /// Look-ups that found what belongs to another piece, and pieces that were not found.
  int LookedUp = 0;
  int Pieces = 0;
  double Root = 0.0;
  /// Of a pixel.
  double Blended = 0.0;
  /// Of the mean of the place less 1/2, its square and its cube.
  double Nodes[3] = { 0.0, 0.0, 0.0 };
};
/// By quadrature: the mean of a power of the place, counted from `from`, of the light absorbed along
/// a piece.
double MeanOfAbsorption(double depth, double lean, double from = 0.0, int power = 1);
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
void MeasureThin(float depth, float lean, TilesMathErrors& errors)
{
  const hn::CappedTag<float, 1> d;
  using Vector = hn::Vec<decltype(d)>;
  auto valueOf = [](auto vector) { return static_cast<double>(hn::GetLane(vector)); };
  const ThinAbsorption<Vector> thin(d, hn::Set(d, depth), hn::Set(d, depth * lean));
  const double exact = -std::expm1(-static_cast<double>(depth));
  const double alpha = valueOf(thin.Alpha), mean = valueOf(thin.Moment) / exact;
  errors.ThinAbsorption = std::max(errors.ThinAbsorption, std::abs(alpha / exact - 1.0));
  errors.ThinMean = std::max(errors.ThinMean, std::abs(mean - MeanOfAbsorption(depth, lean)));
}

// Lanes of the set `bits` must come first, in their order.
template <class D>
void CheckPacking(D d, int bits, TilesMathErrors& errors)
{
  const hn::RebindToSigned<D> di;
  const int lanes = static_cast<int>(hn::Lanes(d));
  std::uint8_t set[8] = { static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8) };
  HWY_ALIGN float floats[16], packedFloats[16];
  HWY_ALIGN int numbers[16], packedNumbers[16];
  for (int k = 0; k < lanes; ++k)
  {
    numbers[k] = 7 * k + 3;
    floats[k] = static_cast<float>(numbers[k]);
  }
  const LanePacker<D> pack(d, hn::LoadMaskBits(d, set));
  hn::Store(pack(hn::Load(d, floats)), d, packedFloats);
  hn::Store(pack(hn::Load(di, numbers)), di, packedNumbers);
  for (int k = 0, at = 0; k < lanes; ++k)
  {
    if ((bits >> k & 1) != 0)
    {
      errors.Packed += packedFloats[at] != floats[k] || packedNumbers[at] != numbers[k] ? 1 : 0;
      ++at;
    }
  }
}

void CheckPacking(TilesMathErrors& errors)
{
  const hn::CappedTag<float, 16> whole;
  for (int bits = 0; bits < 1 << hn::Lanes(whole); ++bits)
  {
    CheckPacking(whole, bits, errors);
  }
  const hn::Rebind<float, hn::CappedTag<double, 8>> half;
  for (int bits = 0; bits < 1 << hn::Lanes(half); ++bits)
  {
    CheckPacking(half, bits, errors);
  }
}

struct PieceTable
{
  int NumberOfPieces = 0, SearchSteps = 0;
  std::vector<float> Bounds, Numbers;
};

// Piece i begins at i.
PieceTable TableOf(int pieces)
{
  PieceTable table;
  table.NumberOfPieces = pieces;
  table.Bounds.assign(64, 3e38f);
  for (int i = 0; i <= pieces; ++i)
  {
    table.Numbers.push_back(static_cast<float>(i));
  }
  std::copy_n(table.Numbers.begin(), pieces, table.Bounds.begin());
  table.Numbers.resize(64);
  while (1 << table.SearchSteps < pieces)
  {
    ++table.SearchSteps;
  }
  return table;
}

// A look-up of a place gives its number.
void CheckLookUps(int pieces, TilesMathErrors& errors)
{
  const ShadeFloat d;
  const ShadeInt di;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const PieceTable table = TableOf(pieces);
  for (int i = 0; i <= pieces; ++i)
  {
    HWY_ALIGN int index[16], piece[16];
    HWY_ALIGN float scalar[16], value[16];
    for (int k = 0; k < lanes; ++k)
    {
      index[k] = (i + k) % (pieces + 1);
      scalar[k] = static_cast<float>(index[k]) + (k % 2 == 0 ? 0.0f : 0.5f);
    }
    WithLookUp(table,
      [&](auto values)
      {
        hn::Store(values(table.Numbers.data(), hn::Load(di, index)), d, value);
        hn::Store(PieceOf(values, table, hn::Load(d, scalar)), di, piece);
      });
    for (int k = 0; k < lanes; ++k)
    {
      errors.LookedUp += value[k] != static_cast<float>(index[k]) ? 1 : 0;
      errors.Pieces += piece[k] != std::min(index[k], pieces - 1) ? 1 : 0;
    }
  }
}

void MeasureNodes(float depth, float lean, TilesMathErrors& errors)
{
  const hn::CappedTag<float, 1> d;
  using Vector = hn::Vec<decltype(d)>;
  auto valueOf = [](auto vector) { return static_cast<double>(hn::GetLane(vector)); };
  const ThinNodes<Vector> nodes(d, hn::Set(d, depth), hn::Set(d, depth * lean));
  const double before = valueOf(nodes.Before), behind = valueOf(nodes.Behind);
  const double apart = std::sqrt(1.0 / 12.0), alpha = -std::expm1(-static_cast<double>(depth));
  errors.ThinAbsorption =
    std::max(errors.ThinAbsorption, std::abs((before + behind) / (2.0 * alpha) - 1.0));
  for (int i = 0; i < 3; ++i)
  {
    const double sum = behind * std::pow(apart, i + 1) + before * std::pow(-apart, i + 1);
    const double exact = MeanOfAbsorption(depth, lean, 0.5, i + 1);
    errors.Nodes[i] = std::max(errors.Nodes[i], std::abs(sum / (2.0 * alpha) - exact));
  }
}

// Few pixels, so that many fragments of a vector lie in the same ones: each goes under those before it.
void MeasureBlending(TilesMathErrors& errors)
{
  constexpr int Pixels = 20;
  const auto q = std::make_unique<TileFragments>();
  const auto tile = std::make_unique<TileBuffer>();
  double blended[Pixels][4] = {};
  unsigned int random = 1;
  q->Count = 1003;
  for (int k = 0; k < q->Count; ++k)
  {
    random = random * 1664525u + 1013904223u;
    q->Pixel[k] = static_cast<int>(random >> 8) % Pixels;
    double(&pixel)[4] = blended[q->Pixel[k]];
    const double through = 1.0 - pixel[3], alpha = 0.001 * static_cast<double>(k % 100);
    for (int i = 0; i < 4; ++i)
    {
      const double color = i == 3 ? alpha : alpha * static_cast<double>((k + i) % 7);
      q->Slots[ColorSlot(k)][i] = static_cast<float>(i == 3 ? -alpha : color);
      pixel[i] += through * color;
    }
  }
  tile->Clear(TileSize::Pixels, false);
  CompositeFragments<false>(*q, 0.0f, *tile);
  for (int k = 0; k < Pixels; ++k)
  {
    const TileBuffer::Pixel& pixel = tile->Pixels[k];
    errors.Blended = std::max({ errors.Blended, std::abs(pixel.Red - blended[k][0]),
      std::abs(pixel.Green - blended[k][1]), std::abs(pixel.Blue - blended[k][2]),
      std::abs(1.0 - pixel.Through - blended[k][3]) });
  }
}

void MeasureErrors(TilesMathErrors& errors)
{
  MeasureBlending(errors);
  CheckPacking(errors);
  for (int pieces = 1; pieces <= 40; ++pieces)
  {
    CheckLookUps(pieces, errors);
  }
  const hn::CappedTag<float, 1> d;
  auto valueOf = [](auto vector) { return static_cast<double>(hn::GetLane(vector)); };
  for (int i = 1; i <= 1000; ++i)
  {
    const float share = static_cast<float>(i) / 1000.0f;
    const float wide = std::exp(40.0f * share - 20.0f);
    const double inverse = valueOf(Reciprocal(d, hn::Set(d, wide)));
    errors.Reciprocal = std::max(errors.Reciprocal, std::abs(inverse * wide - 1.0));
    const double exact = -std::expm1(-static_cast<double>(share));
    const double alpha = valueOf(Absorption(d, hn::Set(d, share)));
    errors.Absorption = std::max(errors.Absorption, std::abs(alpha / exact - 1.0));
    const float lean = static_cast<float>(i % 21) / 10.0f - 1.0f;
    const double mean = valueOf(AbsorptionMean(d, hn::Set(d, share), hn::Set(d, lean)));
    errors.Mean = std::max(errors.Mean, std::abs(mean - MeanOfAbsorption(share, lean)));
    MeasureThin(share * DeepestThin, lean, errors);
    MeasureNodes(share * DeepestThin, lean, errors);
    const double root = valueOf(TwiceInverseRoot(d, hn::Set(d, wide)));
    errors.Root = std::max(errors.Root, std::abs(0.5 * root * std::sqrt(wide) - 1.0));
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
HWY_EXPORT(MeasureErrors);
}

double MeanOfAbsorption(double depth, double lean, double from, int power)
{
  double moment = 0.0, sum = 0.0;
  constexpr int Steps = 2000;
  for (int i = 0; i < Steps; ++i)
  {
    const double x = (i + 0.5) / Steps;
    const double before = depth * ((1.0 - lean) * x + lean * x * x);
    const double absorbed = (1.0 - lean + 2.0 * lean * x) * std::exp(-before);
    moment += std::pow(x - from, power) * absorbed;
    sum += absorbed;
  }
  return moment / sum;
}

int TestTilesMath(int, char*[])
{
  TestChecks checks;
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    hwy::GetChosenTarget().Update(target);
    TilesMathErrors errors;
    HWY_DYNAMIC_DISPATCH(CellProjectionTiles::MeasureErrors)(errors);
    std::cout << hwy::TargetName(target) << ": reciprocal " << errors.Reciprocal << ", absorption "
              << errors.Absorption << ", mean " << errors.Mean << ", of thin pieces "
              << errors.ThinAbsorption << " and " << errors.ThinMean << ", root " << errors.Root
              << ", nodes " << errors.Nodes[0] << ", " << errors.Nodes[1] << ", "
              << errors.Nodes[2] << "\n";
    CHECK_AT_MOST(errors.Reciprocal, 5e-7);
    CHECK_AT_MOST(errors.Absorption, 3e-7);
    CHECK_AT_MOST(errors.Mean, 1e-5);
    CHECK_AT_MOST(errors.ThinAbsorption, 4e-7);
    CHECK_AT_MOST(errors.ThinMean, 3e-5);
    CHECK(errors.Packed == 0);
    CHECK_AT_MOST(errors.Blended, 1e-5);
    CHECK(errors.LookedUp == 0);
    CHECK(errors.Pieces == 0);
    CHECK_AT_MOST(errors.Root, 1e-6);
    CHECK_AT_MOST(errors.Nodes[0], 3e-5);
    CHECK_AT_MOST(errors.Nodes[1], 5e-3);
    CHECK_AT_MOST(errors.Nodes[2], 1.3e-2);
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return checks.Result();
}
#endif
