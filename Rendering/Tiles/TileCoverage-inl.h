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

#include "TileBox.h"
#include "TileCells.h"
#include "TileExactCell.h"
#include "TileFragments.h"
#include "TileGroup.h"
#include "TileMath-inl.h"
#include "TileMesh.h"
#include "TileTask.h"
#include "TileView.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

using CoverFloat = hn::CappedTag<float, 16>;
using CoverInt = hn::RebindToSigned<CoverFloat>;
using CoverVector = hn::Vec<CoverFloat>;

/// The shapes that a vector of pixels can take: rows of all lanes, of half of them, and so on.
class BlockShapes
{
public:
  BlockShapes()
  {
    const int lanes = static_cast<int>(hn::Lanes(CoverFloat()));
    for (int width = lanes; width >= 1; width /= 2)
    {
      Shape& shape = this->Shapes[this->Count++];
      shape.Width = width;
      shape.Height = lanes / width;
      for (int k = 0; k < lanes; ++k)
      {
        shape.X[k] = static_cast<float>(k % width);
        shape.Y[k] = static_cast<float>(k / width);
        shape.Pixel[k] = k / width * TileSize::Pixels + k % width;
      }
    }
    for (int width = 0; width <= TileSize::Pixels; ++width)
    {
      for (int height = 0; height <= TileSize::Pixels; ++height)
      {
        this->Best[width][height] = static_cast<unsigned char>(this->Find(width, height));
      }
    }
  }

  struct Shape
  {
    HWY_ALIGN float X[16];
    HWY_ALIGN float Y[16];
    HWY_ALIGN int Pixel[16];
    int Width, Height;
  };

  /// The one that covers a box with the fewest blocks.
  const Shape& Choose(int width, int height) const
  {
    return this->Shapes[this->Best[width][height]];
  }

private:
  int Find(int width, int height) const
  {
    int best = 0, fewest = 1 << 30;
    for (int i = 0; i < this->Count; ++i)
    {
      const Shape& shape = this->Shapes[i];
      // Sizes are powers of two: the shift is their place in the list.
      const int down = this->Count - 1 - i;
      const int blocks = ((width + shape.Width - 1) >> down) * ((height + shape.Height - 1) >> i);
      best = blocks < fewest ? i : best;
      fewest = std::min(blocks, fewest);
    }
    return best;
  }

  Shape Shapes[5];
  unsigned char Best[TileSize::Pixels + 1][TileSize::Pixels + 1];
  int Count = 0;
};

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
  const CoverInt di;
  hn::StoreU(hn::Compress(entry, covered), d, out.Entry + at);
  hn::StoreU(hn::Compress(hn::Sub(entry, exit), covered), d, out.Extent + at);
  hn::StoreU(hn::Compress(scalarIn, covered), d, out.ScalarIn + at);
  hn::StoreU(hn::Compress(scalarOut, covered), d, out.ScalarOut + at);
  hn::StoreU(hn::Compress(pixel, hn::RebindMask(di, covered)), di, out.Pixel + at);
  return at + static_cast<int>(hn::CountTrue(d, covered));
}

/// What is linear over the pixels of a block, and its steps to the next block.
struct BlockWalk
{
  CoverVector Row, StepX, StepY;

  HWY_INLINE void Begin(
    float a, float b, float p, CoverVector x, CoverVector y, const BlockShapes::Shape& shape)
  {
    const CoverFloat d;
    this->Row = hn::MulAdd(hn::Set(d, a), x, hn::MulAdd(hn::Set(d, b), y, hn::Set(d, p)));
    this->StepX = hn::Set(d, a * static_cast<float>(shape.Width));
    this->StepY = hn::Set(d, b * static_cast<float>(shape.Height));
  }
};

