// The pixels of tetrahedra that the Tiles engine finds between edges, row by row, against all pixels of their boxes
// by the planes themselves: for every instruction set that this machine has none is left out but by rounding, and
// none is one too many.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "TestTileSpans.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "TileCoverage-inl.h"
#include "TileSetup-inl.h"
#include "TileSpanOracle.h"

#ifndef TestTileSpans_Errors
#define TestTileSpans_Errors
struct TileSpanErrors
{
  /// How far inside the cell a pixel lies that is left out, how far outside one that is not; in pixels.
  double Missed = 0.0, Held = 0.0;
  /// Of where rays enter and leave, as a share of what the planes' terms are.
  double Ends = 0.0;
  /// Cells with another box than that of their corners, or with fragments beside it, twice or of a length below zero.
  int Wrong = 0;
  /// Cells that were looked at, of these of four sides, and cut ones; cells in double.
  int Cells = 0, FourSided = 0, Cut = 0, Exact = 0;
  long long Covered = 0;
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
// What was found of one cell: a fragment for each pixel of the tile, or -1.
using FoundPixels = std::array<int, TileSize::Pixels * TileSize::Pixels>;

bool FindFragments(const TileFragments& q, const TileGroup& group, int k, FoundPixels& found)
{
  bool isGood = true;
  found.fill(-1);
  for (int at = 0; at < q.Count; ++at)
  {
    const int pixel = q.Pixel[at];
    const int x = pixel % TileSize::Pixels - group.Left[k], y = pixel / TileSize::Pixels - group.Bottom[k];
    const bool isInBox = pixel >= 0 && x >= 0 && y >= 0 && x < group.Width[k] && y < group.Height[k];
    isGood = isGood && isInBox && found[pixel] < 0 && q.Extent[at] >= 0.0f;
    if (isInBox)
    {
      found[pixel] = at;
    }
  }
  return isGood;
}

// The pixels between a cell's corners along an axis.
bool IsBox(const TileTask& task, int id, int axis, int first, int last, int begin, int size)
{
  float low = 3e38f, high = -3e38f;
  for (int corner = 0; corner < 4; ++corner)
  {
    const float at = task.Vertices->Values[4 * static_cast<std::size_t>(task.Mesh->Corners[4 * id + corner]) + axis];
    low = std::min(low, at);
    high = std::max(high, at);
  }
  const int from = std::max(static_cast<int>(std::ceil(low)), first);
  const int to = std::min(static_cast<int>(std::floor(high)), last);
  return from > to ? size <= 0 : begin == from && size == to - from + 1;
}

void CheckCell(const TileFragments& q, const TileGroup& group, int k, TileSpanErrors& errors)
{
  static FoundPixels found;
  errors.Wrong += FindFragments(q, group, k, found) ? 0 : 1;
  const TileSpanOracle oracle(group, k);
  for (int y = 0; y < group.Height[k]; ++y)
  {
    for (int x = 0; x < group.Width[k]; ++x)
    {
      const TileSpanOracle::Ray ray = oracle.Cross(x, y);
      const int at = found[(group.Bottom[k] + y) * TileSize::Pixels + group.Left[k] + x];
      errors.Missed = std::max(errors.Missed, at < 0 ? ray.Inside : 0.0);
      errors.Held = std::max(errors.Held, at < 0 ? 0.0 : -ray.Inside);
      errors.Covered += ray.Inside > 0.0 ? 1 : 0;
      if (at >= 0)
      {
        const double extent = std::max(ray.Entry - ray.Exit, 0.0);
        const double off = std::max(std::abs(q.Entry[at] - ray.Entry), std::abs(q.Extent[at] - extent));
        errors.Ends = std::max(errors.Ends, off / ray.Terms);
      }
    }
  }
}

// A cell of a group that has been set up.
void CheckCellOfGroup(const TileTask& task, const TileRectangle& tile, const TileGroup& group, const int* ids, int k,
  TileFragments& q, TileSpanErrors& errors)
{
  errors.Exact += group.Exact[k] != 0 ? 1 : 0;
  if (group.Exact[k] != 0)
  {
    return;
  }
  std::uint32_t boxes[TileGroup::Size];
  q.Count = 0;
  CoverGroup(task, tile, group, ids, k, k + 1, boxes, q, [] {});
  CheckCell(q, group, k, errors);
  const bool areBoxes =
    IsBox(task, ids[k], 0, tile.FirstX, tile.LastX, group.Left[k] + tile.Left, group.Width[k]) &&
    IsBox(task, ids[k], 1, tile.FirstY, tile.LastY, group.Bottom[k] + tile.Bottom, group.Height[k]);
  errors.Wrong += areBoxes ? 0 : 1;
  ++errors.Cells;
  errors.FourSided += hwy::PopCount(static_cast<std::uint32_t>(group.Entries[k])) == 2 ? 1 : 0;
  errors.Cut += group.Cut[k] != 0 ? 1 : 0;
}

void CheckSpans(const TileTask& task, const TileRectangle& tile, int cells, TileSpanErrors& errors)
{
  const SetupBounds bounds(task);
  const auto group = std::make_unique<TileGroup>();
  const auto q = std::make_unique<TileFragments>();
  std::vector<int> ids(static_cast<std::size_t>(cells));
  for (int id = 0; id < cells; ++id)
  {
    ids[id] = id;
  }
  for (int first = 0; first < cells; first += TileGroup::Size)
  {
    // What an earlier group left behind must not matter.
    std::memset(group.get(), 0x7b, sizeof(TileGroup));
    const int count = std::min(cells - first, TileGroup::Size);
    SetUpGroup(task, tile, bounds, &ids[first], count, *group);
    for (int k = 0; k < count; ++k)
    {
      CheckCellOfGroup(task, tile, *group, &ids[first], k, *q, errors);
    }
  }
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
HWY_EXPORT(CheckSpans);
}

namespace
{
void CheckKind(TestChecks& checks, int kind, bool isCut)
{
  const ScreenCells cells(HardTetrahedra(kind, 300, 7u + static_cast<unsigned int>(kind)).Corners, isCut);
  TileSpanErrors errors;
  for (const TileRectangle& rectangle : ScreenCells::MakeRectangles())
  {
    HWY_DYNAMIC_DISPATCH(CellProjectionTiles::CheckSpans)(cells.Task, rectangle, cells.GetCount(), errors);
  }
  std::cout << "  " << HardTetrahedra::GetName(kind) << (isCut ? ", cut" : "") << ": " << errors.Cells << " cells, "
            << errors.FourSided << " of four sides, " << errors.Cut << " cut, " << errors.Exact << " in double, "
            << errors.Covered << " pixels; missed by " << errors.Missed << ", held by " << errors.Held
            << ", ends " << errors.Ends << "\n";
  CHECK(errors.Wrong == 0);
  CHECK_AT_MOST(errors.Missed, 1e-5);
  CHECK_AT_MOST(errors.Held, 1e-5);
  CHECK_AT_MOST(errors.Ends, 5e-7);
  CHECK(errors.Cells > 400 && errors.FourSided > 300);
  CHECK(errors.Covered > 50);
  CHECK(isCut ? errors.Cut > 200 : errors.Cut == 0);
}
}

int TestTileSpans(int, char*[])
{
  TestChecks checks;
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    hwy::GetChosenTarget().Update(target);
    std::cout << hwy::TargetName(target) << "\n";
    for (int kind = 0; kind < HardTetrahedra::NumberOfKinds; ++kind)
    {
      CheckKind(checks, kind, false);
      CheckKind(checks, kind, true);
    }
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return checks.Result();
}
#endif
