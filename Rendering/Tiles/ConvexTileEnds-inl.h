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

using LaneDouble = hn::CappedTag<double, 8>;
using LaneVector = hn::Vec<LaneDouble>;
using LaneMask = hn::Mask<LaneDouble>;

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
template <class Number>
struct CellFace
{
  Number UP, UA, UB, UFold;
  Number SP, SA, SB, SFold;
  Number GP, GA, GB;

  CellFace() = default;
  CellFace(const ConvexTileFaceOf<Number>& f, const CellBox& box)
    : UA(f.UA)
    , UB(f.UB)
    , UFold(f.CU)
    , SA(f.SA)
    , SB(f.SB)
    , SFold(f.CS)
    , GA(f.GX)
    , GB(f.GY)
  {
    const Number dx = static_cast<Number>(box.FirstX) - f.X;
    const Number dy = static_cast<Number>(box.FirstY) - f.Y;
    this->UP = f.U + f.UA * dx + f.UB * dy;
    this->SP = f.S + f.SA * dx + f.SB * dy;
    this->GP = f.GX * dx + f.GY * dy;
  }

  /// One triangle of a mixed face alone.
  CellFace Triangle(bool other) const
  {
    CellFace alone = *this;
    alone.UFold = alone.SFold = 0;
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
template <class Number>
struct CellFaces
{
  static constexpr int Most = ConvexTileMesh::MostFaces;
  /// Where rays enter, and where they leave.
  CellFace<Number> Ends[2][Most];
  int Counts[2] = { 0, 0 };
  CellFace<Number> Valleys[Most][2];
  int Pairs = 0;

  /// `faceAt`: the face at a place of the mesh's rows.
  template <class FaceAt>
  CellFaces(const ConvexTileTask& task, int cell, const CellBox& box, const FaceAt& faceAt)
  {
    const ConvexCellFaces::Rows& rows = task.Mesh->Faces;
    for (int at = rows.Offsets[cell]; at < rows.Offsets[cell + 1]; ++at)
    {
      const ConvexTileFaceOf<Number>& face = faceAt(at);
      // Turned to the eye and out of the cell: rays enter.
      const bool isTurned = (face.Side > 0) == task.Common.View->KeepsOrientation;
      const bool isEntry = isTurned == (task.Mesh->Sides[at] < 0);
      if (face.IsMixed != 0)
      {
        this->AddMixed(task, at, CellFace<Number>(face, box), isEntry);
      }
      else
      {
        // No branch: it would be guessed wrong every other time.
        const int end = isEntry ? 0 : 1;
        this->Ends[end][this->Counts[end]++] = CellFace<Number>(face, box);
      }
    }
  }

private:
  void AddMixed(const ConvexTileTask& task, int at, const CellFace<Number>& face, bool isEntry)
  {
    const int id = task.Mesh->Faces.Values[at];
    const bool isValley = task.Mesh->Pieces->Planes[id].IsRaised != (task.Mesh->Sides[at] > 0);
    for (int end = 0; end < 2; ++end)
    {
      const CellFace<Number> triangle = face.Triangle(isEntry != (end == 0));
      (isValley ? this->Valleys[this->Pairs][end] : this->Ends[end][this->Counts[end]]) = triangle;
      this->Counts[end] += isValley ? 0 : 1;
    }
    this->Pairs += isValley ? 1 : 0;
  }
};

template <class D>
HWY_INLINE hn::Vec<D> LinearAt(
  D d, hn::TFromD<D> a, hn::TFromD<D> b, hn::TFromD<D> p, hn::Vec<D> x, hn::Vec<D> y)
{
  return hn::MulAdd(hn::Set(d, a), x, hn::MulAdd(hn::Set(d, b), y, hn::Set(d, p)));
}

/// One end of the rays of a block: u and scalar * weight.
template <class D>
struct BlockEnd
{
  using Vector = hn::Vec<D>;
  Vector U, S;

  template <bool IsEntry>
  HWY_INLINE void Add(const CellFace<hn::TFromD<D>>& f, Vector x, Vector y, bool isFirst)
  {
    const D d;
    const auto beyond = hn::Max(LinearAt(d, f.GA, f.GB, f.GP, x, y), hn::Zero(d));
    const auto u = hn::MulAdd(hn::Set(d, f.UFold), beyond, LinearAt(d, f.UA, f.UB, f.UP, x, y));
    const auto s = hn::MulAdd(hn::Set(d, f.SFold), beyond, LinearAt(d, f.SA, f.SB, f.SP, x, y));
    const auto decides = IsEntry ? hn::Lt(u, this->U) : hn::Lt(this->U, u);
    this->S = isFirst ? s : hn::IfThenElse(decides, s, this->S);
    this->U = isFirst ? u : IsEntry ? hn::Min(this->U, u) : hn::Max(this->U, u);
  }
};

/// A ray is inside beyond either plane of a pair: an end that lies in the gap between both moves.
template <class D>
void CutAtValley(const CellFace<hn::TFromD<D>> (&pair)[2], hn::Vec<D> x, hn::Vec<D> y,
  BlockEnd<D>& entry, BlockEnd<D>& exit)
{
  BlockEnd<D> enter, leave;
  enter.template Add<true>(pair[0], x, y, true);
  leave.template Add<false>(pair[1], x, y, true);
  const auto later = hn::And(hn::Lt(entry.U, leave.U), hn::Lt(enter.U, entry.U));
  entry.U = hn::IfThenElse(later, enter.U, entry.U);
  entry.S = hn::IfThenElse(later, enter.S, entry.S);
  const auto sooner = hn::And(hn::Lt(enter.U, exit.U), hn::Lt(exit.U, leave.U));
  exit.U = hn::IfThenElse(sooner, leave.U, exit.U);
  exit.S = hn::IfThenElse(sooner, leave.S, exit.S);
}

/// What decides where rays enter and leave a cell, over its box.
template <class D>
class CellEnds
{
public:
  using Number = hn::TFromD<D>;
  using Vector = hn::Vec<D>;

  /// `faceAt`: as that of class CellFaces.
  template <class FaceAt>
  CellEnds(const ConvexTileTask& task, int cell, const CellBox& box, const FaceAt& faceAt)
    : Faces(task, cell, box, faceAt)
    , HasCellScalar(!task.Mesh->CellScalars.empty())
  {
    if (this->HasCellScalar)
    {
      const Number scalar = task.Mesh->CellScalars[cell];
      this->ScalarScale = scalar * static_cast<Number>(task.Common.View->WeightScale);
      this->ScalarOffset = scalar * static_cast<Number>(task.Common.View->WeightOffset);
    }
  }

  bool AreBoth() const { return this->Faces.Counts[0] > 0 && this->Faces.Counts[1] > 0; }

  /// Of the rays at x, y from the box's corner.
  HWY_INLINE void Find(Vector x, Vector y, BlockEnd<D>& entry, BlockEnd<D>& exit) const
  {
    const CellFaces<Number>& f = this->Faces;
    for (int i = 0; i < f.Counts[0]; ++i)
    {
      entry.template Add<true>(f.Ends[0][i], x, y, i == 0);
    }
    for (int i = 0; i < f.Counts[1]; ++i)
    {
      exit.template Add<false>(f.Ends[1][i], x, y, i == 0);
    }
    // Twice: an end that a later face moves may come to lie in the gap of an earlier one.
    for (int i = 0; i < 2 * f.Pairs; ++i)
    {
      CutAtValley(f.Valleys[i % f.Pairs], x, y, entry, exit);
    }
    if (this->HasCellScalar)
    {
      const D d;
      const auto scale = hn::Set(d, this->ScalarScale), offset = hn::Set(d, this->ScalarOffset);
      entry.S = hn::MulAdd(scale, entry.U, offset);
      exit.S = hn::MulAdd(scale, exit.U, offset);
    }
  }

private:
  const CellFaces<Number> Faces;
  const bool HasCellScalar;
  Number ScalarScale = 0, ScalarOffset = 0;
};
}
}
HWY_AFTER_NAMESPACE();

#endif
