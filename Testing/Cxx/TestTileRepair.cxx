// Pieces of marked pixels, gathered from several queues and put in order: every one of them once and no other's, pixel
// by pixel, by the depth of its middle, and as they came where that is the same; in runs, backwards, at random,
// without ends, and very many in one pixel.

#include "TestScene.h"
#include "TileBuffer.h"
#include "TileFragments.h"
#include "TileRepair.h"
#include "TileView.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <tuple>
#include <vector>

namespace
{
struct Piece
{
  float Entry, Extent;
  int Pixel, Cell;

  bool operator==(const Piece& other) const { return this->Cell == other.Cell && this->Pixel == other.Pixel; }
};
using Pieces = std::vector<Piece>;

struct Tile
{
  TileView View;
  TileBuffer Buffer;
  TileFragments Queue;
  TileRepair Repair;

  explicit Tile(bool inPerspective)
  {
    this->View.WeightScale = inPerspective ? 1.0 : 0.0;
    this->View.WeightOffset = inPerspective ? 0.25 : 1.0;
  }

  void Mark(int pixel)
  {
    this->Buffer.Wrong[pixel] = 1;
    this->Buffer.HasWrong = true;
  }

  void Collect(const Pieces& pieces)
  {
    TileFragments& q = this->Queue;
    for (std::size_t i = 0; i < pieces.size();)
    {
      for (q.Count = 0; q.Count < 300 && i < pieces.size(); ++q.Count, ++i)
      {
        q.Entry[q.Count] = pieces[i].Entry;
        q.Extent[q.Count] = pieces[i].Extent;
        q.ScalarIn[q.Count] = pieces[i].Entry + 1.0f;
        q.ScalarOut[q.Count] = pieces[i].Extent + 2.0f;
        q.Pixel[q.Count] = pieces[i].Pixel;
        q.Cell[q.Count] = pieces[i].Cell;
      }
      this->Repair.Collect(q);
    }
  }

  Pieces TakeAll(TestChecks& checks)
  {
    Pieces taken;
    const TileFragments& q = this->Queue;
    while (this->Repair.Take(this->Queue))
    {
      for (int i = 0; i < q.Count; ++i)
      {
        taken.push_back({ q.Entry[i], q.Extent[i], q.Pixel[i], q.Cell[i] });
        const bool isNone = std::isnan(q.Entry[i]) || std::isnan(q.Extent[i]);
        CHECK(isNone || (q.ScalarIn[i] == q.Entry[i] + 1.0f && q.ScalarOut[i] == q.Extent[i] + 2.0f));
      }
    }
    return taken;
  }
};

// How far the middle is: in perspective u is 1 / depth less a number; what is not a number comes last.
float DepthOf(const Piece& piece, bool inPerspective)
{
  const double in = piece.Entry, out = in - piece.Extent;
  const double depth = inPerspective ? (in + out + 0.5) / ((in + 0.25) * (out + 0.25)) : -(in + out);
  return std::isnan(depth) ? 3e38f : static_cast<float>(std::min(depth, 3e38));
}

bool IsMarked(int pixel)
{
  return pixel % 3 == 1;
}

// No two depths that differ are within rounding of each other.
Pieces Expected(Pieces pieces, bool inPerspective)
{
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(), [](const Piece& p) { return !IsMarked(p.Pixel); }),
    pieces.end());
  std::stable_sort(pieces.begin(), pieces.end(),
    [inPerspective](const Piece& a, const Piece& b)
    {
      return std::make_tuple(a.Pixel, DepthOf(a, inPerspective)) <
        std::make_tuple(b.Pixel, DepthOf(b, inPerspective));
    });
  return pieces;
}

void Check(TestChecks& checks, const char* name, const Pieces& pieces, bool inPerspective)
{
  const auto tile = std::make_unique<Tile>(inPerspective);
  int marks = 0;
  for (int pixel = 0; pixel < TileBuffer::Size; ++pixel)
  {
    if (IsMarked(pixel))
    {
      tile->Mark(pixel);
      ++marks;
    }
  }
  // Twice: nothing is left of the first time.
  for (int time = 0; time < 2; ++time)
  {
    checks.Check(tile->Repair.Find(tile->Buffer) == marks, name, __LINE__, "marks");
    tile->Collect(pieces);
    tile->Repair.Sort(tile->View);
    const Pieces taken = tile->TakeAll(checks);
    checks.Check(!taken.empty() && taken == Expected(pieces, inPerspective), name, __LINE__,
      std::to_string(taken.size()) + " of " + std::to_string(pieces.size()));
  }
}

// `count` pieces over the pixels below `pixels`, of steps of depth: those are far more than a float's.
template <class StepOf>
Pieces Make(int count, int pixels, bool inPerspective, const StepOf& stepOf)
{
  Pieces pieces;
  for (int i = 0; i < count; ++i)
  {
    const double depth = 2.0 + 1e-5 * stepOf(i);
    const double entry = inPerspective ? 1.0 / depth - 0.25 : -depth;
    pieces.push_back({ static_cast<float>(entry), 0.0625f, i % pixels, i });
  }
  return pieces;
}

void CheckAll(TestChecks& checks, bool inPerspective)
{
  std::mt19937 random(5);
  auto anyOf = [&random](int steps) { return [&random, steps](int) { return static_cast<int>(random() % steps); }; };
  auto make = [&](int count, int pixels, auto stepOf) { return Make(count, pixels, inPerspective, stepOf); };
  Check(checks, "in order", make(5000, 40, [](int i) { return i; }), inPerspective);
  Check(checks, "backwards", make(5000, 40, [](int i) { return 5000 - i; }), inPerspective);
  Check(checks, "three runs", make(5001, 40, [](int i) { return i * 3 % 5001; }), inPerspective);
  Check(checks, "at random", make(20000, TileBuffer::Size, anyOf(100000)), inPerspective);
  Check(checks, "often the same", make(5000, 10, anyOf(7)), inPerspective);
  Check(checks, "in one pixel", make(100000, 2, anyOf(100000)), inPerspective);
  Pieces endless = make(3000, 20, anyOf(100000));
  for (std::size_t i = 0; i < endless.size(); i += 7)
  {
    endless[i].Entry = std::numeric_limits<float>::infinity();
    endless[i].Extent = i % 2 == 0 ? 1.0f : std::numeric_limits<float>::quiet_NaN();
  }
  Check(checks, "without ends", endless, inPerspective);
}
}

int TestTileRepair(int, char*[])
{
  TestChecks checks;
  CheckAll(checks, false);
  CheckAll(checks, true);
  return checks.Result();
}
