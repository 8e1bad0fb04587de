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
#include <cstdint>

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

// The first and the last tile of 1 << shift pixels that an axis' range touches; first > last where none.
template <class Vector>
void TilesOf(Vector low, Vector high, int size, int shift, hn::Vec<Int>& first, hn::Vec<Int>& last)
{
  const Float d;
  // Rounding must not keep a pixel from a cell that is drawn in double.
  const auto margin = hn::Set(d, 1.0f / 64.0f);
  const auto begin = hn::Max(hn::Ceil(hn::Sub(low, margin)), hn::Zero(d));
  const auto end =
    hn::Min(hn::Floor(hn::Add(high, margin)), hn::Set(d, static_cast<float>(size - 1)));
  const auto covered = hn::RebindMask(Int(), hn::Le(begin, end));
  first = hn::IfThenElse(
    covered, hn::ShiftRightSame(hn::ConvertTo(Int(), begin), shift), hn::Set(Int(), 255));
  last = hn::IfThenElseZero(covered, hn::ShiftRightSame(hn::ConvertTo(Int(), end), shift));
}

// As in TileCells::Boxes.
template <class Vector>
hn::Vec<Int> BoxesOf(const Vector (&low)[2], const Vector (&high)[2], const TileView& view)
{
  hn::Vec<Int> x[2], y[2];
  TilesOf(low[0], high[0], view.Width, TileSize::Shift, x[0], x[1]);
  TilesOf(low[1], high[1], view.Height, view.RowShift, y[0], y[1]);
  return hn::Or(hn::Or(x[0], hn::ShiftLeft<8>(x[1])),
    hn::Or(hn::ShiftLeft<16>(y[0]), hn::ShiftLeft<24>(y[1])));
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

// What the mesh says of cells, wherever the eye is.
struct MeshGroup
{
  std::uint8_t Steps[TileRecords::Count] = {};
  // Bits 0 to 3: the faces across which there is no cell.
  std::uint8_t Open[TileRecords::Count] = {};
  signed char Orientations[TileRecords::Count] = {};

  MeshGroup(const TileMesh& mesh, int first, int count)
  {
    std::copy_n(&mesh.Steps[first], count, this->Steps);
    std::copy_n(&mesh.Orientations[first], count, this->Orientations);
    if (mesh.CellScalars.empty())
    {
      // Where scalars are the points' nothing else makes a step.
      std::copy_n(&mesh.Steps[first], count, this->Open);
      return;
    }
    for (int at = 0; at < 4 * count; ++at)
    {
      const int isOpen = mesh.Neighbours[4 * static_cast<std::size_t>(first) + at] < 0 ? 1 : 0;
      this->Open[at / 4] |= static_cast<std::uint8_t>(isOpen << at % 4);
    }
  }
};

struct ProjectedGroup
{
  HWY_ALIGN int Boxes[TileRecords::Count];
  HWY_ALIGN std::uint8_t Faces[TileRecords::Count];
  // Whether a face may be a sliver, and whether that is so of any cell.
  HWY_ALIGN int Thin[TileRecords::Count];
  bool AnyThin = false;
};

// Faces of cells of positive orientation that look up or down, as bits, and faces that may be slivers.
struct FaceSigns
{
  hn::Vec<Int> Exits, Entries, Thin;

  template <class Vector>
  FaceSigns(const Vector (&areas)[4], Vector turns)
    : Exits(hn::Zero(Int()))
    , Entries(hn::Zero(Int()))
    , Thin(hn::Zero(Int()))
  {
    const Float d;
    const Int di;
    for (int f = 0; f < 4; ++f)
    {
      const auto bit = hn::Set(di, 1 << f);
      const auto above = hn::RebindMask(di, hn::Gt(areas[f], hn::Zero(d)));
      const auto below = hn::RebindMask(di, hn::Lt(areas[f], hn::Zero(d)));
      this->Exits =
        hn::Or(this->Exits, hn::IfThenElseZero(TileMesh::IsInward(f) ? above : below, bit));
      this->Entries =
        hn::Or(this->Entries, hn::IfThenElseZero(TileMesh::IsInward(f) ? below : above, bit));
      const auto isThin = hn::RebindMask(di, hn::Le(hn::Abs(areas[f]), turns));
      this->Thin = hn::Or(this->Thin, hn::IfThenElseZero(isThin, bit));
    }
  }
};

// As in TileCells::Faces.
hn::Vec<Int> FacesOf(const FaceSigns& signs, const MeshGroup& cells, int lane,
  bool keepsOrientation, hn::Mask<Int> isOutside)
{
  const Int di;
  const hn::Rebind<std::uint8_t, Int> bytes;
  const hn::Rebind<std::int8_t, Int> signedBytes;
  const auto steps = hn::PromoteTo(di, hn::LoadU(bytes, cells.Steps + lane));
  const auto allFaces = hn::Set(di, TileCells::ExitFaces);
  const auto open = hn::And(hn::PromoteTo(di, hn::LoadU(bytes, cells.Open + lane)), allFaces);
  const auto orientation = hn::PromoteTo(di, hn::LoadU(signedBytes, cells.Orientations + lane));
  const auto isAbove = hn::Gt(orientation, hn::Zero(di));
  const auto keeps = keepsOrientation ? isAbove : hn::Not(isAbove);
  const auto exits = hn::IfThenElse(keeps, signs.Exits, signs.Entries);
  const auto entries = hn::IfThenElse(keeps, signs.Entries, signs.Exits);
  auto bitWhere = [di](hn::Mask<Int> where, int bit)
  { return hn::IfThenElseZero(where, hn::Set(di, bit)); };
  const auto isEntered = hn::Ne(hn::And(entries, open), hn::Zero(di));
  const auto isUnsure = hn::Or(hn::Ne(hn::Or(exits, entries), allFaces),
    hn::Ne(hn::And(steps, hn::Set(di, TileMesh::Folded)), hn::Zero(di)));
  return hn::Or(hn::Or(hn::AndNot(open, exits), bitWhere(isEntered, TileCells::Entered)),
    hn::Or(bitWhere(isUnsure, TileCells::Unsure), bitWhere(isOutside, TileCells::Exact)));
}

void ProjectLanes(const TileRecords& records, const MeshGroup& cells, int lane,
  const TileView& view, ProjectedGroup& out)
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
  hn::Store(BoxesOf(low, high, view), di, out.Boxes + lane);
  const hn::Vec<Float> areas[4] = { AreaOf(v[1], v[2], v[3]), AreaOf(v[0], v[2], v[3]),
    AreaOf(v[0], v[1], v[3]), AreaOf(v[0], v[1], v[2]) };
  const FaceSigns signs(areas, TurningArea(low, high));
  // A corner has no place on the screen.
  const auto isOutside =
    hn::RebindMask(di, hn::Ge(high[0], hn::Set(d, TileVertices::OffScreen)));
  const auto faces = FacesOf(signs, cells, lane, view.KeepsOrientation, isOutside);
  const hn::Rebind<std::uint8_t, Int> bytes;
  hn::StoreU(hn::DemoteTo(bytes, faces), bytes, out.Faces + lane);
  const auto thin = hn::IfThenZeroElse(isOutside, signs.Thin);
  hn::Store(thin, di, out.Thin + lane);
  out.AnyThin = out.AnyThin || !hn::AllTrue(di, hn::Eq(thin, hn::Zero(di)));
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
  const MeshGroup meshGroup(mesh, first, count);
  ProjectedGroup group;
  for (int lane = 0; lane < TileRecords::Count; lane += static_cast<int>(hn::Lanes(Float())))
  {
    ProjectLanes(records, meshGroup, lane, view, group);
  }
  std::copy_n(group.Faces, count, &cells.Faces[first]);
  std::copy_n(group.Boxes, count, &cells.Boxes[first]);
  for (int k = 0; group.AnyThin && k < count; ++k)
  {
    if (group.Thin[k] != 0 && TileSliver::MeetsPixel(mesh, view, vertices, first + k))
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
  auto tile = [](int pixel, int shift) { return static_cast<std::uint32_t>(pixel) >> shift; };
  this->Boxes[cell] = tile(box[0], TileSize::Shift) | tile(box[2], TileSize::Shift) << 8 |
    tile(box[1], view.RowShift) << 16 | tile(box[3], view.RowShift) << 24;
}
#endif