/// Between the `Entries` entry planes and the others, and the cuts: the last entry, and the first
/// exit.
template <int Entries, int Lines>
HWY_INLINE void FindInside(const CoverVector (&at)[Lines], CoverVector& entry, CoverVector& exit)
{
  entry = at[0];
  exit = at[Entries];
  for (int f = 1; f < Entries; ++f)
  {
    entry = hn::Min(entry, at[f]);
  }
  for (int f = Entries + 1; f < 4; ++f)
  {
    exit = hn::Max(exit, at[f]);
  }
  if (Lines > 5)
  {
    entry = hn::Min(entry, at[Lines - 2]);
    exit = hn::Max(exit, at[Lines - 1]);
  }
}

/// One cell of a group: `faces` has the `Entries` entry faces first.
template <int Entries, bool IsCut>
void CoverCell(
  const TileGroup& g, int k, const int* faces, const BlockShapes::Shape& shape, TileFragments& out)
{
  const CoverFloat d;
  const CoverInt di;
  const auto x = hn::Load(d, shape.X), y = hn::Load(d, shape.Y);
  constexpr int lines = IsCut ? 7 : 5;
  BlockWalk walks[lines];
  for (int f = 0; f < 4; ++f)
  {
    walks[f].Begin(g.A[faces[f]][k], g.B[faces[f]][k], g.P[faces[f]][k], x, y, shape);
  }
  walks[4].Begin(g.ScalarA[k], g.ScalarB[k], g.ScalarP[k], x, y, shape);
  for (int f = 5; f < lines; ++f)
  {
    const int cut = f - 5 + TileGroup::CutEntry;
    walks[f].Begin(g.A[cut][k], g.B[cut][k], g.P[cut][k], x, y, shape);
  }
  const auto perU = hn::Set(d, g.ScalarU[k]);
  const int width = g.Width[k], height = g.Height[k];
  const auto right = hn::Set(d, static_cast<float>(width));
  const auto across = hn::Set(d, static_cast<float>(shape.Width));
  const auto pixels = hn::Load(di, shape.Pixel);
  // A copy: the compiler must take it that every store may change the count.
  int count = out.Count;
  for (int top = 0; top < height; top += shape.Height)
  {
    CoverVector at[lines];
    for (int f = 0; f < lines; ++f)
    {
      at[f] = walks[f].Row;
      walks[f].Row = hn::Add(walks[f].Row, walks[f].StepY);
    }
    auto column = x;
    auto pixel = hn::Add(pixels, hn::Set(di, (g.Bottom[k] + top) * TileSize::Pixels + g.Left[k]));
    const auto inRows = hn::Lt(y, hn::Set(d, static_cast<float>(height - top)));
    for (int left = 0; left < width; left += shape.Width)
    {
      CoverVector entry, exit;
      FindInside<Entries, lines>(at, entry, exit);
      const auto inBox = hn::And(inRows, hn::Lt(column, right));
      // Appended where none is covered, too: a branch that is guessed wrong costs more.
      count = AppendFragments(hn::And(inBox, hn::Lt(exit, entry)), entry, exit,
        hn::MulAdd(perU, entry, at[4]), hn::MulAdd(perU, exit, at[4]), pixel, count, out);
      column = hn::Add(column, across);
      pixel = hn::Add(pixel, hn::Set(di, shape.Width));
      for (int f = 0; f < lines; ++f)
      {
        at[f] = hn::Add(at[f], walks[f].StepX);
      }
    }
  }
  out.Count = count;
}

using ExactFloat = hn::CappedTag<double, 8>;
using ExactVector = hn::Vec<ExactFloat>;

/// Entry and exit of pixels in a row in double, and the mask of those that are covered.
inline hn::Mask<ExactFloat> CoverExactLanes(const TileExactCell& cell, const TileView& view,
  ExactVector x, double y, ExactVector& entry, ExactVector& exit)
{
  const ExactFloat d;
  entry = hn::Set(d, view.NearU);
  exit = hn::Set(d, view.FarU);
  for (const TileExactCell::Plane& plane : cell.Planes)
  {
    auto value = hn::MulAdd(hn::Set(d, plane.A), x, hn::Set(d, plane.B * y + plane.E));
    const auto within = hn::Le(hn::Abs(value), hn::Set(d, plane.Tolerance));
    // A plane that is not seen edge-on has no tolerance, and passes at u = 0 where its value is 0.
    const auto nudged = hn::Set(d, plane.Tolerance > 0.0 ? plane.Nudge : 0.0);
    value = hn::Mul(hn::IfThenElse(within, nudged, value), hn::Set(d, plane.Inverse));
    entry = plane.IsEntry ? hn::Min(entry, value) : entry;
    exit = plane.IsEntry ? exit : hn::Max(exit, value);
  }
  return hn::Lt(exit, entry);
}

