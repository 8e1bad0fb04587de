/**
 * For each row of pixels the first and the last one that a convex cell may cover: those between its
 * edges on the screen, and a little more, so that rounding leaves out none.
 */
#if defined(ConvexTileSpans_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef ConvexTileSpans_inl_h
#undef ConvexTileSpans_inl_h
#else
#define ConvexTileSpans_inl_h
#endif

#include "ConvexTileEnds-inl.h"
#include "ConvexTileMesh.h"
#include "ConvexTileTask.h"
#include "TileBlocks-inl.h"
#include "TileExactCoverage-inl.h"
#include "TileFragments.h"
#include "TileVertices.h"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// The edges of a cell in pixels from the corner of a box; of mixed faces the diagonals, too.
class EdgeList
{
public:
  /// `faceAt`: as that of class CellFaces.
  template <class FaceAt>
  EdgeList(const ConvexTileTask& task, int cell, const CellBox& box, const FaceAt& faceAt)
    : Corner{ static_cast<float>(box.FirstX), static_cast<float>(box.FirstY) }
  {
    const ConvexTileMesh& mesh = *task.Mesh;
    const float* const points = task.Common.Vertices->Values.data();
    const int* const ids = mesh.Corners.GetRow(cell);
    const int begin = mesh.Edges.Offsets[cell], end = mesh.Edges.Offsets[cell + 1];
    for (int i = begin; i < end; ++i)
    {
      const std::array<unsigned char, 2>& ends = mesh.Edges.Ends[i];
      const float* const a = points + 4 * static_cast<std::size_t>(ids[ends[0]]);
      const float* const b = points + 4 * static_cast<std::size_t>(ids[ends[1]]);
      this->Add(a[0], a[1], b[0], b[1]);
    }
    for (int at = mesh.Faces.Offsets[cell]; at < mesh.Faces.Offsets[cell + 1] && this->Count > 0; ++at)
    {
      const auto& face = faceAt(at);
      if (face.IsMixed != 0)
      {
        this->Add(face.X, face.Y, face.X + face.IsMixed * face.GY, face.Y - face.IsMixed * face.GX);
      }
    }
    this->SetUp();
  }

  bool IsEmpty() const { return this->Count == 0; }

  /// In pixels: by how much the edges, in floats, may lie off the planes of a cell in double.
  static constexpr float Slack = 1e-3f;

  /// Where the rows `y` leave the first and the last edge; `IsLoose`: or those up to Slack beside them.
  template <bool IsLoose>
  HWY_INLINE void FindRange(CoverVector y, CoverVector& least, CoverVector& greatest) const
  {
    const CoverFloat d;
    const auto slack = hn::Set(d, Slack), zero = hn::Zero(d);
    least = hn::Set(d, TileVertices::OffScreen);
    greatest = hn::Neg(least);
    for (int i = 0; i < this->Count; ++i)
    {
      const auto up = hn::Sub(y, hn::Set(d, this->Y[i])), end = hn::Set(d, this->EndY[i]);
      const auto first = IsLoose ? hn::Max(hn::Sub(up, slack), zero) : up;
      const auto last = IsLoose ? hn::Min(hn::Add(up, slack), end) : up;
      const auto x = this->At(i, first), other = IsLoose ? this->At(i, last) : x;
      const auto isMet = IsLoose ? hn::Le(first, last) : hn::And(hn::Ge(up, zero), hn::Le(up, end));
      least = hn::IfThenElse(isMet, hn::Min(least, hn::Min(x, other)), least);
      greatest = hn::IfThenElse(isMet, hn::Max(greatest, hn::Max(x, other)), greatest);
    }
  }

private:
  HWY_INLINE CoverVector At(int edge, CoverVector up) const
  {
    const CoverFloat d;
    return hn::MulAdd(hn::Set(d, this->Slope[edge]), up, hn::Set(d, this->X[edge]));
  }

  /// What rows need.
  void SetUp()
  {
    const CoverFloat d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const auto cornerX = hn::Set(d, this->Corner[0]), cornerY = hn::Set(d, this->Corner[1]);
    for (int at = 0; at < this->Count; at += lanes)
    {
      const auto x = hn::Load(d, this->X + at), endX = hn::Load(d, this->EndX + at);
      const auto y = hn::Load(d, this->Y + at), endY = hn::Load(d, this->EndY + at);
      const auto rise = hn::Abs(hn::Sub(endY, y));
      // A level edge ends where others do: no row needs it.
      const auto length =
        hn::IfThenElse(hn::Gt(rise, hn::Zero(d)), rise, hn::Set(d, -1.0f));
      const auto isTurned = hn::Lt(endY, y);
      hn::Store(hn::Div(hn::Sub(endX, x), hn::Sub(endY, y)), d, this->Slope + at);
      hn::Store(hn::Sub(hn::IfThenElse(isTurned, endX, x), cornerX), d, this->X + at);
      hn::Store(hn::Sub(hn::Min(y, endY), cornerY), d, this->Y + at);
      hn::Store(length, d, this->EndY + at);
    }
  }

  template <class Number>
  HWY_INLINE void Add(Number x, Number y, Number endX, Number endY)
  {
    this->X[this->Count] = static_cast<float>(x);
    this->Y[this->Count] = static_cast<float>(y);
    this->EndX[this->Count] = static_cast<float>(endX);
    this->EndY[this->Count] = static_cast<float>(endY);
    ++this->Count;
  }

  static constexpr int Most = ConvexTileMesh::MostEdges + ConvexTileMesh::MostFaces;
  const float Corner[2];
  int Count = 0;
  // In the end the lower end, and in EndY how much higher the upper one is.
  HWY_ALIGN float X[Most], Y[Most], EndX[Most], EndY[Most], Slope[Most];
};

