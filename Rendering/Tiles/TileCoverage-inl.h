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

#include <cstddef>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Faces with the entries first, for each of the 16 sets of entry faces.
struct FaceLists
{
  constexpr FaceLists()
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
  int Faces[16][4] = {};
  int Entries[16] = {};
};
inline constexpr FaceLists TheFaceLists{};

/// The pixel of the tile's where the box of a cell begins.
HWY_INLINE int CornerPixel(const TileGroup& g, int k)
{
  return g.Bottom[k] * TileSize::Pixels + g.Left[k];
}

/// What is stored of a row at a time.
using RowPixels = hn::CappedTag<std::uint16_t, 16>;
constexpr int RowBlock = 16;

/// The first pixels of a row, and what may lie behind it.
HWY_INLINE void StoreRowBlock(std::uint16_t start, std::uint16_t* at)
{
  const RowPixels d;
  const auto first = hn::Set(d, start);
  for (int i = 0; i < RowBlock; i += static_cast<int>(hn::Lanes(d)))
  {
    hn::StoreU(hn::Add(first, hn::Iota(d, static_cast<std::uint16_t>(i))), d, at + i);
  }
}

/// So many rows of a cell that is no wider than a block, or wider, behind `count` pixels of the queue.
template <bool Wide, int Rows>
HWY_INLINE void AppendStep(const std::int32_t*& spans, std::size_t& count, std::uint16_t* pixels)
{
  for (int row = 0; row < Rows; ++row)
  {
    // Two loads: the first one spreads what it loads.
    std::uint16_t halves[2];
    const char* const bytes = reinterpret_cast<const char*>(spans);
    std::memcpy(&halves[0], bytes + 2 * TileGroup::LowerHalf, sizeof halves[0]);
    std::memcpy(&halves[1], bytes + 2 * (1 - TileGroup::LowerHalf), sizeof halves[1]);
    std::uint16_t* at = pixels + count;
    StoreRowBlock(halves[0], at);
    for (int i = RowBlock; Wide && i < halves[1]; i += RowBlock)
    {
      StoreRowBlock(static_cast<std::uint16_t>(halves[0] + i), at + i);
    }
    count += halves[1];
    spans += TileGroup::Size;
  }
}

/// The rows of a cell; returns how many pixels the queue has then.
template <bool Wide>
HWY_INLINE int AppendRows(const std::int32_t* spans, int height, int begin, std::uint16_t* pixels)
{
  auto count = static_cast<std::size_t>(begin);
  AppendStep<Wide, TileGroup::FirstRows>(spans, count, pixels);
  for (int first = TileGroup::FirstRows; first < height; first += TileGroup::RowStep)
  {
    AppendStep<Wide, TileGroup::RowStep>(spans, count, pixels);
  }
  return static_cast<int>(count);
}

/// Puts the pixels of a cell at the end of the queue; returns how many it has then.
HWY_INLINE int AppendSpans(const TileGroup& g, int k, int count, TileFragments& out)
{
  return g.Width[k] <= RowBlock ? AppendRows<false>(&g.Spans[0][k], g.Height[k], count, out.RowPixel)
                                : AppendRows<true>(&g.Spans[0][k], g.Height[k], count, out.RowPixel);
}

/// How many of a cell's faces are entries: a loop for each number, or with 0 one for all.
template <int Entries>
struct CoverEntries
{
  HWY_INLINE explicit CoverEntries(int) {}

  /// Of the planes with the entries first: the last entry, and the first exit.
  HWY_INLINE void Find(const CoverVector* u, CoverVector& entry, CoverVector& exit) const
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
  }
};

/// 1, 2 or 3, as the cell has it: one loop for all, where masks cost less than a branch that nobody can guess.
template <>
struct CoverEntries<0>
{
  hn::Mask<CoverFloat> Second, Third;

  HWY_INLINE explicit CoverEntries(int entries)
    : Second(hn::RebindMask(CoverFloat(), hn::Gt(hn::Set(CoverInt(), entries), hn::Set(CoverInt(), 1))))
    , Third(hn::RebindMask(CoverFloat(), hn::Gt(hn::Set(CoverInt(), entries), hn::Set(CoverInt(), 2))))
  {
  }
  HWY_INLINE void Find(const CoverVector* u, CoverVector& entry, CoverVector& exit) const
  {
    entry = hn::IfThenElse(this->Second, hn::Min(u[0], u[1]), u[0]);
    entry = hn::IfThenElse(this->Third, hn::Min(entry, u[2]), entry);
    exit = hn::IfThenElse(this->Third, u[3], hn::Max(u[3], u[2]));
    exit = hn::IfThenElse(this->Second, exit, hn::Max(exit, u[1]));
  }
};

