// The queue of fragments that the Tiles engine fills with whole groups of tetrahedra, in floats and in double, and
// hands on whenever it is full, against all pixels of their boxes by the planes themselves: for every instruction set
// that this machine has no cell's fragments are lost, repeated, overwritten or taken for another cell's.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "TestTileRuns.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "TileCoverage-inl.h"
#include "TileSetup-inl.h"
#include "TileSpanOracle.h"

#ifndef TestTileRuns_Errors
#define TestTileRuns_Errors
struct TileRunErrors
{
  /// How far inside a cell a pixel lies that is left out, how far outside one that is not; in pixels.
  double Missed = 0.0, Held = 0.0;
  /// Of where rays enter and leave, and of their scalars, as a share of what their terms are.
  double Ends = 0.0, Scalars = 0.0;
  /// Queues that were handed on too early or too late or hold what is no cell's; cells with fragments beside their box,
  /// twice or of a length below zero, or with another box.
  int WrongQueues = 0, WrongCells = 0;
  /// Queues, those that were full in the middle of a group, and behind a cell that shares them with others.
  int Queues = 0, InGroups = 0, Shared = 0;
  /// Cells, of these in double, and without a fragment.
  int Cells = 0, Exact = 0, Empty = 0;
  long long Fragments = 0;
};
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
// A cell whose fragments must be in the queue.
struct ExpectedCell
{
  int Id;
  bool IsExact;
  TileSpanOracle Oracle;
  /// In the tile: where the oracle counts from, and the box.
  int X, Y;
  int Left, Bottom, Width, Height;

  ExpectedCell(const TileGroup& g, int k, int id)
    : Id(id)
    , IsExact(false)
    , Oracle(g, k)
    , X(g.Left[k])
    , Y(g.Bottom[k])
    , Left(g.Left[k])
    , Bottom(g.Bottom[k])
    , Width(g.Width[k])
    , Height(g.Height[k])
  {
  }
  ExpectedCell(const TileExactCell& cell, const TileView& view, const TileRectangle& tile, int id)
    : Id(id)
    , IsExact(true)
    , Oracle(cell, view)
    , X(-tile.Left)
    , Y(-tile.Bottom)
    , Left(std::max(cell.Box[0], tile.FirstX) - tile.Left)
    , Bottom(std::max(cell.Box[1], tile.FirstY) - tile.Bottom)
    , Width(std::min(cell.Box[2], tile.LastX) - tile.Left + 1 - Left)
    , Height(std::min(cell.Box[3], tile.LastY) - tile.Bottom + 1 - Bottom)
  {
  }

  bool Holds(int pixel) const
  {
    const int x = pixel % TileSize::Pixels - this->Left, y = pixel / TileSize::Pixels - this->Bottom;
    return pixel >= 0 && x >= 0 && y >= 0 && x < this->Width && y < this->Height;
  }
  std::uint32_t GetBox() const
  {
    const bool isEmpty = this->Width <= 0 || this->Height <= 0;
    const std::uint32_t box = isEmpty ? 0 : TileBox::Pack(this->Left, this->Bottom, this->Width, this->Height);
    return this->IsExact ? TileBox::WholeTile() : box;
  }
};

class RunCheck
{
public:
  RunCheck(const TileTask& task, const TileRectangle& tile, int full, TileRunErrors& errors)
    : Task(task)
    , Tile(tile)
    , Errors(errors)
  {
    this->Queue.NamesCells = true;
    this->Queue.Full = full;
    this->Forget();
  }

  // As the engine does.
  void CoverCells(int cells)
  {
    std::array<int, TileGroup::Size> ids;
    for (int first = 0; first < cells; first += TileGroup::Size)
    {
      const int count = std::min(cells - first, TileGroup::Size);
      for (int k = 0; k < count; ++k)
      {
        ids[k] = first + k;
      }
      // What an earlier group left behind must not matter.
      std::memset(&this->Group, 0x7b, sizeof(TileGroup));
      SetUpGroup(this->Task, this->Tile, SetupBounds(this->Task), ids.data(), count, this->Group);
      this->CoverGroupOf(ids.data(), count);
    }
    this->HandOn();
  }

private:
  void CoverGroupOf(const int* ids, int count)
  {
    std::uint32_t boxes[TileGroup::Size];
    for (int k = 0; k < count;)
    {
      const int begin = k;
      k = CoverGroup(this->Task, this->Tile, this->Group, ids, k, count, boxes, this->Queue, [] {});
      for (int cell = begin; cell < k; ++cell)
      {
        this->Expect(ids[cell], cell);
        this->Errors.WrongCells += boxes[cell] == this->Expected.back().GetBox() ? 0 : 1;
      }
      const bool isFull = this->Queue.Count >= this->Queue.Full;
      this->Errors.WrongQueues += k <= begin || (k < count && !isFull) ? 1 : 0;
      this->Errors.InGroups += isFull && k < count ? 1 : 0;
      if (isFull)
      {
        this->HandOn();
      }
    }
  }

