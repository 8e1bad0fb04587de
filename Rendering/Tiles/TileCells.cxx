// Compiled once for each instruction set that the machine may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "TileCells.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "TileCells.h"
#include "TileClusters.h"
#include "TileExactCell.h"
#include "TileMesh.h"
#include "TileRecords-inl.h"
#include "TileSliver.h"
#include "TileVertices.h"
#include "TileView.h"
#include "vtkSMPTools.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

using Float = hn::CappedTag<float, TileRecords::Count>;
using Int = hn::RebindToSigned<Float>;

// Twice the area of the projected face of corners a, b and c, with its sign.
template <class Vector>
Vector AreaOf(const Vector (&a)[4], const Vector (&b)[4], const Vector (&c)[4])
{
  return hn::MulSub(
    hn::Sub(b[0], a[0]), hn::Sub(c[1], a[1]), hn::Mul(hn::Sub(b[1], a[1]), hn::Sub(c[0], a[0])));
}

// The first and the last tile that an axis' range of pixels touches; first > last where none.
template <class Vector>
void TilesOf(Vector low, Vector high, int size, hn::Vec<Int>& first, hn::Vec<Int>& last)
{
  const Float d;
  // Rounding must not keep a pixel from a cell that is drawn in double.
  const auto margin = hn::Set(d, 1.0f / 64.0f);
  const auto begin = hn::Max(hn::Ceil(hn::Sub(low, margin)), hn::Zero(d));
  const auto end =
    hn::Min(hn::Floor(hn::Add(high, margin)), hn::Set(d, static_cast<float>(size - 1)));
  const auto covered = hn::RebindMask(Int(), hn::Le(begin, end));
  first = hn::IfThenElse(
    covered, hn::ShiftRight<TileSize::Shift>(hn::ConvertTo(Int(), begin)), hn::Set(Int(), 255));
  last = hn::IfThenElseZero(covered, hn::ShiftRight<TileSize::Shift>(hn::ConvertTo(Int(), end)));
}

// The area up to which rounding may turn a face within that box, twice.
template <class Vector>
Vector TurningArea(const Vector (&low)[2], const Vector (&high)[2])
{
  const Float d;
  const auto extent = hn::Add(hn::Sub(high[0], low[0]), hn::Sub(high[1], low[1]));
  const auto farthest = hn::Max(hn::Max(hn::Abs(low[0]), hn::Abs(high[0])),
    hn::Max(hn::Abs(low[1]), hn::Abs(high[1])));
  return hn::Mul(hn::Mul(extent, hn::Set(d, 2.0f * TileSliver::AreaRounding)), farthest);
}

struct ProjectedGroup
{
  HWY_ALIGN int Box[TileRecords::Count];
  HWY_ALIGN int Exits[TileRecords::Count]; // of a cell of positive orientation
  HWY_ALIGN int Entries[TileRecords::Count];
  HWY_ALIGN int Outside[TileRecords::Count]; // whether a corner has no place on the screen
  HWY_ALIGN int Thin[TileRecords::Count];    // whether a face may be a sliver
};

void ProjectLanes(const TileRecords& records, int lane, const TileView& view, ProjectedGroup& out)
{
  const Float d;
  const Int di;
  hn::Vec<Float> v[4][4];
  for (int corner = 0; corner < 4; ++corner)
  {
    records.Load(d, corner, lane, v[corner]);
  }
  hn::Vec<Float> low[2], high[2];
  for (int k = 0; k < 2; ++k)
  {
    low[k] = hn::Min(hn::Min(v[0][k], v[1][k]), hn::Min(v[2][k], v[3][k]));
    high[k] = hn::Max(hn::Max(v[0][k], v[1][k]), hn::Max(v[2][k], v[3][k]));
  }
  hn::Vec<Int> x[2], y[2];
  TilesOf(low[0], high[0], view.Width, x[0], x[1]);
  TilesOf(low[1], high[1], view.Height, y[0], y[1]);
  hn::Store(hn::Or(hn::Or(x[0], hn::ShiftLeft<8>(x[1])),
              hn::Or(hn::ShiftLeft<16>(y[0]), hn::ShiftLeft<24>(y[1]))),
    di, out.Box + lane);
  const hn::Vec<Float> areas[4] = { AreaOf(v[1], v[2], v[3]), AreaOf(v[0], v[2], v[3]),
    AreaOf(v[0], v[1], v[3]), AreaOf(v[0], v[1], v[2]) };
  auto exits = hn::Zero(di), entries = hn::Zero(di), thin = hn::Zero(di);
  const auto turns = TurningArea(low, high);
  for (int f = 0; f < 4; ++f)
  {
    const auto bit = hn::Set(di, 1 << f);
    const auto above = hn::RebindMask(di, hn::Gt(areas[f], hn::Zero(d)));
    const auto below = hn::RebindMask(di, hn::Lt(areas[f], hn::Zero(d)));
    exits = hn::Or(exits, hn::IfThenElseZero(TileMesh::IsInward(f) ? above : below, bit));
    entries = hn::Or(entries, hn::IfThenElseZero(TileMesh::IsInward(f) ? below : above, bit));
    const auto isThin = hn::RebindMask(di, hn::Le(hn::Abs(areas[f]), turns));
    thin = hn::Or(thin, hn::IfThenElseZero(isThin, bit));
  }
  hn::Store(exits, di, out.Exits + lane);
  hn::Store(entries, di, out.Entries + lane);
  hn::Store(thin, di, out.Thin + lane);
  const auto outside = hn::Ge(high[0], hn::Set(d, TileVertices::OffScreen));
  hn::Store(
    hn::IfThenElseZero(hn::RebindMask(di, outside), hn::Set(di, 1)), di, out.Outside + lane);
}

