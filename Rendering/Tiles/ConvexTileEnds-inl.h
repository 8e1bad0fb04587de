/**
 * Where rays enter and leave a convex cell: its faces over a box of pixels, and what decides at each end.
 */
#if defined(ConvexTileEnds_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef ConvexTileEnds_inl_h
#undef ConvexTileEnds_inl_h
#else
#define ConvexTileEnds_inl_h
#endif

#include "ConvexTileFaces.h"
#include "ConvexTileMesh.h"
#include "ConvexTileTask.h"
#include "TileBlocks-inl.h"
#include "TileTask.h"
#include "TileView.h"

#include <hwy/highway.h>

#include <algorithm>
#include <array>

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

  int GetWidth() const { return this->LastX - this->FirstX + 1; }
  int GetHeight() const { return this->LastY - this->FirstY + 1; }

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

/// The faces of a cell. Of a mixed face, which rays enter through one triangle and leave through the
/// other, both are planes of their own; where their edge is a valley of the cell they are a pair:
/// inside either is inside.
struct CellFaces
{
  static constexpr int Most = 32;
  /// Where rays enter, and where they leave.
  CellFace Ends[2][Most];
  int Counts[2] = { 0, 0 };
  CellFace Valleys[Most][2];
  int Pairs = 0;

  CellFaces(const ConvexTileTask& task, int cell, const CellBox& box)
  {
    const ConvexCellFaces::Rows& rows = task.Mesh->Faces;
    for (int at = rows.Offsets[cell]; at < rows.Offsets[cell + 1]; ++at)
    {
      const ConvexTileFace& face = task.Faces->Values[rows.Values[at]];
      // Turned to the eye and out of the cell: rays enter.
      const bool isTurned = (face.Side > 0.0f) == task.Common.View->KeepsOrientation;
      const bool isEntry = isTurned == (task.Mesh->Sides[at] < 0);
      if (face.IsMixed != 0.0f)
      {
        this->AddMixed(task, at, CellFace(face, box), isEntry);
      }
      else
      {
        // No branch: it would be guessed wrong every other time.
        const int end = isEntry ? 0 : 1;
        this->Ends[end][this->Counts[end]++] = CellFace(face, box);
      }
    }
  }

private:
  void AddMixed(const ConvexTileTask& task, int at, const CellFace& face, bool isEntry)
  {
    const int id = task.Mesh->Faces.Values[at];
    const bool isValley = task.Mesh->Pieces->Planes[id].IsRaised != (task.Mesh->Sides[at] > 0);
    for (int end = 0; end < 2; ++end)
    {
      const CellFace triangle = face.Triangle(isEntry != (end == 0));
      (isValley ? this->Valleys[this->Pairs][end] : this->Ends[end][this->Counts[end]]) = triangle;
      this->Counts[end] += isValley ? 0 : 1;
    }
    this->Pairs += isValley ? 1 : 0;
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
    const auto beyond = hn::Max(LinearAt(f.GA, f.GB, f.GP, x, y), hn::Zero(d));
    const auto u = hn::MulAdd(hn::Set(d, f.UFold), beyond, LinearAt(f.UA, f.UB, f.UP, x, y));
    const auto s = hn::MulAdd(hn::Set(d, f.SFold), beyond, LinearAt(f.SA, f.SB, f.SP, x, y));
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
}
}
HWY_AFTER_NAMESPACE();

#endif
