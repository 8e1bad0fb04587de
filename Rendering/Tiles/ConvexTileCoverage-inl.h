/**
 * Which pixels of a tile a convex cell covers, where their rays enter and leave it, and the scalar
 * there.
 *
 * A ray is inside between its last entry (the least u of the faces towards the eye) and its first
 * exit; the scalar at either is that of the face which decides.
 */
#if defined(ConvexTileCoverage_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef ConvexTileCoverage_inl_h
#undef ConvexTileCoverage_inl_h
#else
#define ConvexTileCoverage_inl_h
#endif

#include "ConvexTileCells.h"
#include "ConvexTileExactCell.h"
#include "ConvexTileFaces.h"
#include "ConvexTileLanes-inl.h"
#include "ConvexTileMesh.h"
#include "ConvexTileRays.h"
#include "ConvexTileTask.h"
#include "TileCoverage-inl.h"
#include "TileLimits.h"

#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// The part of a cell's box that lies in a tile, in pixels of the viewport.
struct CellBox
{
  int FirstX, FirstY, LastX, LastY;

  CellBox(const std::array<short, 4>& box, const TileRectangle& tile)
    : FirstX(std::max<int>(box[0], tile.FirstX))
    , FirstY(std::max<int>(box[1], tile.FirstY))
    , LastX(std::min<int>(box[2], tile.LastX))
    , LastY(std::min<int>(box[3], tile.LastY))
  {
  }
  explicit CellBox(const TileRectangle& tile)
    : FirstX(tile.FirstX)
    , FirstY(tile.FirstY)
    , LastX(tile.LastX)
    , LastY(tile.LastY)
  {
  }
};

/// Whether opaque geometry and clipping planes leave nothing of a cell in a box.
inline bool IsCutOff(const ConvexTileTask& task, int cell, const CellBox& box)
{
  const ConvexTileCells::Depths& depths = task.Cells->Ranges[cell];
  const int first[2] = { box.FirstX, box.FirstY }, last[2] = { box.LastX, box.LastY };
  return task.LeavesOut &&
         task.Common.Limits->CutsOff(first, last, depths.Farthest, depths.Nearest);
}

/// A face over a box: u, s and g are P + A x + B y, x and y from the box's corner.
struct CellFace
{
  float UP, UA, UB, UFold;
  float SP, SA, SB, SFold;
  float GP, GA, GB;

  CellFace() = default;
  CellFace(const ConvexTileFace& f, const CellBox& box)
    : UA(f.UA)
    , UB(f.UB)
    , UFold(f.CU)
    , SA(f.SA)
    , SB(f.SB)
    , SFold(f.CS)
    , GA(f.GX)
    , GB(f.GY)
  {
    const float dx = static_cast<float>(box.FirstX) - f.X;
    const float dy = static_cast<float>(box.FirstY) - f.Y;
    this->UP = f.U + f.UA * dx + f.UB * dy;
    this->SP = f.S + f.SA * dx + f.SB * dy;
    this->GP = f.GX * dx + f.GY * dy;
  }

  /// One triangle of a mixed face alone.
  CellFace Triangle(bool other) const
  {
    CellFace alone = *this;
    alone.UFold = alone.SFold = 0.0f;
    if (other)
    {
      alone.UP += this->UFold * this->GP;
      alone.UA += this->UFold * this->GA;
      alone.UB += this->UFold * this->GB;
      alone.SP += this->SFold * this->GP;
      alone.SA += this->SFold * this->GA;
      alone.SB += this->SFold * this->GB;
    }
    return alone;
  }
};

/// The faces of a cell, those where rays enter first. Of a mixed face, which rays enter through one
/// triangle and leave through the other, both are planes of their own; where their edge is a valley
/// of the cell they are a pair: inside either is inside.
struct CellFaces
{
  static constexpr int Most = 32;
  CellFace Faces[2 * Most];
  CellFace Valleys[Most][2];
  int Entries = 0, Count = 0, Pairs = 0;

