/**
 * The pixels of a tile that a cell covers, row by row, and where their rays enter and leave it.
 *
 * A ray is inside between its last entry (the least u of the entry planes) and its first exit.
 */
#if defined(TileCoverage_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileCoverage_inl_h
#undef TileCoverage_inl_h
#else
#define TileCoverage_inl_h
#endif

#include "TileBlocks-inl.h"
#include "TileBox.h"
#include "TileCells.h"
#include "TileExactCoverage-inl.h"
#include "TileFragments.h"
#include "TileGroup.h"
#include "TilePixels-inl.h"
#include "TileTask.h"

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Faces with the entries first, for each of the 16 sets of entry faces.
struct FaceLists
{
  FaceLists()
  {
    for (int set = 0; set < 16; ++set)
    {
      int count = 0;
      for (const int wanted : { 1, 0 })
      {
        for (int f = 0; f < 4; ++f)
        {
          if ((set >> f & 1) == wanted)
          {
            this->Faces[set][count++] = f;
          }
        }
        this->Entries[set] = wanted == 1 ? count : this->Entries[set];
      }
    }
  }
  int Faces[16][4];
  int Entries[16] = {};
};

/// The pixel of the tile's where the box of a cell begins.
HWY_INLINE int CornerPixel(const TileGroup& g, int k)
{
  return g.Bottom[k] * TileSize::Pixels + g.Left[k];
}

/// The pixels of a row from its 17th on.
HWY_NOINLINE inline void StoreLongRow(int start, int length, int* at)
{
  const CoverInt di;
  for (int i = 16; i < length; i += static_cast<int>(hn::Lanes(di)))
  {
    hn::StoreU(hn::Iota(di, start + i), di, at + i);
  }
}

/// Puts the pixels of a cell at the end of the queue; returns how many it has then.
HWY_INLINE int AppendSpans(const TileGroup& g, int k, TileFragments& out)
{
  const CoverInt di;
  int count = out.Count;
  for (int begin = 0; begin < g.Height[k]; begin += TileGroup::RowStep)
  {
    for (int row = begin; row < begin + TileGroup::RowStep; ++row)
    {
      int* at = out.Pixel + count;
      const int length = g.SpanCount[row][k];
      // Most rows are that short: nothing to guess.
      const auto start = hn::Set(di, g.SpanStart[row][k]);
      for (int i = 0; i < 16; i += static_cast<int>(hn::Lanes(di)))
      {
        hn::StoreU(hn::Add(start, hn::Iota(di, i)), di, at + i);
      }
      if (HWY_UNLIKELY(length > 16))
      {
        StoreLongRow(g.SpanStart[row][k], length, at);
      }
      count += length;
    }
  }
  return count;
}

/// Between the entry planes and the others, of which the last two may be cuts: the last entry, and the first exit.
template <int Entries, int Planes>
HWY_INLINE void FindInside(const CoverVector (&u)[Planes], CoverVector& entry, CoverVector& exit)
{
  entry = u[0];
  exit = u[Entries];
  for (int f = 1; f < Entries; ++f)
  {
    entry = hn::Min(entry, u[f]);
  }
  for (int f = Entries + 1; f < 4; ++f)
  {
    exit = hn::Max(exit, u[f]);
  }
  if (Planes > 4)
  {
    entry = hn::Min(entry, u[Planes - 2]);
    exit = hn::Max(exit, u[Planes - 1]);
  }
}

/// What is linear over the pixels of a cell.
struct CoverLine
{
  CoverVector A, B, P;

  HWY_INLINE void Take(float a, float b, float p)
  {
    const CoverFloat d;
    this->A = hn::Set(d, a);
    this->B = hn::Set(d, b);
    this->P = hn::Set(d, p);
  }
  HWY_INLINE CoverVector At(const PixelPlaces& places) const
  {
    return hn::MulAdd(this->A, places.X, hn::MulAdd(this->B, places.Y, this->P));
  }
};

/// The planes of a cell, and its scalar.
template <int Entries, int Planes>
struct CoverLines
{
  CoverLine Plane[Planes], Scalar;
  CoverVector ScalarU;

