/**
 * Lanes of a mask moved to the front: what Highway's Compress does.
 *
 * Of vectors of 16 and 32 bytes without AVX-512 it takes tables, which compilers copy to the stack at every call where
 * they are as in Highway 1.0: that took four times as long as all else in a frame. Here they are static.
 */
#if defined(TilePacking_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TilePacking_inl_h
#undef TilePacking_inl_h
#else
#define TilePacking_inl_h
#endif

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
/// Which of `lanes` lanes comes at a place where those of a set come first.
constexpr int LaneAt(int lanes, int set, int place)
{
  for (int step = 0; step < 2 * lanes; ++step)
  {
    const bool isInSet = (set >> step % lanes & 1) != 0;
    if (isInSet == (step < lanes) && place-- == 0)
    {
      return step % lanes;
    }
  }
  return 0;
}

/// For each set of four lanes the bytes of their vector.
struct OrdersOfFour
{
  constexpr OrdersOfFour()
  {
    for (int i = 0; i < 16 * 16; ++i)
    {
      this->Bytes[i / 16][i % 16] =
        static_cast<std::uint8_t>(4 * LaneAt(4, i / 16, i % 16 / 4) + i % 4);
    }
  }
  alignas(16) std::uint8_t Bytes[16][16] = {};
};
inline constexpr OrdersOfFour TheOrdersOfFour{};

template <class D>
HWY_INLINE int LaneSet(D d, hn::Mask<D> lanes)
{
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, lanes, bits);
  return bits[0];
}

/// Moves the lanes of a mask to the front, of vectors of numbers of 32 bits: four or fewer here, eight below.
template <class D, std::size_t Lanes = hn::MaxLanes(D())>
class LanePacker
{
public:
  HWY_INLINE LanePacker(D d, hn::Mask<D> lanes)
    : Bytes(hn::Load(Byte(), TheOrdersOfFour.Bytes[LaneSet(d, lanes)]))
  {
  }
  template <class Vector>
  HWY_INLINE Vector operator()(Vector values) const
  {
    const auto bytes = hn::BitCast(Byte(), values);
    return hn::BitCast(hn::DFromV<Vector>(), hn::TableLookupBytes(bytes, this->Bytes));
  }

private:
  using Byte = hn::Repartition<std::uint8_t, D>;
  const hn::Vec<Byte> Bytes;
};

#if HWY_TARGET == HWY_AVX2
/// For each set of eight lanes four bits a lane.
struct OrdersOfEight
{
  constexpr OrdersOfEight()
  {
    for (int i = 0; i < 256 * 8; ++i)
    {
      this->Nibbles[i / 8] |= static_cast<std::uint32_t>(LaneAt(8, i / 8, i % 8)) << 4 * (i % 8);
    }
  }
  std::uint32_t Nibbles[256] = {};
};
inline constexpr OrdersOfEight TheOrdersOfEight{};

template <class D>
class LanePacker<D, 8>
{
public:
  HWY_INLINE LanePacker(D d, hn::Mask<D> lanes)
    : Order(FindOrder(TheOrdersOfEight.Nibbles[LaneSet(d, lanes)]))
  {
  }
  template <class Vector>
  HWY_INLINE Vector operator()(Vector values) const
  {
    return hn::TableLookupLanes(values, hn::IndicesFromVec(hn::DFromV<Vector>(), this->Order));
  }

private:
  using Index = hn::RebindToSigned<D>;
  static HWY_INLINE hn::Vec<Index> FindOrder(std::uint32_t nibbles)
  {
    const Index d;
    const auto shifted = hn::Shr(hn::Set(d, static_cast<std::int32_t>(nibbles)), hn::Load(d, Shifts));
    return hn::And(shifted, hn::Set(d, 7));
  }
  alignas(32) static constexpr std::int32_t Shifts[8] = { 0, 4, 8, 12, 16, 20, 24, 28 };
  const hn::Vec<Index> Order;
};
#endif
#else
template <class D>
class LanePacker
{
public:
  HWY_INLINE LanePacker(D, hn::Mask<D> lanes)
    : Lanes(lanes)
  {
  }
  template <class Vector>
  HWY_INLINE Vector operator()(Vector values) const
  {
    return hn::Compress(values, hn::RebindMask(hn::DFromV<Vector>(), this->Lanes));
  }

private:
  const hn::Mask<D> Lanes;
};
#endif
}
}
HWY_AFTER_NAMESPACE();

#endif