  CellFaces(const ConvexTileTask& task, int cell, const CellBox& box)
  {
    const ConvexCellFaces::Rows& rows = task.Mesh->Faces;
    for (const bool wantsEntry : { true, false })
    {
      for (int at = rows.Offsets[cell]; at < rows.Offsets[cell + 1]; ++at)
      {
        const ConvexTileFace& face = task.Faces->Values[rows.Values[at]];
        // Turned to the eye and out of the cell: rays enter.
        const bool isTurned = (face.Side > 0.0f) == task.Common.View->KeepsOrientation;
        const bool isEntry = isTurned == (task.Mesh->Sides[at] < 0);
        if (face.IsMixed != 0.0f)
        {
          this->AddMixed(task, at, CellFace(face, box), isEntry, wantsEntry);
        }
        else if (isEntry == wantsEntry)
        {
          this->Faces[this->Count++] = CellFace(face, box);
        }
      }
      this->Entries = wantsEntry ? this->Count : this->Entries;
    }
  }

private:
  void AddMixed(
    const ConvexTileTask& task, int at, const CellFace& face, bool isEntry, bool wantsEntry)
  {
    const int id = task.Mesh->Faces.Values[at];
    const bool isValley = task.Mesh->Pieces->Planes[id].IsRaised != (task.Mesh->Sides[at] > 0);
    if (!isValley)
    {
      this->Faces[this->Count++] = face.Triangle(isEntry != wantsEntry);
    }
    else if (wantsEntry)
    {
      this->Valleys[this->Pairs][0] = face.Triangle(!isEntry);
      this->Valleys[this->Pairs][1] = face.Triangle(isEntry);
      ++this->Pairs;
    }
  }
};

/// One end of the rays of a block: u and scalar * weight.
struct BlockEnd
{
  CoverVector U, S;

  template <bool IsEntry>
  HWY_INLINE void Add(const CellFace& f, CoverVector x, CoverVector y, bool isFirst)
  {
    const CoverFloat d;
    auto at = [&](float p, float a, float b)
    { return hn::MulAdd(hn::Set(d, a), x, hn::MulAdd(hn::Set(d, b), y, hn::Set(d, p))); };
    const auto beyond = hn::Max(at(f.GP, f.GA, f.GB), hn::Zero(d));
    const auto u = hn::MulAdd(hn::Set(d, f.UFold), beyond, at(f.UP, f.UA, f.UB));
    const auto s = hn::MulAdd(hn::Set(d, f.SFold), beyond, at(f.SP, f.SA, f.SB));
    const auto decides = IsEntry ? hn::Lt(u, this->U) : hn::Lt(this->U, u);
    this->S = isFirst ? s : hn::IfThenElse(decides, s, this->S);
    this->U = isFirst ? u : IsEntry ? hn::Min(this->U, u) : hn::Max(this->U, u);
  }
};

/// A ray is inside beyond either plane of a pair: an end that lies in the gap between both moves.
inline void CutAtValley(
  const CellFace (&pair)[2], CoverVector x, CoverVector y, BlockEnd& entry, BlockEnd& exit)
{
  BlockEnd enter, leave;
  enter.Add<true>(pair[0], x, y, true);
  leave.Add<false>(pair[1], x, y, true);
  const auto later = hn::And(hn::Lt(entry.U, leave.U), hn::Lt(enter.U, entry.U));
  entry.U = hn::IfThenElse(later, enter.U, entry.U);
  entry.S = hn::IfThenElse(later, enter.S, entry.S);
  const auto sooner = hn::And(hn::Lt(enter.U, exit.U), hn::Lt(exit.U, leave.U));
  exit.U = hn::IfThenElse(sooner, leave.U, exit.U);
  exit.S = hn::IfThenElse(sooner, leave.S, exit.S);
}

