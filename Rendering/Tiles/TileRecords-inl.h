/**
 * The corners of a group of tetrahedra: records of four floats fetched one by one, read as vectors.
 */
#if defined(TileRecords_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileRecords_inl_h
#undef TileRecords_inl_h
#else
#define TileRecords_inl_h
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
struct TileRecords
{
  static constexpr int Count = 16;

  /** `corners`: 4 ids per cell; `values`: 4 floats per id. */
  void Gather(const int* corners, const float* values, const int (&cells)[Count])
  {
    for (int k = 0; k < Count; ++k)
    {
      const int* ids = corners + 4 * static_cast<std::size_t>(cells[k]);
      for (int corner = 0; corner < 4; ++corner)
      {
        const float* record = values + 4 * static_cast<std::size_t>(ids[corner]);
        std::memcpy(this->Values[corner][k], record, 4 * sizeof(float));
      }
    }
  }

  /** The four values of a corner of the cells from `lane` on. */
  template <class D, class Vector>
  void Load(D d, int corner, int lane, Vector (&out)[4]) const
  {
    hwy::HWY_NAMESPACE::LoadInterleaved4(
      d, this->Values[corner][lane], out[0], out[1], out[2], out[3]);
  }

  HWY_ALIGN float Values[4][Count][4];
};
}
}
HWY_AFTER_NAMESPACE();

#endif
