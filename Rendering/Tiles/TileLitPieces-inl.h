/**
 * The queue of lit pieces, a full vector at a time.
 */
#if defined(TileLitPieces_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileLitPieces_inl_h
#undef TileLitPieces_inl_h
#else
#define TileLitPieces_inl_h
#endif

#include "TileLitPieces.h"
#include "TileShading-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Pieces about to be shaded, one per lane; see TileLitPieces.
struct LitPieces
{
  ShadeVector First, Last, Length, Through, Depth, DepthRise;
  ShadeVector Gradient[3], GradientRise[3];
  ShadeVector Color[3], ColorRise[3];
  ShadeVector ToEye[3]; // of length 1, as the light's ways
  ShadeIndex Piece, Fragment, Pixel;
};

/// Three nodes from 0 to 1, and from values there the integrals up to each.
struct GaussNodes
{
  static constexpr float Places[3] = { 0.11270167f, 0.5f, 0.88729833f };
  static constexpr float Weights[3] = { 0.27777778f, 0.44444444f, 0.27777778f };
  static constexpr float Running[3][3] = { { 0.13888889f, -0.03597667f, 0.00978944f },
    { 0.30026320f, 0.22222222f, -0.02248542f }, { 0.26798833f, 0.48042111f, 0.13888889f } };
};

/// What of a piece matters.
struct LitNeeds
{
  bool Position, Colors;
};

/// What a piece emits and hides, from its beginning to the share End of what is left.
struct LitPart
{
  ShadeVector End, LastScalar, Length;
  ShadeVector Front, Back; // extinction
  ShadeVector Depth;
  hn::Mask<ShadeFloat> AtNode, Open;
};

/// Of `count` pieces the vector from `at` on.
HWY_INLINE void LoadPieces(const TileLitPieces& from, int at, int count, LitNeeds needs, LitPieces& p)
{
  const ShadeFloat d;
  const ShadeInt di;
  p.First = hn::Load(d, from.First + at);
  p.Last = hn::Load(d, from.Last + at);
  p.Length = hn::Load(d, from.Length + at);
  p.Through = hn::Load(d, from.Through + at);
  if (needs.Position)
  {
    p.Depth = hn::Load(d, from.Depth + at);
    p.DepthRise = hn::Load(d, from.DepthRise + at);
  }
  for (int k = 0; k < 3; ++k)
  {
    p.Gradient[k] = hn::Load(d, from.Gradient[k] + at);
    p.GradientRise[k] = hn::Load(d, from.GradientRise[k] + at);
    if (needs.Colors)
    {
      p.Color[k] = hn::Load(d, from.Color[k] + at);
      p.ColorRise[k] = hn::Load(d, from.ColorRise[k] + at);
    }
  }
  // Beyond the count there is what was there before.
  const auto used = hn::FirstN(di, static_cast<std::size_t>(count - at));
  p.Piece = hn::IfThenElseZero(used, hn::Load(di, from.Piece + at));
  p.Fragment = hn::Load(di, from.Fragment + at);
  p.Pixel = hn::Load(di, from.Pixel + at);
}

/// What is linear along a piece, from its share `end` on.
HWY_INLINE void AppendLinear(const LanePacker<ShadeFloat>& pack, ShadeVector value, ShadeVector rise,
  ShadeVector end, float* values, float* rises)
{
  const ShadeFloat d;
  hn::StoreU(pack(hn::MulAdd(end, rise, value)), d, values);
  hn::StoreU(pack(hn::NegMulAdd(end, rise, rise)), d, rises);
}

/// Appends what is left behind a part.
HWY_INLINE void AppendPieces(ShadeMask which, const LitPieces& p, const LitPart& part,
  ShadeVector through, LitNeeds needs, TileLitPieces& rest)
{
  const ShadeFloat d;
  const ShadeInt di;
  const LanePacker<ShadeFloat> pack(d, which);
  const int at = rest.Count;
  // Past a node the next piece begins, above or below.
  const auto rising = hn::RebindMask(di, hn::Lt(p.First, p.Last));
  const auto step = hn::IfThenElse(rising, hn::Set(di, 1), hn::Set(di, -1));
  const auto piece =
    hn::Add(p.Piece, hn::IfThenElseZero(hn::RebindMask(di, part.AtNode), step));
  hn::StoreU(pack(part.LastScalar), d, rest.First + at);
  hn::StoreU(pack(p.Last), d, rest.Last + at);
  hn::StoreU(pack(hn::Sub(p.Length, part.Length)), d, rest.Length + at);
  hn::StoreU(pack(through), d, rest.Through + at);
  if (needs.Position)
  {
    AppendLinear(pack, p.Depth, p.DepthRise, part.End, rest.Depth + at, rest.DepthRise + at);
  }
  for (int k = 0; k < 3; ++k)
  {
    AppendLinear(pack, p.Gradient[k], p.GradientRise[k], part.End, rest.Gradient[k] + at,
      rest.GradientRise[k] + at);
    if (needs.Colors)
    {
      AppendLinear(
        pack, p.Color[k], p.ColorRise[k], part.End, rest.Color[k] + at, rest.ColorRise[k] + at);
    }
  }
  hn::StoreU(pack(piece), di, rest.Piece + at);
  hn::StoreU(pack(p.Fragment), di, rest.Fragment + at);
  hn::StoreU(pack(p.Pixel), di, rest.Pixel + at);
  rest.Count = at + static_cast<int>(hn::CountTrue(d, which));
}
}
}
HWY_AFTER_NAMESPACE();

#endif
