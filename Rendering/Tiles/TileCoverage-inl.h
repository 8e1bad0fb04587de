/**
 * Which pixels of a tile a cell covers, and where their rays enter and leave it.
 *
 * A ray is inside between its last entry (the least u of the entry planes) and its first exit.
 * Blocks of one vector of pixels; covered ones are compressed into the queue.
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
#include "TilePacking-inl.h"
#include "TilePixels-inl.h"
#include "TileTask.h"

#include <hwy/highway.h>

#include <algorithm>
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

/// Puts the lanes of `covered` at `at`; returns where the next ones go.
HWY_INLINE int AppendFragments(hn::Mask<CoverFloat> covered, CoverVector entry, CoverVector exit,
  CoverVector scalarIn, CoverVector scalarOut, hn::Vec<CoverInt> pixel, int at, TileFragments& out)
{
  const CoverFloat d;
  const LanePacker<CoverFloat> pack(d, covered);
  hn::StoreU(pack(entry), d, out.Entry + at);
  hn::StoreU(pack(hn::Sub(entry, exit)), d, out.Extent + at);
  hn::StoreU(pack(scalarIn), d, out.ScalarIn + at);
  hn::StoreU(pack(scalarOut), d, out.ScalarOut + at);
  hn::StoreU(pack(pixel), CoverInt(), out.Pixel + at);
  return at + static_cast<int>(hn::CountTrue(d, covered));
}

/// The walks over the lines of a cell: its faces in the order of `faces`, then, where wanted, the scalar and the cuts.
template <int Lines>
HWY_INLINE void BeginWalks(
  const TileGroup& g, int k, const int* faces, const BlockShapes::Shape& shape, BlockWalks<Lines>& walks)
{
  const CoverFloat d;
  const auto x = hn::Load(d, shape.X), y = hn::Load(d, shape.Y);
  for (int f = 0; f < 4; ++f)
  {
    walks.Line[f].Begin(g.A[faces[f]][k], g.B[faces[f]][k], g.P[faces[f]][k], x, y, shape);
  }
  if constexpr (Lines > 4)
  {
    walks.Line[4].Begin(g.ScalarA[k], g.ScalarB[k], g.ScalarP[k], x, y, shape);
  }
  for (int f = 5; f < Lines; ++f)
  {
    const int cut = f - 5 + TileGroup::CutEntry;
    walks.Line[f].Begin(g.A[cut][k], g.B[cut][k], g.P[cut][k], x, y, shape);
  }
}

/// The pixel of the tile's where the box of a cell begins.
HWY_INLINE int CornerPixel(const TileGroup& g, int k)
{
  return g.Bottom[k] * TileSize::Pixels + g.Left[k];
}

/// All of a fragment at once.
template <int Entries, bool IsCut>
void CoverAtOnce(
  const TileGroup& g, int k, const int* faces, const BlockShapes::Shape& shape, TileFragments& out)
{
  const CoverFloat d;
  const CoverInt di;
  constexpr int lines = IsCut ? 7 : 5;
  BlockWalks<lines> walks;
  BeginWalks(g, k, faces, shape, walks);
  const auto perU = hn::Set(d, g.ScalarU[k]);
  const BlockBox box(shape, g.Width[k], g.Height[k]);
  auto row = hn::Add(hn::Load(di, shape.Pixel), hn::Set(di, CornerPixel(g, k)));
  // A copy: the compiler must take it that every store may change the count.
  int count = out.Count;
  for (int top = 0; top < g.Height[k]; top += shape.Height)
  {
    CoverVector at[lines];
    walks.BeginRow(at);
    const auto inRows = box.InRows(top);
    auto pixel = row;
    row = hn::Add(row, hn::Set(di, shape.Height * TileSize::Pixels));
    for (int left = 0; left <= box.LastLeft; left += shape.Width)
    {
      CoverVector entry, exit;
      FindInside<Entries, lines>(at, entry, exit);
      // Appended where none is covered, too: a branch that is guessed wrong costs more.
      const auto within = left < box.LastLeft ? inRows : hn::And(inRows, box.InLast);
      count = AppendFragments(hn::And(within, hn::Lt(exit, entry)), entry, exit,
        hn::MulAdd(perU, entry, at[4]), hn::MulAdd(perU, exit, at[4]), pixel, count, out);
      pixel = hn::Add(pixel, hn::Set(di, shape.Width));
      walks.Step(at);
    }
  }
  out.Count = count;
}

/// Puts the pixels of the covered lanes alone at `at`; returns where the next ones go.
HWY_INLINE int AppendPixels(
  hn::Mask<CoverFloat> covered, hn::Vec<CoverInt> pixel, int at, TileFragments& out)
{
  const CoverFloat d;
  hn::StoreU(LanePacker<CoverFloat>(d, covered)(pixel), CoverInt(), out.Pixel + at);
  return at + static_cast<int>(hn::CountTrue(d, covered));
}

/// Puts the pixels of a block that lie between the planes at the end of the queue; returns how many it has then.
template <int Entries>
HWY_INLINE int AppendPixels(hn::Mask<CoverFloat> within, const CoverVector (&at)[4], hn::Vec<CoverInt> pixel,
  int count, TileFragments& out)
{
  CoverVector entry, exit;
  FindInside<Entries, 4>(at, entry, exit);
  return AppendPixels(hn::And(within, hn::Lt(exit, entry)), pixel, count, out);
}

/// The same of a cell.
template <int Entries>
HWY_INLINE int AppendPixels(const TileGroup& g, int k, const int* faces,
  const BlockShapes::Shape& shape, TileFragments& out)
{
  const CoverInt di;
  BlockWalks<4> walks;
  BeginWalks(g, k, faces, shape, walks);
  const BlockBox box(shape, g.Width[k], g.Height[k]);
  auto row = hn::Add(hn::Load(di, shape.Pixel), hn::Set(di, CornerPixel(g, k)));
  int count = out.Count;
  for (int top = 0; top < g.Height[k]; top += shape.Height)
  {
    CoverVector at[4];
    walks.BeginRow(at);
    const auto inRows = box.InRows(top);
    auto pixel = row;
    row = hn::Add(row, hn::Set(di, shape.Height * TileSize::Pixels));
    for (int left = 0; left < box.LastLeft; left += shape.Width)
    {
      count = AppendPixels<Entries>(inRows, at, pixel, count, out);
      pixel = hn::Add(pixel, hn::Set(di, shape.Width));
      walks.Step(at);
    }
    count = AppendPixels<Entries>(hn::And(inRows, box.InLast), at, pixel, count, out);
  }
  return count;
}

/// The rest of the fragments from `begin` to `end`, whose pixels there are.
template <int Entries>
HWY_INLINE void CompleteFragments(
  const TileGroup& g, int k, const int* faces, int begin, int end, TileFragments& out)
{
  const CoverFloat d;
  const CoverInt di;
  const int corner = CornerPixel(g, k);
  const auto perU = hn::Set(d, g.ScalarU[k]);
  for (int at = begin; at < end; at += static_cast<int>(hn::Lanes(d)))
  {
    const PixelPlaces places(hn::LoadU(di, out.Pixel + at), corner);
    const auto x = places.X, y = places.Y;
    CoverVector u[4], entry, exit;
    for (int f = 0; f < 4; ++f)
    {
      u[f] = LinearAt(g.A[faces[f]][k], g.B[faces[f]][k], g.P[faces[f]][k], x, y);
    }
    FindInside<Entries, 4>(u, entry, exit);
    // Rounded otherwise than what found the pixel.
    const auto extent = hn::Max(hn::Sub(entry, exit), hn::Zero(d));
    const auto scalar =
      hn::MulAdd(perU, entry, LinearAt(g.ScalarA[k], g.ScalarB[k], g.ScalarP[k], x, y));
    hn::StoreU(entry, d, out.Entry + at);
    hn::StoreU(extent, d, out.Extent + at);
    hn::StoreU(scalar, d, out.ScalarIn + at);
    hn::StoreU(hn::NegMulAdd(perU, extent, scalar), d, out.ScalarOut + at);
  }
}

/// From two blocks on it takes less to pack one vector a block and to do the rest of full vectors than to pack five.
template <int Entries>
void CoverInTwoSteps(
  const TileGroup& g, int k, const int* faces, const BlockShapes::Shape& shape, TileFragments& out)
{
  const int begin = out.Count;
  out.Count = AppendPixels<Entries>(g, k, faces, shape, out);
  CompleteFragments<Entries>(g, k, faces, begin, out.Count, out);
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
HWY_INLINE void CoverCell(const TileGroup& g, int k, const int* faces,
  const BlockShapes::Shape& shape, TileFragments& out)
{
  if (g.Cut[k] != 0)
  {
    CoverAtOnce<Entries, true>(g, k, faces, shape, out);
  }
  else if (g.Width[k] * g.Height[k] <= static_cast<int>(hn::Lanes(CoverFloat())))
  {
    CoverAtOnce<Entries, false>(g, k, faces, shape, out);
  }
  else
  {
    CoverInTwoSteps<Entries>(g, k, faces, shape, out);
  }
}

/// Cells of a group from k on until the queue is full or the group ends; returns the next cell.
inline int CoverGroup(const TileTask& task, const TileRectangle& tile, const TileGroup& group,
  const int* ids, int k, int count, const BlockShapes& shapes, std::uint32_t* boxes,
  TileFragments& out)
{
  static const FaceLists lists;
  for (; k < count && out.Count < TileFragments::Full; ++k)
  {
    out.BeginCell(ids[k]);
    if (group.Exact[k] != 0 || task.AllExact || (task.Cells->Faces[ids[k]] & TileCells::Exact))
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
    const BlockShapes::Shape& shape = shapes.Choose(group.Width[k], group.Height[k]);
    out.CountLanes(group.Width[k], group.Height[k], shape.Width, shape.Height);
    switch (lists.Entries[set])
    {
      case 1:
        CoverCell<1>(group, k, lists.Faces[set], shape, out);
        break;
      case 2:
        CoverCell<2>(group, k, lists.Faces[set], shape, out);
        break;
      case 3:
        CoverCell<3>(group, k, lists.Faces[set], shape, out);
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
