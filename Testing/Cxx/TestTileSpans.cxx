// The pixels of tetrahedra that the Tiles engine finds between edges, row by row, against all pixels of their boxes
// by the planes themselves: for every instruction set that this machine has none is left out but by rounding, and
// none is one too many.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "TestTileSpans.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "TileCoverage-inl.h"
#include "TileSetup-inl.h"

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
// One cell of a group in double.
class SpanOracle
{
public:
  SpanOracle(const TileGroup& group, int k)
  {
    for (int f = 0; f < (group.Cut[k] != 0 ? 6 : 4); ++f)
    {
      const bool enters = f < 4 ? (group.Entries[k] >> f & 1) != 0 : f == TileGroup::CutEntry;
      (enters ? this->Entries : this->Exits).push_back({ group.A[f][k], group.B[f][k], group.P[f][k], f });
    }
  }

  struct Ray
  {
    double Entry = 1e300, Exit = -1e300;
    /// How far inside the outline, in pixels.
    double Inside = 1e300;
    /// What rounding is a share of.
    double Terms = 0.0;
  };
  Ray Cross(double x, double y) const
  {
    Ray ray;
    for (const Plane& in : this->Entries)
    {
      ray.Entry = std::min(ray.Entry, in.At(x, y));
      ray.Terms = std::max(ray.Terms, in.TermsAt(x, y));
      for (const Plane& out : this->Exits)
      {
        ray.Exit = std::max(ray.Exit, out.At(x, y));
        ray.Terms = std::max(ray.Terms, out.TermsAt(x, y));
        const double apart = in.At(x, y) - out.At(x, y), slope = std::hypot(in.A - out.A, in.B - out.B);
        const bool areCuts = in.Face >= 4 && out.Face >= 4;
        ray.Inside = areCuts ? ray.Inside : std::min(ray.Inside, apart / std::max(slope, 1e-300));
      }
    }
    return ray;
  }

private:
  struct Plane
  {
    double A, B, P;
    int Face;

    double At(double x, double y) const { return this->A * x + this->B * y + this->P; }
    double TermsAt(double x, double y) const
    {
      const double terms = std::abs(this->A * x) + std::abs(this->B * y) + std::abs(this->P);
      // A cut that there is not lies before or behind everything.
      return terms < 1e29 ? terms : 0.0;
    }
  };
  std::vector<Plane> Entries, Exits;
};

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
  const SpanOracle oracle(group, k);
  for (int y = 0; y < group.Height[k]; ++y)
  {
    for (int x = 0; x < group.Width[k]; ++x)
    {
      const SpanOracle::Ray ray = oracle.Cross(x, y);
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
  CoverGroup(task, tile, group, ids, k, k + 1, boxes, q);
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
#include "TestScene.h"
#include "TransferFunction.h"

#include <hwy/targets.h>

#include <iostream>
#include <numeric>

namespace CellProjectionTiles
{
HWY_EXPORT(CheckSpans);
}

namespace
{
/// Cells with places on the screen, and no mesh that they come from.
struct ScreenCells
{
  TileMesh Mesh;
  TileView View;
  TileVertices Vertices;
  TileCells Cells;
  TileTransfer Transfer;
  TileTask Task;
  int Count;

  ScreenCells(int kind, int count, bool isCut)
    : Count(count)
  {
    this->Vertices.Values = HardTetrahedra(kind, count, 7u + static_cast<unsigned int>(kind)).Corners;
    this->Mesh.Corners.resize(4 * static_cast<std::size_t>(count));
    std::iota(this->Mesh.Corners.begin(), this->Mesh.Corners.end(), 0);
    this->Mesh.Steps.assign(static_cast<std::size_t>(count), 0);
    this->Cells.Faces.assign(static_cast<std::size_t>(count), 0);
    // So deep that floats are trusted wherever they are numbers.
    this->View.Extent = 1e6;
    const std::vector<double> nodes = { 0.0, 0.3, 0.4, 0.6, 0.7, 1.0 };
    const double range[2] = { 0.0, 1.0 };
    TransferFunction function;
    function.Build(nodes,
      [isCut](double x) { return TransferFunction::Sample{ { x, 0.5, 0.5, isCut && (x < 0.35 || x > 0.65) ? 0.0 : 0.5 } }; },
      range, range, 1.0);
    this->Transfer.Build(function, 1.0);
    this->Task.Mesh = &this->Mesh;
    this->Task.View = &this->View;
    this->Task.Vertices = &this->Vertices;
    this->Task.Cells = &this->Cells;
    this->Task.Transfer = &this->Transfer;
    this->Task.OpticalDepth = 1e-6;
  }
};

// Whole tiles, parts of them, one pixel; a cell's place counts from the viewport's corner.
std::vector<TileRectangle> MakeRectangles()
{
  std::vector<TileRectangle> rectangles = { TileRectangle::OfTile(0, 64, 64), TileRectangle::OfTile(0, 33, 17),
    TileRectangle::OfTile(3, 100, 128) };
  for (const auto& box : { std::array<int, 4>{ 3, 5, 60, 47 }, { 31, 0, 31, 63 }, { 0, 20, 63, 20 }, { 30, 30, 30, 30 } })
  {
    TileRectangle part = rectangles[0];
    part.FirstX = box[0];
    part.FirstY = box[1];
    part.LastX = box[2];
    part.LastY = box[3];
    rectangles.push_back(part);
  }
  return rectangles;
}

void CheckKind(TestChecks& checks, int kind, bool isCut)
{
  const ScreenCells cells(kind, 300, isCut);
  TileSpanErrors errors;
  for (const TileRectangle& rectangle : MakeRectangles())
  {
    HWY_DYNAMIC_DISPATCH(CellProjectionTiles::CheckSpans)(cells.Task, rectangle, cells.Count, errors);
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
