/**
 * Blocks of pixels, one vector each, and what is linear over them.
 */
#if defined(TileBlocks_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileBlocks_inl_h
#undef TileBlocks_inl_h
#else
#define TileBlocks_inl_h
#endif

#include "TileCells.h"

#include <hwy/highway.h>

#include <algorithm>

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

/// Which lanes of its blocks lie in a box of pixels.
class BlockBox
{
public:
  HWY_INLINE BlockBox(const BlockShapes::Shape& shape, int width, int height)
    : LastLeft((width - 1) / shape.Width * shape.Width)
    , InLast(hn::Lt(hn::Load(CoverFloat(), shape.X),
        hn::Set(CoverFloat(), static_cast<float>(width - this->LastLeft))))
    , Height(height)
    , Y(hn::Load(CoverFloat(), shape.Y))
  {
  }
  HWY_INLINE hn::Mask<CoverFloat> InRows(int top) const
  {
    return hn::Lt(this->Y, hn::Set(CoverFloat(), static_cast<float>(this->Height - top)));
  }

  /// Where the last column of blocks begins.
  const int LastLeft;
  /// Which lanes of its blocks lie in the box.
  const hn::Mask<CoverFloat> InLast;

private:
  const int Height;
  const CoverVector Y;
};

HWY_INLINE CoverVector LinearAt(float a, float b, float p, CoverVector x, CoverVector y)
{
  const CoverFloat d;
  return hn::MulAdd(hn::Set(d, a), x, hn::MulAdd(hn::Set(d, b), y, hn::Set(d, p)));
}

/// What is linear over the pixels of a block, and its steps to the next block.
struct BlockWalk
{
  CoverVector Row, StepX, StepY;

  HWY_INLINE void Begin(
    float a, float b, float p, CoverVector x, CoverVector y, const BlockShapes::Shape& shape)
  {
    const CoverFloat d;
    this->Row = LinearAt(a, b, p, x, y);
    this->StepX = hn::Set(d, a * static_cast<float>(shape.Width));
    this->StepY = hn::Set(d, b * static_cast<float>(shape.Height));
  }
};

/// Several of them.
template <int Lines>
struct BlockWalks
{
  BlockWalk Line[Lines];

  /// At the first block of a row; the next call is at the next row's.
  HWY_INLINE void BeginRow(CoverVector (&at)[Lines])
  {
    for (int f = 0; f < Lines; ++f)
    {
      at[f] = this->Line[f].Row;
      this->Line[f].Row = hn::Add(this->Line[f].Row, this->Line[f].StepY);
    }
  }
  HWY_INLINE void Step(CoverVector (&at)[Lines]) const
  {
    for (int f = 0; f < Lines; ++f)
    {
      at[f] = hn::Add(at[f], this->Line[f].StepX);
    }
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
}
}
HWY_AFTER_NAMESPACE();

#endif