/// Appends the lanes of `covered`; `pixel` is that of the first lane.
inline void AppendExactLanes(hn::Mask<ExactFloat> covered, ExactVector entry, ExactVector exit,
  ExactVector scalarIn, ExactVector scalarOut, int pixel, TileFragments& out)
{
  const ExactFloat d;
  const hn::Rebind<float, ExactFloat> df;
  const hn::Rebind<std::int32_t, ExactFloat> di;
  const int at = out.Count;
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, covered, bits);
  const auto kept = hn::LoadMaskBits(df, bits);
  auto store = [&](ExactVector value, float* to)
  { hn::StoreU(hn::Compress(hn::DemoteTo(df, value), kept), df, to + at); };
  store(entry, out.Entry);
  store(hn::Sub(entry, exit), out.Extent);
  store(scalarIn, out.ScalarIn);
  store(scalarOut, out.ScalarOut);
  const auto pixels = hn::Compress(Ramp(di, pixel), hn::RebindMask(di, kept));
  hn::StoreU(pixels, di, out.Pixel + at);
  out.Count = at + static_cast<int>(hn::CountTrue(d, covered));
}

/// The same of a tetrahedron.
inline void AppendExact(const TileExactCell& cell, hn::Mask<ExactFloat> covered, ExactVector x,
  double y, ExactVector entry, ExactVector exit, int pixel, TileFragments& out)
{
  const ExactFloat d;
  const auto perU = hn::Set(d, cell.ScalarC);
  const auto scalar = hn::MulAdd(
    hn::Set(d, cell.ScalarA), x, hn::Set(d, cell.ScalarB * y + cell.ScalarE));
  AppendExactLanes(covered, entry, exit, hn::MulAdd(perU, entry, scalar),
    hn::MulAdd(perU, exit, scalar), pixel, out);
}

/// A cell in double: see class TileExactCell.
inline void CoverExactCell(
  const TileTask& task, const TileRectangle& tile, int id, TileFragments& out)
{
  const TileExactCell cell(*task.Mesh, *task.View, id);
  const ExactFloat d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int firstX = std::max(cell.Box[0], tile.FirstX), lastX = std::min(cell.Box[2], tile.LastX);
  const int firstY = std::max(cell.Box[1], tile.FirstY), lastY = std::min(cell.Box[3], tile.LastY);
  out.CountLanes(lastX - firstX + 1, lastY - firstY + 1, lanes, 1);
  for (int y = firstY; y <= lastY; ++y)
  {
    for (int left = firstX; left <= lastX; left += lanes)
    {
      const auto x = Ramp(d, static_cast<double>(left));
      ExactVector entry, exit;
      const auto inRow = hn::FirstN(d, static_cast<std::size_t>(lastX - left + 1));
      const auto covered =
        hn::And(inRow, CoverExactLanes(cell, *task.View, x, y, entry, exit));
      if (!hn::AllFalse(d, covered))
      {
        const int pixel = (y - tile.Bottom) * TileSize::Pixels + left - tile.Left;
        AppendExact(cell, covered, x, y, entry, exit, pixel, out);
      }
    }
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

/// The same, with or without the cuts.
template <int Entries>
HWY_INLINE void CoverCell(const TileGroup& g, int k, const int* faces,
  const BlockShapes::Shape& shape, TileFragments& out)
{
  if (g.Cut[k] != 0)
  {
    CoverCell<Entries, true>(g, k, faces, shape, out);
  }
  else
  {
    CoverCell<Entries, false>(g, k, faces, shape, out);
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