/// The rows of a box.
struct RowSpans
{
  /// From the corner of the box; none where the last comes before the first.
  HWY_ALIGN int First[TileSize::Pixels + 16];
  HWY_ALIGN int Last[TileSize::Pixels + 16];

  /// In pixels: more than the rounding of edges and of planes.
  static constexpr float Margin = 1.0f / 64.0f;

  /// `isLoose`: for planes in double.
  RowSpans(const EdgeList& edges, const CellBox& box, bool isLoose)
  {
    const CoverFloat d;
    const CoverInt di;
    const auto width = hn::Set(d, static_cast<float>(box.GetWidth()));
    const auto margin = hn::Set(d, Margin);
    for (int row = 0; row < box.GetHeight(); row += static_cast<int>(hn::Lanes(d)))
    {
      CoverVector least, greatest;
      const auto y = Ramp(d, static_cast<float>(row));
      isLoose ? edges.FindRange<true>(y, least, greatest) : edges.FindRange<false>(y, least, greatest);
      const auto first = hn::Min(hn::Max(hn::Sub(least, margin), hn::Zero(d)), width);
      const auto last = hn::Min(hn::Add(greatest, margin), hn::Sub(width, hn::Set(d, 1.0f)));
      if (edges.IsEmpty())
      {
        hn::Store(hn::Zero(di), di, this->First + row);
        hn::Store(hn::Set(di, box.GetWidth() - 1), di, this->Last + row);
        continue;
      }
      hn::Store(hn::ConvertTo(di, hn::Ceil(first)), di, this->First + row);
      hn::Store(
        hn::ConvertTo(di, hn::Floor(hn::Max(last, hn::Set(d, -1.0f)))), di, this->Last + row);
    }
  }
};

/// The pixel of the tile's where a box begins.
inline int CornerPixel(const CellBox& box, const TileRectangle& tile)
{
  return (box.FirstY - tile.Bottom) * TileSize::Pixels + box.FirstX - tile.Left;
}

/// Puts the pixels of all rows at the end of the queue; returns how many it has then.
inline int AppendSpans(const RowSpans& spans, int height, int corner, TileFragments& out)
{
  const CoverInt di;
  int count = out.Count;
  for (int row = 0; row < height; ++row)
  {
    const int first = spans.First[row], size = spans.Last[row] - first + 1;
    const int pixel = corner + row * TileSize::Pixels + first;
    for (int k = 0; k < size; k += static_cast<int>(hn::Lanes(di)))
    {
      hn::StoreU(Ramp(di, pixel + k), di, out.Pixel + count + k);
    }
    count += std::max(size, 0);
  }
  return count;
}

/// Floats as they are, and of doubles.
HWY_INLINE CoverVector ToFloats(CoverVector values) { return values; }
HWY_INLINE auto ToFloats(LaneVector values)
{
  return hn::DemoteTo(hn::Rebind<float, LaneDouble>(), values);
}
HWY_INLINE CoverVector FromIntegers(CoverFloat d, hn::Vec<CoverInt> values)
{
  return hn::ConvertTo(d, values);
}
HWY_INLINE LaneVector FromIntegers(
  LaneDouble d, hn::Vec<hn::Rebind<std::int32_t, LaneDouble>> values)
{
  return hn::PromoteTo(d, values);
}

/// A full vector of fragments.
template <class D>
HWY_INLINE void StoreFragments(const BlockEnd<D>& entry, const BlockEnd<D>& exit,
  hn::Vec<hn::Rebind<std::int32_t, D>> pixel, int at, TileFragments& out)
{
  const hn::Rebind<float, D> d;
  hn::StoreU(ToFloats(entry.U), d, out.Entry + at);
  hn::StoreU(ToFloats(hn::Sub(entry.U, exit.U)), d, out.Extent + at);
  hn::StoreU(ToFloats(entry.S), d, out.ScalarIn + at);
  hn::StoreU(ToFloats(exit.S), d, out.ScalarOut + at);
  hn::StoreU(pixel, hn::Rebind<std::int32_t, D>(), out.Pixel + at);
}

/// The pixels between a cell's edges first, then the rest of their fragments in full vectors.
template <class D>
void CoverSpans(
  const CellEnds<D>& ends, const RowSpans& spans, int height, int corner, TileFragments& out)
{
  const D d;
  const hn::Rebind<std::int32_t, D> di;
  const int end = AppendSpans(spans, height, corner, out), lanes = static_cast<int>(hn::Lanes(d));
  int count = out.Count;
  for (int at = count; at < end; at += lanes)
  {
    const auto pixel = hn::LoadU(di, out.Pixel + at), place = hn::Sub(pixel, hn::Set(di, corner));
    BlockEnd<D> entry, exit;
    ends.Find(FromIntegers(d, hn::And(place, hn::Set(di, TileSize::Pixels - 1))),
      FromIntegers(d, hn::ShiftRight<TileSize::Shift>(place)), entry, exit);
    const auto used = hn::FirstN(d, static_cast<std::size_t>(end - at));
    const auto covered = hn::And(used, hn::Lt(exit.U, entry.U));
    // No more than were read: a place that is written to was read before.
    if (hn::AllTrue(d, covered))
    {
      StoreFragments(entry, exit, pixel, count, out);
      count += lanes;
    }
    else
    {
      count = AppendFragments(covered, entry.U, exit.U, entry.S, exit.S, pixel, count, out);
    }
  }
  out.Count = count;
}
}
}
HWY_AFTER_NAMESPACE();

#endif