  void Expect(int id, int k)
  {
    const bool isExact = this->Group.Exact[k] != 0;
    isExact ? this->Expected.emplace_back(
                TileExactCell(*this->Task.Mesh, *this->Task.View, id), *this->Task.View, this->Tile, id)
            : this->Expected.emplace_back(this->Group, k, id);
    ++this->Errors.Cells;
    this->Errors.Exact += isExact ? 1 : 0;
  }

  void HandOn()
  {
    this->Queue.NameCells();
    int at = 0, last = 0, filled = 0;
    for (const ExpectedCell& cell : this->Expected)
    {
      const int begin = at;
      for (; at < this->Queue.Count && this->Queue.Cell[at] == cell.Id; ++at)
      {
      }
      this->CheckCell(cell, begin, at);
      last = at > begin ? begin : last;
      filled += at > begin ? 1 : 0;
      this->Errors.Empty += at > begin ? 0 : 1;
    }
    // None begins where it was full already.
    this->Errors.WrongQueues += at == this->Queue.Count && last < this->Queue.Full ? 0 : 1;
    this->Errors.Shared += at >= this->Queue.Full && filled > 1 ? 1 : 0;
    this->Errors.Fragments += at;
    ++this->Errors.Queues;
    this->Forget();
  }

  // Empties the queue and whatever it held.
  void Forget()
  {
    TileFragments& q = this->Queue;
    for (float* values : { q.Entry, q.Extent, q.ScalarIn, q.ScalarOut })
    {
      std::fill_n(values, TileFragments::Capacity, -1e30f);
    }
    std::fill_n(q.Pixel, TileFragments::Capacity, -1);
    std::fill_n(q.RowPixel, TileFragments::Capacity, static_cast<std::uint16_t>(65535));
    std::fill_n(q.Cell, TileFragments::Capacity, -1);
    q.Count = 0;
    this->Expected.clear();
  }

  void CheckCell(const ExpectedCell& cell, int begin, int end)
  {
    this->Found.fill(-1);
    for (int at = begin; at < end; ++at)
    {
      const int pixel = this->Queue.Pixel[at];
      const bool isGood = cell.Holds(pixel) && this->Found[pixel] < 0 && this->Queue.Extent[at] >= 0.0f;
      this->Errors.WrongCells += isGood ? 0 : 1;
      if (isGood)
      {
        this->Found[pixel] = at;
      }
    }
    for (int y = cell.Bottom; y < cell.Bottom + cell.Height; ++y)
    {
      for (int x = cell.Left; x < cell.Left + cell.Width; ++x)
      {
        this->CheckPixel(cell, x - cell.X, y - cell.Y, this->Found[y * TileSize::Pixels + x]);
      }
    }
  }

  // `at`: the fragment, or -1.
  void CheckPixel(const ExpectedCell& cell, double x, double y, int at)
  {
    const TileSpanOracle::Ray ray = cell.Oracle.Cross(x, y);
    this->Errors.Missed = std::max(this->Errors.Missed, at < 0 ? ray.Inside : 0.0);
    this->Errors.Held = std::max(this->Errors.Held, at < 0 ? 0.0 : -ray.Inside);
    // Along a plane a ray enters anywhere.
    if (at < 0 || ray.Inside < 1e-7)
    {
      return;
    }
    const TileFragments& q = this->Queue;
    const double off = std::max(std::abs(q.Entry[at] - ray.Entry), std::abs(q.Extent[at] - (ray.Entry - ray.Exit)));
    const TileSpanOracle::Scalar in = cell.Oracle.ScalarAt(x, y, ray.Entry), out = cell.Oracle.ScalarAt(x, y, ray.Exit);
    const double scalarOff = std::max(std::abs(q.ScalarIn[at] - in.Value), std::abs(q.ScalarOut[at] - out.Value));
    this->Errors.Ends = std::max(this->Errors.Ends, off / ray.Terms);
    this->Errors.Scalars = std::max(this->Errors.Scalars, scalarOff / std::max(in.Terms, out.Terms));
  }