/// A cell that floats serve.
inline void CoverConvexCell(const ConvexTileTask& task, const TileRectangle& tile, int cell,
  const CellBox& box, const BlockShapes& shapes, TileFragments& out)
{
  const CoverFloat d;
  const CoverInt di;
  const CellFaces cover(task, cell, box);
  if (cover.Entries == 0 || cover.Entries == cover.Count)
  {
    return;
  }
  const int width = box.LastX - box.FirstX + 1, height = box.LastY - box.FirstY + 1;
  const BlockShapes::Shape& shape = shapes.Choose(width, height);
  const auto columns = hn::Load(d, shape.X), rows = hn::Load(d, shape.Y);
  const auto pixels = hn::Load(di, shape.Pixel);
  const bool hasCellScalar = !task.Mesh->CellScalars.empty();
  const auto cellScalar = hn::Set(d, hasCellScalar ? task.Mesh->CellScalars[cell] : 0.0f);
  const auto scale = hn::Mul(cellScalar, hn::Set(d, float(task.Common.View->WeightScale)));
  const auto offset = hn::Mul(cellScalar, hn::Set(d, float(task.Common.View->WeightOffset)));
  int count = out.Count;
  for (int top = 0; top < height; top += shape.Height)
  {
    const auto y = hn::Add(rows, hn::Set(d, static_cast<float>(top)));
    for (int left = 0; left < width; left += shape.Width)
    {
      const auto x = hn::Add(columns, hn::Set(d, static_cast<float>(left)));
      BlockEnd entry, exit;
      for (int i = 0; i < cover.Entries; ++i)
      {
        entry.Add<true>(cover.Faces[i], x, y, i == 0);
      }
      for (int i = cover.Entries; i < cover.Count; ++i)
      {
        exit.Add<false>(cover.Faces[i], x, y, i == cover.Entries);
      }
      // Twice: an end that a later face moves may come to lie in the gap of an earlier one.
      for (int i = 0; i < 2 * cover.Pairs; ++i)
      {
        CutAtValley(cover.Valleys[i % cover.Pairs], x, y, entry, exit);
      }
      const auto inBox = hn::And(hn::Lt(x, hn::Set(d, static_cast<float>(width))),
        hn::Lt(y, hn::Set(d, static_cast<float>(height))));
      const auto covered = hn::And(inBox, hn::Lt(exit.U, entry.U));
      if (hn::AllFalse(d, covered))
      {
        continue;
      }
      if (hasCellScalar)
      {
        entry.S = hn::MulAdd(scale, entry.U, offset);
        exit.S = hn::MulAdd(scale, exit.U, offset);
      }
      const int corner = (box.FirstY - tile.Bottom + top) * TileSize::Pixels + box.FirstX -
                         tile.Left + left;
      count = AppendFragments(covered, entry.U, exit.U, entry.S, exit.S,
        hn::Add(pixels, hn::Set(di, corner)), count, out);
    }
  }
  out.Count = count;
}

/// Appends a segment in parts over which the weight falls to a share of no less than LeastShare:
/// beside a great weight a float does not keep the digits of a small one.
inline void AppendSegment(const TileView& view, double reference,
  const ConvexTileExactCell::Segment& segment, int pixel, TileFragments& out)
{
  double entry = view.ScreenDepth(reference + segment.Entry);
  const double exit = view.ScreenDepth(reference + segment.Exit);
  auto weightAt = [&](double u) { return view.WeightScale * u + view.WeightOffset; };
  const double last = weightAt(exit), scalarOut = segment.ScalarOut * last;
  double weight = weightAt(entry), scalar = segment.ScalarIn * weight;
  for (int part = 0; part < ConvexTileCells::MostParts && entry > exit; ++part)
  {
    const bool isLast =
      last >= ConvexTileCells::LeastShare * weight || part + 1 == ConvexTileCells::MostParts;
    const double share =
      isLast ? 1.0 : (1.0 - ConvexTileCells::LeastShare) * weight / (weight - last);
    const int at = out.Count++;
    out.Entry[at] = static_cast<float>(entry);
    out.Extent[at] = static_cast<float>(share * (entry - exit));
    out.ScalarIn[at] = static_cast<float>(scalar);
    scalar += share * (scalarOut - scalar);
    out.ScalarOut[at] = static_cast<float>(scalar);
    out.Pixel[at] = pixel;
    entry = isLast ? exit : entry - share * (entry - exit);
    weight = weightAt(entry);
  }
}

/// u of depths before the eye.
HWY_INLINE LaneVector ScreenDepthOf(const TileView::DepthToScreen& map, LaneVector depth)
{
  const LaneDouble d;
  const auto linear = hn::MulAdd(hn::Set(d, map.Terms[1]), depth, hn::Set(d, map.Terms[0]));
  const auto one = hn::Set(d, 1.0);
  return map.InPerspective ? hn::Add(hn::Div(one, linear), hn::Set(d, map.Terms[2])) : linear;
}

