/**
 * Blocks of pixels, one vector each, whose covered lanes are packed.
 */
#if defined(TileBlocks_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileBlocks_inl_h
#undef TileBlocks_inl_h
#else
#define TileBlocks_inl_h
#endif

#include "TileCells.h"
#include "TileFragments.h"
#include "TilePacking-inl.h"

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
}
}
HWY_AFTER_NAMESPACE();

#endif
