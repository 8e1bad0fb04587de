/**
 * The ways of rays through their cells, a full vector of any cells at a time: what is linear along
 * them, and the transfer function's pieces.
 */
#if defined(TileWays_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileWays_inl_h
#undef TileWays_inl_h
#else
#define TileWays_inl_h
#endif

#include "TileCellFields.h"
#include "TileLighting.h"
#include "TilePixels-inl.h"
#include "TileShading-inl.h"
#include "TileTask.h"

#include <glm/matrix.hpp>
#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE ShadeVector Dot(const ShadeVector (&a)[3], const ShadeVector (&b)[3])
{
  return hn::MulAdd(a[0], b[0], hn::MulAdd(a[1], b[1], hn::Mul(a[2], b[2])));
}

HWY_INLINE ShadeVector Dot(const ShadeVector (&a)[3], const glm::vec3& b)
{
  const ShadeFloat d;
  return hn::MulAdd(a[0], hn::Set(d, b[0]),
    hn::MulAdd(a[1], hn::Set(d, b[1]), hn::Mul(a[2], hn::Set(d, b[2]))));
}

HWY_INLINE void Turn(const glm::mat3& matrix, ShadeVector (&vector)[3])
{
  const ShadeVector before[3] = { vector[0], vector[1], vector[2] };
  const glm::mat3 rows = glm::transpose(matrix);
  for (int k = 0; k < 3; ++k)
  {
    vector[k] = Dot(before, rows[k]);
  }
}

/// 1 / sqrt(v), 0 where v is 0; relative error below 1e-6.
HWY_INLINE ShadeVector InverseRoot(ShadeVector v)
{
  const ShadeFloat d;
  const auto some = hn::Lt(hn::Set(d, 1e-36f), v);
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
  const auto rough = hn::ApproximateReciprocalSqrt(v);
  const auto half = hn::Mul(hn::Mul(v, rough), hn::Set(d, 0.5f));
  const auto root = hn::Mul(rough, hn::NegMulAdd(half, rough, hn::Set(d, 1.5f)));
#else
  const auto root = hn::Div(hn::Set(d, 1.0f), hn::Sqrt(v));
#endif
  return hn::IfThenElseZero(some, root);
}

/// Rays at the pixels of a tile, in mesh or in view coordinates: Origin(pixel) - depth *
/// ToEye(pixel), depths less that of u = 0.
class TileRays
{
public:
  TileRays(const TileView& view, const glm::dmat4& fromScreen, const TileRectangle& tile)
  {
    const glm::dvec3 x(fromScreen[0]), y(fromScreen[1]), u(fromScreen[2]);
    const glm::dvec3 corner =
      double(tile.Left) * x + double(tile.Bottom) * y + glm::dvec3(fromScreen[3]);
    const double scale = view.WeightScale, offset = view.WeightOffset;
    for (int k = 0; k < 3; ++k)
    {
      const double origin[3] = { corner[k] / offset, x[k] / offset, y[k] / offset };
      const double toEye[3] = { u[k] * offset - scale * corner[k], -scale * x[k], -scale * y[k] };
      std::copy_n(origin, 3, this->Origins[k]);
      std::copy_n(toEye, 3, this->ToEyes[k]);
    }
  }

  HWY_INLINE void FindOrigin(ShadeIndex pixel, ShadeVector (&out)[3]) const
  {
    At(this->Origins, pixel, out);
  }
  HWY_INLINE void FindToEye(ShadeIndex pixel, ShadeVector (&out)[3]) const
  {
    At(this->ToEyes, pixel, out);
  }

private:
  static HWY_INLINE void At(const float (&terms)[3][3], ShadeIndex pixel, ShadeVector (&out)[3])
  {
    const ShadeFloat d;
    const PixelPlaces places(pixel);
    const auto x = places.X, y = places.Y;
    for (int k = 0; k < 3; ++k)
    {
      const auto row = hn::MulAdd(hn::Set(d, terms[k][2]), y, hn::Set(d, terms[k][0]));
      out[k] = hn::MulAdd(hn::Set(d, terms[k][1]), x, row);
    }
  }

  float Origins[3][3];
  float ToEyes[3][3];
};

/// The linear functions of the cells of a vector of fragments.
struct FieldRows
{
  ShadeVector Row[TileCellFields::Functions][4];

  /// `cells`: ids, `used` of them; those of one cell follow each other.
  HWY_INLINE void Load(const TileCellFields& fields, const int* cells, int used)
  {
    const ShadeFloat d;
    const ShadeInt di;
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(di, hn::Ne(hn::LoadU(di, cells), hn::LoadU(di, cells + 1)), bits);
    // Bit k: lane k + 1 is of another cell than lane k.
    unsigned int ends = (bits[0] | bits[1] << 8) & ((1u << (used - 1)) - 1);
    const float* values = fields.Values.data() + TileCellFields::Stride * static_cast<std::size_t>(cells[0]);
    for (int i = 0; i < TileCellFields::Stride; ++i)
    {
      this->Row[i / 4][i % 4] = hn::Set(d, values[i]);
    }
    for (; ends != 0; ends &= ends - 1)
    {
      const auto lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(ends) + 1;
      const auto before = hn::FirstN(d, lane);
      values = fields.Values.data() + TileCellFields::Stride * static_cast<std::size_t>(cells[lane]);
      for (int i = 0; i < TileCellFields::Stride; ++i)
      {
        auto& row = this->Row[i / 4][i % 4];
        row = hn::IfThenElse(before, row, hn::Set(d, values[i]));
      }
    }
  }

  /// The values at a point, and what they rise by from there to another.
  HWY_INLINE void At(const ShadeVector (&point)[3], const ShadeVector (&way)[3],
    ShadeVector (&value)[3], ShadeVector (&rise)[3]) const
  {
    for (int i = 0; i < TileCellFields::Functions; ++i)
    {
      const auto& r = this->Row[i];
      value[i] = hn::MulAdd(
        r[0], point[0], hn::MulAdd(r[1], point[1], hn::MulAdd(r[2], point[2], r[3])));
      rise[i] = hn::MulAdd(r[0], way[0], hn::MulAdd(r[1], way[1], hn::Mul(r[2], way[2])));
    }
  }
};

/// Channel k of a transfer function.
template <class LookUp>
HWY_INLINE ShadeVector ValueOf(const LookUp& values, const TileTransfer& transfer, int k,
  ShadeIndex piece, ShadeVector scalar)
{
  return hn::MulAdd(values(transfer.Slopes[k].data(), piece), scalar,
    values(transfer.Offsets[k].data(), piece));
}

/// The least of shares beyond the beginning: what is nearer is passed already.
HWY_INLINE ShadeVector Sooner(ShadeVector next, ShadeVector share)
{
  const ShadeFloat d;
  const auto ahead = hn::And(hn::Lt(hn::Set(d, 1e-5f), share), hn::Lt(share, next));
  return hn::IfThenElse(ahead, share, next);
}
}
}
HWY_AFTER_NAMESPACE();

#endif
