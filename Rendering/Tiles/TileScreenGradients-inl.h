/**
 * Gradients of fragments in view coordinates, up to a factor.
 *
 * The gradient of a cell is linear in its points, hence times the weight linear in x, y and u on the
 * screen (TileView): what that is made of is found once per cell, in the order of the fragments.
 */
#if defined(TileScreenGradients_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileScreenGradients_inl_h
#undef TileScreenGradients_inl_h
#else
#define TileScreenGradients_inl_h
#endif

#include "TileCellFields.h"
#include "TileLighting.h"
#include "TilePieces-inl.h"
#include "TilePixels-inl.h"
#include "TileTask.h"
#include "TileView.h"

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

class ScreenGradients
{
public:
  ScreenGradients(const TileCellFields& fields, const TileLighting& lighting, const TileView& view,
    const TileRectangle& tile)
    : Fields(fields)
  {
    // Over the weight of the mesh's middle: the fourth power of a gradient must not leave the range of a float,
    // however small or large the world is.
    const glm::dmat4 columns = lighting.ScreenToMesh * (1.0 / view.WeightOffset);
    const glm::dvec4 corner =
      columns[3] + double(tile.Left) * columns[0] + double(tile.Bottom) * columns[1];
    for (int i = 0; i < 4; ++i)
    {
      const glm::dvec4 terms(columns[0][i], columns[1][i], columns[2][i], corner[i]);
      for (int k = 0; k < 4; ++k)
      {
        this->ToScreen[i][k] = static_cast<float>(terms[k]);
      }
    }
    for (int i = 0; i < 9; ++i)
    {
      this->ToView[i / 3][i % 3] = lighting.GradientToView[i / 3][i % 3];
    }
  }

  static constexpr int Terms = 4 * TileCellFields::Functions;

  /// Of `cells`, ids of which those of one cell follow each other, what x, y, u and 1 are multiplied by,
  /// component by component.
  HWY_INLINE const ShadeVector* Load(const int* cells, int used, ShadeVector (&mixed)[Terms])
  {
    const ShadeFloat d;
    const ShadeInt di;
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(di, hn::Ne(hn::LoadU(di, cells), hn::LoadU(di, cells + 1)), bits);
    // Bit k: lane k + 1 is of another cell than lane k.
    unsigned int ends = (bits[0] | bits[1] << 8) & ((1u << (used - 1)) - 1);
    this->Take(cells[0]);
    if (ends == 0)
    {
      return this->Rows;
    }
    const ShadeVector* rows = this->Rows;
    for (; ends != 0; ends &= ends - 1)
    {
      const auto lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(ends) + 1;
      const auto before = hn::FirstN(d, lane);
      this->Mix(cells[lane], before, rows, mixed);
      rows = mixed;
    }
    return mixed;
  }

private:
  /// Goes over to a cell.
  HWY_INLINE void Take(int cell)
  {
    if (cell == this->Cell)
    {
      return;
    }
    alignas(16) float terms[Terms];
    this->FindTerms(cell, terms);
    for (int i = 0; i < Terms; ++i)
    {
      this->Rows[i] = hn::Set(ShadeFloat(), terms[i]);
    }
  }

  /// The same, and the rows of another one before it.
  HWY_INLINE void Mix(
    int cell, ShadeMask before, const ShadeVector* rows, ShadeVector (&mixed)[Terms])
  {
    alignas(16) float terms[Terms];
    this->FindTerms(cell, terms);
    for (int i = 0; i < Terms; ++i)
    {
      const auto row = hn::Set(ShadeFloat(), terms[i]);
      mixed[i] = hn::IfThenElse(before, rows[i], row);
      this->Rows[i] = row;
    }
  }

  /// From the functions of the point of a cell those of x, y, u and 1.
  HWY_INLINE void FindTerms(int cell, float (&terms)[Terms])
  {
    this->Cell = cell;
    const float* values =
      this->Fields.Values.data() + TileCellFields::Stride * static_cast<std::size_t>(cell);
    const hn::CappedTag<float, 4> d;
    for (std::size_t k = 0; k < 4; k += hn::Lanes(d))
    {
      hn::Vec<decltype(d)> mesh[3];
      for (int i = 0; i < 3; ++i)
      {
        const float* row = values + 4 * i;
        mesh[i] = hn::Mul(hn::Set(d, row[0]), hn::Load(d, this->ToScreen[0] + k));
        mesh[i] = hn::MulAdd(hn::Set(d, row[1]), hn::Load(d, this->ToScreen[1] + k), mesh[i]);
        mesh[i] = hn::MulAdd(hn::Set(d, row[2]), hn::Load(d, this->ToScreen[2] + k), mesh[i]);
        mesh[i] = hn::MulAdd(hn::Set(d, row[3]), hn::Load(d, this->ToScreen[3] + k), mesh[i]);
      }
      for (int i = 0; i < 3; ++i)
      {
        auto view = hn::Mul(hn::Set(d, this->ToView[0][i]), mesh[0]);
        view = hn::MulAdd(hn::Set(d, this->ToView[1][i]), mesh[1], view);
        view = hn::MulAdd(hn::Set(d, this->ToView[2][i]), mesh[2], view);
        hn::Store(view, d, terms + 4 * i + k);
      }
    }
  }

  const TileCellFields& Fields;
  // Row i: what the mesh coordinate i, last 1, is times the weight of x, y, u and 1.
  alignas(16) float ToScreen[4][4];
  float ToView[3][3];
  int Cell = -1;
  // Of x, y, u and 1, per component; vectors, as most vectors of fragments lie in one cell.
  ShadeVector Rows[Terms];
};
}
}
HWY_AFTER_NAMESPACE();

#endif