/// Between the entry planes and the others, of which the last two may be cuts: the last entry, and the first exit.
template <int Entries, int Planes>
HWY_INLINE void FindInside(
  const CoverEntries<Entries>& entries, const CoverVector (&u)[Planes], CoverVector& entry, CoverVector& exit)
{
  entries.Find(u, entry, exit);
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
template <int Planes>
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
HWY_INLINE void CompleteFragments(const TileGroup& g, int k, int begin, int end, TileFragments& out)
{
  const CoverFloat d;
  const CoverInt di;
  const int corner = CornerPixel(g, k);
  const int set = g.Entries[k];
  const CoverLines<Planes> lines(g, k, TheFaceLists.Faces[set]);
  const CoverEntries<Entries> entries(TheFaceLists.Entries[set]);
  for (int at = begin; at < end; at += static_cast<int>(hn::Lanes(d)))
  {
    const auto pixel = hn::PromoteTo(di, hn::LoadU(hn::Rebind<std::uint16_t, CoverInt>(), out.RowPixel + at));
    const PixelPlaces places(pixel, corner);
    hn::StoreU(pixel, di, out.Pixel + at);
    CoverVector u[Planes], entry, exit;
    for (int i = 0; i < Planes; ++i)
    {
      u[i] = lines.Plane[i].At(places);
    }
    FindInside(entries, u, entry, exit);
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

/// The rest of a cell's fragments, of `Entries` entry faces or of any number.
template <int Entries>
HWY_INLINE void CompleteCell(const TileGroup& g, int k, int begin, int end, TileFragments& out)
{
  g.Cut[k] != 0 ? CompleteFragments<Entries, 6>(g, k, begin, end, out)
                : CompleteFragments<Entries, 4>(g, k, begin, end, out);
}

/// Cells of a group in floats, one after the other, whose pixels are found and that wait for the rest.
struct CoverRun
{
  int First, End;
  /// Where the fragments of every cell begin; those of the last one end where the queue does.
  int Begin[TileGroup::Size + 1];
};

/// The rest of a cell's fragments: a loop for each number of entry faces where vectors have four lanes, else one for all.
HWY_INLINE void CompleteByEntries(const TileGroup& g, int k, int begin, int end, TileFragments& out)
{
  if (hn::MaxLanes(CoverFloat()) > 4)
  {
    CompleteCell<0>(g, k, begin, end, out);
    return;
  }
  switch (TheFaceLists.Entries[g.Entries[k]])
  {
    case 1:
      CompleteCell<1>(g, k, begin, end, out);
      break;
    case 2:
      CompleteCell<2>(g, k, begin, end, out);
      break;
    default:
      CompleteCell<3>(g, k, begin, end, out);
      break;
  }
}

/// The rest of the fragments of a run.
inline void CompleteRun(const TileGroup& group, const CoverRun& run, TileFragments& out)
{
  for (int k = run.First; k < run.End; ++k)
  {
    if (run.Begin[k] != run.Begin[k + 1])
    {
      CompleteByEntries(group, k, run.Begin[k], run.Begin[k + 1], out);
    }
  }
}

/// The pixels of cells in floats from k on, until the queue is full, the group ends or one is in double. The rest is
/// done after all of them: reading what was just written waits for it.
inline int CoverRunOfCells(
  const TileGroup& group, const int* ids, int k, int count, std::uint32_t* boxes, TileFragments& out)
{
  CoverRun run;
  run.First = k;
  for (; k < count && out.Count < out.Full && group.Exact[k] == 0; ++k)
  {
    out.BeginCell(ids[k]);
    boxes[k] = PackBox(group, k);
    run.Begin[k] = out.Count;
    // Flattened by rounding a cell has no inside.
    const bool isFlat = group.Entries[k] == 0 || group.Entries[k] == 15;
    if (boxes[k] != 0 && !isFlat)
    {
      out.Count = AppendSpans(group, k, out.Count, out);
      out.CountLanes(out.Count - run.Begin[k], 1, static_cast<int>(hn::Lanes(CoverFloat())), 1);
    }
  }
  run.End = k;
  run.Begin[k] = out.Count;
  CompleteRun(group, run, out);
  return k;
}

/// Cells of a group from k on until the queue is full or the group ends; returns the next cell. `flush` empties the
/// queue.
template <class Flush>
int CoverGroup(const TileTask& task, const TileRectangle& tile, const TileGroup& group,
  const int* ids, int k, int count, std::uint32_t* boxes, TileFragments& out, const Flush& flush)
{
  while (k < count && out.Count < out.Full)
  {
    if (group.Exact[k] == 0)
    {
      k = CoverRunOfCells(group, ids, k, count, boxes, out);
      continue;
    }
    out.BeginCell(ids[k]);
    // It finds its box itself.
    boxes[k] = TileBox::WholeTile();
    CoverExactCell(task, tile, ids[k], out, flush);
    ++k;
  }
  return k;
}
}
}
HWY_AFTER_NAMESPACE();

#endif