/// The segments of `which` lanes in one part each; `pixel` is that of the first lane. Returns the
/// lanes that need more parts.
inline LaneMask AppendLanes(const ConvexTileTask& task, const LanePassage& rays, LaneMask which,
  int pixel, TileFragments& out)
{
  const LaneDouble d;
  const TileView& view = *task.Common.View;
  const TileView::DepthToScreen map = view.GetDepthToScreen();
  const auto reference = hn::Set(d, task.Rays->Reference);
  const auto entry = ScreenDepthOf(map, hn::Add(reference, rays.Entry));
  const auto exit = ScreenDepthOf(map, hn::Add(reference, rays.Exit));
  const auto scale = hn::Set(d, view.WeightScale), offset = hn::Set(d, view.WeightOffset);
  const auto first = hn::MulAdd(scale, entry, offset), last = hn::MulAdd(scale, exit, offset);
  const auto isOne = hn::Ge(last, hn::Mul(hn::Set(d, ConvexTileCells::LeastShare), first));
  const auto kept = hn::And(which, hn::And(isOne, hn::Lt(exit, entry)));
  AppendExactLanes(kept, entry, exit, hn::Mul(rays.ScalarIn, first),
    hn::Mul(rays.ScalarOut, last), pixel, out);
  return hn::AndNot(isOne, which);
}

/// The rays of a row from column `left` on, `count` of them at most.
inline void CoverLanes(const ConvexTileTask& task, const TileRectangle& tile,
  const ConvexTileExactCell& cell, int left, int y, int count, TileFragments& out)
{
  const LaneDouble d;
  const LanePassage rays(cell, *task.Rays, Ramp(d, static_cast<double>(left)), y);
  const auto used = hn::FirstN(d, static_cast<std::size_t>(count));
  const int pixel = (y - tile.Bottom) * TileSize::Pixels + left - tile.Left;
  const auto tidy = hn::And(used, hn::AndNot(rays.Odd, rays.Covered));
  auto others = hn::And(used, rays.Odd);
  if (!hn::AllFalse(d, tidy))
  {
    others = hn::Or(others, AppendLanes(task, rays, tidy, pixel, out));
  }
  if (hn::AllFalse(d, others))
  {
    return;
  }
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, others, bits);
  for (int k = 0; k < static_cast<int>(hn::Lanes(d)); ++k)
  {
    ConvexTileExactCell::Segment segment;
    if ((bits[0] >> k & 1) != 0 && cell.Cross(*task.Rays, left + k, y, segment))
    {
      AppendSegment(*task.Common.View, task.Rays->Reference, segment, pixel + k, out);
    }
  }
}

/// A cell in double; hands on the queue whenever it is full.
template <class Flush>
void CoverExactConvexCell(const ConvexTileTask& task, const TileRectangle& tile, int id,
  const CellBox& box, ConvexTileExactCell& cell, TileFragments& out, const Flush& flush)
{
  cell.SetUp(*task.Mesh, id);
  const int lanes = static_cast<int>(hn::Lanes(LaneDouble()));
  for (int y = box.FirstY; y <= box.LastY; ++y)
  {
    for (int x = box.FirstX; x <= box.LastX; x += lanes)
    {
      CoverLanes(task, tile, cell, x, y, std::min(lanes, box.LastX - x + 1), out);
    }
    if (out.Count >= TileFragments::Full)
    {
      flush();
    }
  }
}

/// Appends what a cell covers of a tile; `flush` empties the queue.
template <class Flush>
void CoverAnyConvexCell(const ConvexTileTask& task, const TileRectangle& tile, int cell,
  const BlockShapes& shapes, ConvexTileExactCell& exact, TileFragments& out, const Flush& flush)
{
  const CellBox box(task.Cells->Boxes[cell], tile);
  if (box.LastX < box.FirstX || box.LastY < box.FirstY)
  {
    return;
  }
  if (task.Cells->Exact[cell] || task.Mesh->Faces.GetSize(cell) > CellFaces::Most)
  {
    CoverExactConvexCell(task, tile, cell, box, exact, out, flush);
  }
  else
  {
    CoverConvexCell(task, tile, cell, box, shapes, out);
  }
}
}
}
HWY_AFTER_NAMESPACE();

#endif