  /// `faces` has the entries first.
  HWY_INLINE CoverLines(const TileGroup& g, int k, const int* faces)
    : ScalarU(hn::Set(CoverFloat(), g.ScalarU[k]))
  {
    for (int i = 0; i < Planes; ++i)
    {
      const int plane = i < 4 ? faces[i] : i - 4 + TileGroup::CutEntry;
      this->Plane[i].Take(g.A[plane][k], g.B[plane][k], g.P[plane][k]);
    }
    this->Scalar.Take(g.ScalarA[k], g.ScalarB[k], g.ScalarP[k]);
  }
};

/// The rest of the fragments from `begin` to `end`, whose pixels there are.
template <int Entries, int Planes>
HWY_INLINE void CompleteFragments(
  const TileGroup& g, int k, const int* faces, int begin, int end, TileFragments& out)
{
  const CoverFloat d;
  const CoverInt di;
  const int corner = CornerPixel(g, k);
  const CoverLines<Entries, Planes> lines(g, k, faces);
  for (int at = begin; at < end; at += static_cast<int>(hn::Lanes(d)))
  {
    const PixelPlaces places(hn::LoadU(di, out.Pixel + at), corner);
    CoverVector u[Planes], entry, exit;
    for (int i = 0; i < Planes; ++i)
    {
      u[i] = lines.Plane[i].At(places);
    }
    FindInside<Entries, Planes>(u, entry, exit);
    // The ends of a row are rounded otherwise.
    const auto extent = hn::Max(hn::Sub(entry, exit), hn::Zero(d));
    const auto scalar = hn::MulAdd(lines.ScalarU, entry, lines.Scalar.At(places));
    hn::StoreU(entry, d, out.Entry + at);
    hn::StoreU(extent, d, out.Extent + at);
    hn::StoreU(scalar, d, out.ScalarIn + at);
    hn::StoreU(hn::NegMulAdd(lines.ScalarU, extent, scalar), d, out.ScalarOut + at);
  }
}

/// Where in the tile a cell of a group lies.
inline std::uint32_t PackBox(const TileGroup& group, int k)
{
  const bool isEmpty = group.Width[k] <= 0 || group.Height[k] <= 0;
  return isEmpty
    ? 0
    : TileBox::Pack(group.Left[k], group.Bottom[k], group.Width[k], group.Height[k]);
}

/// One cell of a group: `faces` has the `Entries` entry faces first.
template <int Entries>
HWY_INLINE void CoverCell(const TileGroup& g, int k, const int* faces, TileFragments& out)
{
  const int begin = out.Count;
  out.Count = AppendSpans(g, k, out);
  out.CountLanes(out.Count - begin, 1, static_cast<int>(hn::Lanes(CoverFloat())), 1);
  g.Cut[k] != 0 ? CompleteFragments<Entries, 6>(g, k, faces, begin, out.Count, out)
                : CompleteFragments<Entries, 4>(g, k, faces, begin, out.Count, out);
}

/// Cells of a group from k on until the queue is full or the group ends; returns the next cell.
inline int CoverGroup(const TileTask& task, const TileRectangle& tile, const TileGroup& group,
  const int* ids, int k, int count, std::uint32_t* boxes, TileFragments& out)
{
  static const FaceLists lists;
  for (; k < count && out.Count < TileFragments::Full; ++k)
  {
    out.BeginCell(ids[k]);
    if (group.Exact[k] != 0)
    {
      // It finds its box itself.
      boxes[k] = TileBox::WholeTile();
      CoverExactCell(task, tile, ids[k], out);
      continue;
    }
    boxes[k] = PackBox(group, k);
    if (group.Width[k] <= 0 || group.Height[k] <= 0)
    {
      continue;
    }
    const int set = group.Entries[k];
    switch (lists.Entries[set])
    {
      case 1:
        CoverCell<1>(group, k, lists.Faces[set], out);
        break;
      case 2:
        CoverCell<2>(group, k, lists.Faces[set], out);
        break;
      case 3:
        CoverCell<3>(group, k, lists.Faces[set], out);
        break;
      default:
        // Flattened by rounding: it has no inside.
        break;
    }
  }
  return k;
}
}
}
HWY_AFTER_NAMESPACE();

#endif
