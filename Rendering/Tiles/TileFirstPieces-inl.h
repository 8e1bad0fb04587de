/**
 * The first pieces of lit fragments: from the queue of fragments, with what changes along them.
 */
#if defined(TileFirstPieces_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileFirstPieces_inl_h
#undef TileFirstPieces_inl_h
#else
#define TileFirstPieces_inl_h
#endif

#include "TileLight-inl.h"
#include "TileLitPieces-inl.h"
#include "TilePartColors-inl.h"
#include "TileTask.h"
#include "TileWays-inl.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

template <bool General>
class TileFirstPieces
{
public:
  TileFirstPieces(const TileTask& task, const TileRectangle& tile, const LitKind<General>& kind,
    const TileLightSource& light)
    : Task(task)
    , Lighting(*task.Lighting)
    , Kind(kind)
    , Light(light)
    , Lengths(*task.View, tile)
    , Rays(*task.View, task.Lighting->ScreenToMesh, tile)
    , LengthPerWay(this->FindLengthPerWay())
  {
  }

  /// Of the vector of fragments from `at` on.
  HWY_INLINE void Find(const TileFragments& q, int at, LitPieces& p) const
  {
    const ShadeFloat d;
    const ShadeInt di;
    const auto scale = hn::Set(d, static_cast<float>(this->Task.View->WeightScale));
    const auto offset = hn::Set(d, static_cast<float>(this->Task.View->WeightOffset));
    const auto perWeight = hn::Set(d, static_cast<float>(-1.0 / this->Task.View->WeightOffset));
    const FragmentEnds ends(q, at, scale, offset);
    p.Pixel = hn::Load(di, q.Pixel + at);
    p.DepthRise = ends.Depth();
    p.Depth = hn::Mul(hn::Mul(ends.Entry, perWeight), hn::Mul(ends.WeightOut, ends.Inverse));
    p.First = ends.First(q.ScalarIn + at);
    p.Last = ends.Last(q.ScalarOut + at);
    p.Through = hn::Set(d, 1.0f);
    p.Fragment = Ramp(di, at);
    const int lanes = static_cast<int>(hn::Lanes(d));
    this->SetFields(q.Cell + at, std::min(lanes, q.Count - at), p);
  }

private:
  /// World length of a way of length 1 in the mesh; 0 where it depends on the way, or where the
  /// way's square is not for floats.
  float FindLengthPerWay() const
  {
    if (!this->Lighting.HasOneScale)
    {
      return 0.0f;
    }
    HWY_ALIGN float length[16], ways[16];
    ShadeVector toEye[3];
    const auto pixel = hn::Zero(ShadeInt());
    this->Rays.FindToEye(pixel, toEye);
    hn::Store(Dot(toEye, toEye), ShadeFloat(), ways);
    hn::Store(this->Lengths.At(pixel), ShadeFloat(), length);
    return ways[0] > 1e-30f && ways[0] < 1e30f ? length[0] / std::sqrt(ways[0]) : 0.0f;
  }

  /// The piece's length, and the way to the eye.
  HWY_INLINE void SetLength(const ShadeVector (&toEye)[3], LitPieces& p) const
  {
    if (this->LengthPerWay == 0.0f)
    {
      p.Length = hn::Mul(p.DepthRise, this->Lengths.At(p.Pixel));
      this->Light.FindToEye(p.Pixel, p.ToEye);
      return;
    }
    const auto square = Dot(toEye, toEye);
    const auto inverse = InverseRoot(square);
    const auto perWay = hn::Set(ShadeFloat(), this->LengthPerWay);
    p.Length = hn::Mul(p.DepthRise, hn::Mul(hn::Mul(square, inverse), perWay));
    for (int k = 0; k < 3; ++k)
    {
      p.ToEye[k] = hn::Mul(toEye[k], inverse);
    }
  }

  /// Gradient and components at the beginning, and their rise.
  HWY_INLINE void SetFields(const int* cells, int used, LitPieces& p) const
  {
    const ShadeFloat d;
    ShadeVector point[3], way[3], toEye[3];
    this->Rays.FindOrigin(p.Pixel, point);
    this->Rays.FindToEye(p.Pixel, toEye);
    this->SetLength(toEye, p);
    for (int k = 0; k < 3; ++k)
    {
      point[k] = hn::NegMulAdd(p.Depth, toEye[k], point[k]);
      way[k] = hn::Neg(hn::Mul(p.DepthRise, toEye[k]));
      p.Gradient[k] = p.GradientRise[k] = hn::Zero(d);
    }
    FieldRows rows;
    if (this->Kind.IsLit() || this->Kind.HasOpacity())
    {
      rows.Load(*this->Task.Gradients, cells, used);
      rows.At(point, way, p.Gradient, p.GradientRise);
    }
    if (this->Lighting.IsInView)
    {
      Turn(this->Lighting.GradientToView, p.Gradient);
      Turn(this->Lighting.GradientToView, p.GradientRise);
    }
    if (this->Kind.HasColors())
    {
      rows.Load(*this->Task.Colors, cells, used);
      rows.At(point, way, p.Color, p.ColorRise);
    }
  }

  const TileTask& Task;
  const TileLighting& Lighting;
  const LitKind<General>& Kind;
  const TileLightSource& Light;
  const RayLengths Lengths;
  const TileRays Rays;
  const float LengthPerWay;
};
}
}
HWY_AFTER_NAMESPACE();

#endif