  const TileTask& Task;
  const TileRectangle Tile;
  TileRunErrors& Errors;
  TileGroup Group;
  TileFragments Queue;
  std::vector<ExpectedCell> Expected;
  std::array<int, TileSize::Pixels * TileSize::Pixels> Found;
};

void CheckRuns(const TileTask& task, const TileRectangle& tile, int full, int cells, TileRunErrors& errors)
{
  std::make_unique<RunCheck>(task, tile, full, errors)->CoverCells(cells);
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "HardTetrahedra.h"
#include "ScreenCells.h"
#include "TestScene.h"

#include <hwy/targets.h>

#include <iostream>

namespace CellProjectionTiles
{
HWY_EXPORT(CheckRuns);
}

namespace
{
// By turns of all those kinds.
std::vector<float> MixKinds(const std::vector<int>& kinds, int count)
{
  std::vector<float> corners;
  for (int i = 0; i < count; ++i)
  {
    const int kind = kinds[static_cast<std::size_t>(i) % kinds.size()];
    const HardTetrahedra cell(kind, 1, 31u + static_cast<unsigned int>(i));
    corners.insert(corners.end(), cell.Corners.begin(), cell.Corners.end());
  }
  return corners;
}

// `exact`: every so manieth cell is in double, 0 where none is that need not be.
void CheckMix(TestChecks& checks, const std::vector<int>& kinds, int exact, bool isCut)
{
  // The last group is not a full one.
  ScreenCells cells(MixKinds(kinds, 315), isCut);
  cells.MakeExact(exact);
  TileRunErrors errors;
  const std::vector<TileRectangle> rectangles = ScreenCells::MakeRectangles();
  for (const std::size_t at : { 0, 2, 3 })
  {
    const int full = at == 0 ? TileFragments::Longest : TileFragments::Shortest;
    HWY_DYNAMIC_DISPATCH(CellProjectionTiles::CheckRuns)(cells.Task, rectangles[at], full, cells.GetCount(), errors);
  }
  std::cout << "  " << kinds.size() << " kinds" << (isCut ? ", cut" : "") << ": " << errors.Cells << " cells, "
            << errors.Exact << " in double, " << errors.Empty << " empty, " << errors.Fragments << " fragments in "
            << errors.Queues << " queues, " << errors.InGroups << " full within a group, " << errors.Shared
            << " shared; missed by " << errors.Missed << ", held by " << errors.Held << ", ends " << errors.Ends
            << ", scalars " << errors.Scalars << "\n";
  CHECK(errors.WrongQueues == 0);
  CHECK(errors.WrongCells == 0);
  CHECK_AT_MOST(errors.Missed, 1e-5);
  CHECK_AT_MOST(errors.Held, 1e-5);
  CHECK_AT_MOST(errors.Ends, 5e-7);
  CHECK_AT_MOST(errors.Scalars, 5e-7);
  CHECK(errors.Cells == 3 * cells.GetCount() && errors.Empty > 0);
  CHECK(exact == 0 || errors.Exact > errors.Cells / (2 * exact));
  CHECK(errors.InGroups > 5 && errors.Shared > 5);
}
}

int TestTileRuns(int, char*[])
{
  TestChecks checks;
  const std::vector<int> small = { HardTetrahedra::Any, HardTetrahedra::Flat, HardTetrahedra::Row };
  std::vector<int> all;
  for (int kind = 0; kind < HardTetrahedra::NumberOfKinds; ++kind)
  {
    all.push_back(kind);
  }
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    hwy::GetChosenTarget().Update(target);
    std::cout << hwy::TargetName(target) << "\n";
    for (const bool isCut : { false, true })
    {
      CheckMix(checks, all, 0, isCut);
      CheckMix(checks, all, 7, isCut);
      CheckMix(checks, small, 0, isCut);
    }
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return checks.Result();
}
#endif
