/**
 * The corners of a group of tetrahedra: records of four floats, read as vectors.
 */
#if defined(TileRecords_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileRecords_inl_h
#undef TileRecords_inl_h
#else
#define TileRecords_inl_h
#endif

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

struct TileRecords
{
  static constexpr int Count = 16;

  /** `corners`: 4 ids per cell; `values`: 4 floats per id. */
  void Gather(const int* corners, const float* values, const int (&cells)[Count])
  {
    this->Values = values;
    for (int k = 0; k < Count; ++k)
    {
      this->Corners[k] = corners + 4 * static_cast<std::size_t>(cells[k]);
    }
  }

  /** The four values of a corner of the cells from `lane` on: straight into vectors, as one load of what several stores
   *  wrote waits for them. */
  template <class D, class Vector>
  HWY_INLINE void Load(D d, int corner, int lane, Vector (&out)[4]) const
  {
#if HWY_TARGET == HWY_SCALAR
    for (int i = 0; i < 4; ++i)
    {
      out[i] = hn::Load(d, this->Find(corner, lane) + i);
    }
#else
    // Every 128 bits are a record, of every fourth cell; then 4 x 4 records change places with their values.
    const hn::Repartition<double, D> pairs;
    const Vector records[4] = { this->LoadBlocks(d, corner, lane), this->LoadBlocks(d, corner, lane + 1),
      this->LoadBlocks(d, corner, lane + 2), this->LoadBlocks(d, corner, lane + 3) };
    const auto low01 = hn::BitCast(pairs, hn::InterleaveLower(d, records[0], records[1]));
    const auto low23 = hn::BitCast(pairs, hn::InterleaveLower(d, records[2], records[3]));
    const auto high01 = hn::BitCast(pairs, hn::InterleaveUpper(d, records[0], records[1]));
    const auto high23 = hn::BitCast(pairs, hn::InterleaveUpper(d, records[2], records[3]));
    out[0] = hn::BitCast(d, hn::InterleaveLower(pairs, low01, low23));
    out[1] = hn::BitCast(d, hn::InterleaveUpper(pairs, low01, low23));
    out[2] = hn::BitCast(d, hn::InterleaveLower(pairs, high01, high23));
    out[3] = hn::BitCast(d, hn::InterleaveUpper(pairs, high01, high23));
#endif
  }

private:
  HWY_INLINE const float* Find(int corner, int k) const
  {
    return this->Values + 4 * static_cast<std::size_t>(this->Corners[k][corner]);
  }

#if HWY_TARGET != HWY_SCALAR
  /** The records of the cells from k on, every fourth. */
  template <class D>
  HWY_INLINE hn::Vec<D> LoadBlocks(D d, int corner, int k) const
  {
    if constexpr (hn::MaxLanes(D()) == 4)
    {
      return hn::LoadU(d, this->Find(corner, k));
    }
    else
    {
      const hn::Half<D> half;
      constexpr int lanes = static_cast<int>(hn::MaxLanes(hn::Half<D>()));
      return hn::Combine(
        d, this->LoadBlocks(half, corner, k + lanes), this->LoadBlocks(half, corner, k));
    }
  }
#endif

  const int* Corners[Count];
  const float* Values;
};
}
}
HWY_AFTER_NAMESPACE();

#endif
