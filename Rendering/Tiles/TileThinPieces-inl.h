/**
 * The colours of thin fragments that lie in one piece of the transfer function, or two: most of them,
 * where the function is smooth.
 *
 * In one piece nothing is looked up or cut, and the moments of the absorbed light are short polynomials
 * of the optical depth and its change.
 */
#if defined(TileThinPieces_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileThinPieces_inl_h
#undef TileThinPieces_inl_h
#else
#define TileThinPieces_inl_h
#endif

#include "TileMath-inl.h"
#include "TilePieces-inl.h"
#include "TileTransfer.h"

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// A vector of fragments: scalars at both ends, world length.
struct ShadeCourse
{
  ShadeVector First, Last, Length;
};

/// What fragments that all lie in one piece need of it.
struct ThinLine
{
  const TileTransfer::Line* Piece;

  HWY_INLINE ShadeVector HalfSlope() const { return hn::Set(ShadeFloat(), this->Piece->HalfSlope); }
  HWY_INLINE ShadeVector Offset() const { return hn::Set(ShadeFloat(), this->Piece->Offset); }
  HWY_INLINE ShadeVector ColorSlope(int k) const { return hn::Set(ShadeFloat(), this->Piece->ColorSlopes[k]); }
  HWY_INLINE ShadeVector ColorOffset(int k) const { return hn::Set(ShadeFloat(), this->Piece->ColorOffsets[k]); }

  /// Whether all are thin and lie in the piece.
  HWY_INLINE bool Holds(const ShadeCourse& course, ShadeVector depth) const
  {
    const ShadeFloat d;
    const auto below = hn::Sub(hn::Set(d, this->Piece->Low), hn::Min(course.First, course.Last));
    const auto above = hn::Sub(hn::Max(course.First, course.Last), hn::Set(d, this->Piece->High));
    // The depth apart: it is not a number where a scalar is not, and Max may take the other one then.
    const auto isThin = hn::Le(depth, hn::Set(d, DeepestThin));
    return hn::AllTrue(d, hn::And(hn::Le(hn::Max(below, above), hn::Zero(d)), isThin));
  }
};

/// The same of fragments that lie in a piece each.
template <class LookUp>
struct ThinLines
{
  const LookUp& Values;
  const TileTransfer& Transfer;
  ShadeIndex Piece;

  HWY_INLINE ShadeVector HalfSlope() const
  {
    return hn::Mul(this->Values(this->Transfer.Slopes[3].data(), this->Piece), hn::Set(ShadeFloat(), 0.5f));
  }
  HWY_INLINE ShadeVector Offset() const { return this->Values(this->Transfer.Offsets[3].data(), this->Piece); }
  HWY_INLINE ShadeVector ColorSlope(int k) const
  {
    return this->Values(this->Transfer.Slopes[k].data(), this->Piece);
  }
  HWY_INLINE ShadeVector ColorOffset(int k) const
  {
    return this->Values(this->Transfer.Offsets[k].data(), this->Piece);
  }
};

template <class Line>
HWY_INLINE ShadeVector ThinDepth(const Line& line, const ShadeCourse& course)
{
  const auto middle = hn::MulAdd(line.HalfSlope(), hn::Add(course.First, course.Last), line.Offset());
  return hn::Mul(middle, course.Length);
}

/// The colours of fragments that are thin.
template <class Line>
HWY_INLINE void ColorThin(
  const Line& line, const ShadeCourse& course, ShadeVector depth, ShadeVector (&color)[4])
{
  const ShadeFloat d;
  const auto rise = hn::Sub(course.Last, course.First);
  const auto bend = hn::Mul(hn::Mul(line.HalfSlope(), course.Length), rise);
  const ThinAbsorption<ShadeVector> absorbed(d, hn::Max(depth, hn::Zero(d)), bend);
  const auto moment = hn::MulAdd(absorbed.Moment, rise, hn::Mul(absorbed.Alpha, course.First));
  for (int k = 0; k < 3; ++k)
  {
    color[k] = hn::MulAdd(line.ColorSlope(k), moment, hn::Mul(line.ColorOffset(k), absorbed.Alpha));
  }
  color[3] = hn::Neg(absorbed.Alpha);
}

