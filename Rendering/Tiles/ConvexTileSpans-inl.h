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
#include "TileVertices.h"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>

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
  EdgeList(const ConvexTileTask& task, int cell, const CellBox& box)
    : Corner{ static_cast<float>(box.FirstX), static_cast<float>(box.FirstY) }
  {
    const ConvexTileMesh& mesh = *task.Mesh;
    const float* const points = task.Common.Vertices->Values.data();
    const int* const ids = mesh.Corners.GetRow(cell);
    const int begin = mesh.Edges.Offsets[cell], end = mesh.Edges.Offsets[cell + 1];
    for (int i = begin; i < end; ++i)
    {
      const std::array<unsigned char, 2>& ends = mesh.Edges.Ends[i];
      this->Add(points + 4 * static_cast<std::size_t>(ids[ends[0]]),
        points + 4 * static_cast<std::size_t>(ids[ends[1]]));
    }
    for (int at = mesh.Faces.Offsets[cell]; at < mesh.Faces.Offsets[cell + 1] && this->Count > 0; ++at)
    {
      const ConvexTileFace& face = task.Faces->Values[mesh.Faces.Values[at]];
      if (face.IsMixed != 0.0f)
      {
        const float end[2] = { face.X + face.IsMixed * face.GY, face.Y - face.IsMixed * face.GX };
        this->Add(&face.X, end);
      }
    }
    this->SetUp();
  }

  bool IsEmpty() const { return this->Count == 0; }

  /// Where the rows `y` leave the first and the last edge.
  HWY_INLINE void FindRange(CoverVector y, CoverVector& least, CoverVector& greatest) const
  {
    const CoverFloat d;
    least = hn::Set(d, TileVertices::OffScreen);
    greatest = hn::Neg(least);
    for (int i = 0; i < this->Count; ++i)
    {
      const auto up = hn::Sub(y, hn::Set(d, this->Y[i]));
      const auto x = hn::MulAdd(hn::Set(d, this->Slope[i]), up, hn::Set(d, this->X[i]));
      const auto isMet =
        hn::And(hn::Ge(up, hn::Zero(d)), hn::Le(up, hn::Set(d, this->EndY[i])));
      least = hn::IfThenElse(isMet, hn::Min(least, x), least);
      greatest = hn::IfThenElse(isMet, hn::Max(greatest, x), greatest);
    }
  }

private:
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

  HWY_INLINE void Add(const float* a, const float* b)
  {
    this->X[this->Count] = a[0];
    this->Y[this->Count] = a[1];
    this->EndX[this->Count] = b[0];
    this->EndY[this->Count] = b[1];
    ++this->Count;
  }

  static constexpr int Most = ConvexTileMesh::MostEdges + CellFaces::Most;
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

  RowSpans(const EdgeList& edges, const CellBox& box)
  {
    const CoverFloat d;
    const CoverInt di;
    const auto width = hn::Set(d, static_cast<float>(box.GetWidth()));
    const auto margin = hn::Set(d, Margin);
    for (int row = 0; row < box.GetHeight(); row += static_cast<int>(hn::Lanes(d)))
    {
      CoverVector least, greatest;
      edges.FindRange(Ramp(d, static_cast<float>(row)), least, greatest);
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
}
}
HWY_AFTER_NAMESPACE();

#endif