void ProjectGroup(const TileMesh& mesh, const TileView& view, const TileVertices& vertices,
  int first, int count, TileCells& cells)
{
  TileRecords records;
  int ids[TileRecords::Count];
  for (int k = 0; k < TileRecords::Count; ++k)
  {
    ids[k] = first + std::min(k, count - 1);
  }
  records.Gather(mesh.Corners.data(), vertices.Values.data(), ids);
  ProjectedGroup group;
  for (int lane = 0; lane < TileRecords::Count; lane += static_cast<int>(hn::Lanes(Float())))
  {
    ProjectLanes(records, lane, view, group);
  }
  for (int k = 0; k < count; ++k)
  {
    const int cell = first + k;
    const bool positive = (mesh.Orientations[cell] > 0) == view.KeepsOrientation;
    const int* neighbours = &mesh.Neighbours[4 * static_cast<std::size_t>(cell)];
    const int exits = positive ? group.Exits[k] : group.Entries[k];
    const int entries = group.Exits[k] ^ group.Entries[k] ^ exits;
    const int linked = (neighbours[0] >= 0) | (neighbours[1] >= 0) << 1 |
                       (neighbours[2] >= 0) << 2 | (neighbours[3] >= 0) << 3;
    const bool isUnsure =
      (exits | entries) != TileCells::ExitFaces || (mesh.Steps[cell] & TileMesh::Folded) != 0;
    cells.Faces[cell] = static_cast<std::uint8_t>((exits & linked) |
      ((entries & ~linked) != 0 ? TileCells::Entered : 0) | (isUnsure ? TileCells::Unsure : 0) |
      (group.Outside[k] ? TileCells::Exact : 0));
    cells.Boxes[cell] = static_cast<std::uint32_t>(group.Box[k]);
  }
  for (int k = 0; k < count; ++k)
  {
    const bool isThin = group.Thin[k] != 0 && group.Outside[k] == 0;
    if (isThin && TileSliver::MeetsPixel(mesh, view, vertices, first + k))
    {
      cells.Faces[first + k] |= TileCells::Unsure;
    }
  }
}

// NOLINTNEXTLINE: Highway's dispatch table names it.
void ProjectRange(const TileMesh& mesh, const TileView& view, const TileVertices& vertices,
  int begin, int end, TileCells& cells)
{
  for (int first = begin; first < end; first += TileRecords::Count)
  {
    ProjectGroup(mesh, view, vertices, first, std::min(end - first, TileRecords::Count), cells);
  }
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace CellProjectionTiles
{
HWY_EXPORT(ProjectRange);
}

//------------------------------------------------------------------------------
void TileCells::Project(const TileMesh& mesh, const TileView& view, const TileVertices& vertices,
  const TileClusters& clusters)
{
  const int cells = mesh.GetNumberOfCells();
  this->Boxes.resize(static_cast<std::size_t>(cells));
  this->Faces.resize(static_cast<std::size_t>(cells));
  constexpr int Size = TileClusters::Size;
  vtkSMPTools::For(0, (cells + Size - 1) / Size, 32,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto cluster = static_cast<int>(begin); cluster < end; ++cluster)
      {
        const int first = cluster * Size, last = std::min(first + Size, cells);
        if (clusters.IsSeen(first))
        {
          this->ProjectRange(mesh, view, vertices, first, last);
          for (int cell = first; mesh.IsSparse && cell < last; ++cell)
          {
            this->Boxes[cell] = mesh.Drawn[cell] ? this->Boxes[cell] : NoTile;
          }
          continue;
        }
        std::fill(this->Boxes.begin() + first, this->Boxes.begin() + last, NoTile);
      }
    });
}

//------------------------------------------------------------------------------
void TileCells::ProjectRange(
  const TileMesh& mesh, const TileView& view, const TileVertices& vertices, int first, int last)
{
  HWY_DYNAMIC_DISPATCH(CellProjectionTiles::ProjectRange)
  (mesh, view, vertices, first, last, *this);
  for (int cell = first; cell < last; ++cell)
  {
    if (this->Faces[cell] & Exact)
    {
      this->ProjectExactly(mesh, view, cell);
    }
  }
}

//------------------------------------------------------------------------------
void TileCells::ProjectExactly(const TileMesh& mesh, const TileView& view, int cell)
{
  const TileExactCell exact(mesh, view, cell);
  const int* neighbours = &mesh.Neighbours[4 * static_cast<std::size_t>(cell)];
  this->Faces[cell] = Exact;
  for (int f = 0; f < 4; ++f)
  {
    const bool leaves =
      neighbours[f] >= 0 && !exact.Planes[f].IsEntry && exact.Planes[f].Tolerance == 0.0;
    this->Faces[cell] |= static_cast<std::uint8_t>(leaves ? 1 << f : 0);
  }
  const std::array<int, 4>& box = exact.Box;
  if (box[2] < box[0] || box[3] < box[1])
  {
    this->Boxes[cell] = NoTile;
    return;
  }
  auto tile = [](int pixel) { return static_cast<std::uint32_t>(pixel) >> TileSize::Shift; };
  this->Boxes[cell] = tile(box[0]) | tile(box[2]) << 8 | tile(box[1]) << 16 | tile(box[3]) << 24;
}
#endif