/// The colours of fragments that lie in a piece each, or in two where a node cuts them.
template <class LookUp>
class ThinParts
{
public:
  ThinParts(const LookUp& values, const TileTransfer& transfer)
    : Values(values)
    , Transfer(transfer)
  {
  }

  /// Returns which fragments have thin parts, two at most; `isCut`: which are cut.
  HWY_INLINE ShadeMask Color(
    const ShadeCourse& course, ShadeMask used, ShadeVector (&color)[4], ShadeMask& isCut) const
  {
    const auto piece = PieceOf(this->Values, this->Transfer, course.First);
    const NodeCut node =
      FindNode(this->Values, this->Transfer, piece, course.First, course.Last, used);
    isCut = node.IsCut;
    if (!node.IsAny)
    {
      return this->ColorPart(piece, course, color);
    }
    const auto end = hn::IfThenElse(node.IsCut, node.Bound, course.Last);
    const auto length = hn::Mul(course.Length, node.Share);
    const auto fits = this->ColorPart(piece, { course.First, end, length }, color);
    const auto beyond = hn::IfThenElse(hn::RebindMask(ShadeInt(), node.IsCut),
      PieceBeyond(piece, course.First, course.Last), piece);
    const ShadeCourse behind{ end, course.Last, hn::Sub(course.Length, length) };
    return hn::And(fits, this->AddPart(beyond, behind, node.IsCut, color));
  }

private:
  HWY_INLINE ShadeMask ColorPart(
    ShadeIndex piece, const ShadeCourse& course, ShadeVector (&color)[4]) const
  {
    const ThinLines<LookUp> lines{ this->Values, this->Transfer, piece };
    const auto depth = ThinDepth(lines, course);
    ColorThin(lines, course, depth, color);
    return hn::Le(depth, hn::Set(ShadeFloat(), DeepestThin));
  }

  /// Lays the second parts of those that are cut behind the first ones; returns which are thin and cut no more.
  HWY_INLINE ShadeMask AddPart(
    ShadeIndex piece, const ShadeCourse& course, ShadeMask isCut, ShadeVector (&color)[4]) const
  {
    ShadeVector second[4];
    const auto isThin = this->ColorPart(piece, course, second);
    const auto again =
      FindNode(this->Values, this->Transfer, piece, course.First, course.Last, isCut).IsCut;
    const auto through = hn::Add(hn::Set(ShadeFloat(), 1.0f), color[3]);
    for (int k = 0; k < 4; ++k)
    {
      color[k] = hn::MulAdd(hn::IfThenElseZero(isCut, second[k]), through, color[k]);
    }
    return hn::Or(hn::AndNot(again, isThin), hn::Not(isCut));
  }

  const LookUp& Values;
  const TileTransfer& Transfer;
};

/// Vectors that go through the steps together: within one the steps wait for each other.
struct ThinBatch
{
  static constexpr int Size = hn::MaxLanes(ShadeFloat()) < 16 ? 16 : 8;

  int Count;
  ShadeCourse Courses[Size];
  ShadeVector Depths[Size];
  ThinLine Lines[Size];
  // A bit for each vector that is not thin, or does not lie in one piece.
  unsigned int Mixed;

  /// The pieces that they lie in, from `line` on, and their depths; returns whether most are thin and lie in one.
  template <class LookUp>
  HWY_INLINE bool FindDepths(const LookUp& values, const TileTransfer& transfer, ThinLine& line)
  {
    unsigned int mixed = 0;
    for (int i = 0; i < this->Count; ++i)
    {
      const ShadeCourse& course = this->Courses[i];
      auto depth = ThinDepth(line, course);
      if (!line.Holds(course, depth))
      {
        line.Piece = &transfer.Lines[hn::GetLane(PieceOf(values, transfer, course.First))];
        depth = ThinDepth(line, course);
        mixed |= (line.Holds(course, depth) ? 0u : 1u) << i;
      }
      this->Depths[i] = depth;
      this->Lines[i] = line;
    }
    this->Mixed = mixed;
    return 2 * hwy::PopCount(mixed) <= static_cast<std::size_t>(this->Count);
  }
};
}
}
HWY_AFTER_NAMESPACE();

#endif
