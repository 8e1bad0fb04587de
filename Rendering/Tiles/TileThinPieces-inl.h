/**
 * The colours of thin fragments that lie in one piece of the transfer function: most of them, where
 * the function is smooth.
 *
 * Then nothing is looked up or cut, and the moments of the absorbed light are short polynomials of
 * the optical depth and its change.
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

/// One piece of the transfer function.
class ThinPiece
{
public:
  explicit ThinPiece(const TileTransfer& transfer)
    : Transfer(transfer)
  {
    this->Take(0);
  }

  /// Colours a vector of fragments unless one of them is not thin or leaves the piece.
  HWY_INLINE bool Color(const ShadeCourse& course, ShadeVector (&color)[4]) const
  {
    const ShadeFloat d;
    const auto first = course.First, last = course.Last, length = course.Length;
    const auto rise = hn::Sub(last, first);
    const auto perScalar = this->HalfSlope;
    const auto middle = hn::MulAdd(perScalar, hn::Add(first, last), this->Offset);
    const auto depth = hn::Mul(middle, length);
    const auto below = hn::Sub(this->Low, hn::Min(first, last));
    const auto above = hn::Sub(hn::Max(first, last), this->High);
    // The depth last: where a scalar is not a number neither is it.
    const auto beyond =
      hn::Max(hn::Max(below, above), hn::Sub(depth, hn::Set(d, DeepestThin)));
    if (!hn::AllTrue(d, hn::Le(beyond, hn::Zero(d))))
    {
      return false;
    }
    const auto bend = hn::Mul(hn::Mul(perScalar, length), rise);
    const ThinAbsorption<ShadeVector> absorbed(d, hn::Max(depth, hn::Zero(d)), bend);
    const auto moment = hn::MulAdd(absorbed.Moment, rise, hn::Mul(absorbed.Alpha, first));
    for (int k = 0; k < 3; ++k)
    {
      color[k] = hn::MulAdd(this->ColorSlopes[k], moment,
        hn::Mul(this->ColorOffsets[k], absorbed.Alpha));
    }
    color[3] = hn::Neg(absorbed.Alpha);
    return true;
  }

  /// Goes over to the piece of a scalar; says whether it is another one.
  bool TakePieceOf(float scalar)
  {
    const int piece = FindPiece(this->Transfer, scalar);
    const bool isOther = piece != this->Piece;
    this->Take(piece);
    return isOther;
  }

private:
  void Take(int piece)
  {
    const ShadeFloat d;
    const TileTransfer& t = this->Transfer;
    this->Piece = piece;
    this->Low = hn::Set(d, t.Bounds[piece]);
    this->High = hn::Set(d, t.Bounds[piece + 1]);
    this->HalfSlope = hn::Set(d, 0.5f * t.Slopes[3][piece]);
    this->Offset = hn::Set(d, t.Offsets[3][piece]);
    for (int k = 0; k < 3; ++k)
    {
      this->ColorSlopes[k] = hn::Set(d, t.Slopes[k][piece]);
      this->ColorOffsets[k] = hn::Set(d, t.Offsets[k][piece]);
    }
  }

  const TileTransfer& Transfer;
  int Piece = 0;
  // Vectors: to spread a number takes an instruction each time where registers are few.
  ShadeVector Low, High;
  // Of extinction over the scalar.
  ShadeVector HalfSlope, Offset;
  ShadeVector ColorSlopes[3], ColorOffsets[3];
};
}
}
HWY_AFTER_NAMESPACE();

#endif
