/**
 * Sets up sixteen tetrahedra for a tile, one per lane, in floats on the screen.
 */
#if defined(TileSetup_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileSetup_inl_h
#undef TileSetup_inl_h
#else
#define TileSetup_inl_h
#endif

#include "TileCells.h"
#include "TileCuts-inl.h"
#include "TileGroup.h"
#include "TileMesh.h"
#include "TileRecords-inl.h"
#include "TileSpans-inl.h"
#include "TileTask.h"
#include "TileVertices.h"
#include "TileView.h"

#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

using SetupFloat = hn::CappedTag<float, TileGroup::Batch>;
using SetupInt = hn::RebindToSigned<SetupFloat>;
using SetupVector = hn::Vec<SetupFloat>;

/// The corners of the lanes' cells, edges from corner 0 and normals: normal f belongs to face f.
struct SetupCorners
{
  SetupVector Corner[4][4]; // x, y, u, scalar
  SetupVector Edge[3][3];
  SetupVector Normal[4][3];
  /// What the faces' projected areas are differences of.
  SetupVector AreaTerms[4];
  SetupVector Volume;

  void Build()
  {
    for (int i = 0; i < 3; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->Edge[i][k] = hn::Sub(this->Corner[i + 1][k], this->Corner[0][k]);
      }
    }
    for (int i = 0; i < 3; ++i)
    {
      const auto& a = this->Edge[(i + 1) % 3];
      const auto& b = this->Edge[(i + 2) % 3];
      for (int k = 0; k < 3; ++k)
      {
        const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
        this->Normal[i + 1][k] = hn::MulSub(a[k1], b[k2], hn::Mul(a[k2], b[k1]));
      }
      this->AreaTerms[i + 1] = hn::Abs(hn::Mul(a[0], b[1]));
    }
    for (int k = 0; k < 3; ++k)
    {
      const auto sum = hn::Add(hn::Add(this->Normal[1][k], this->Normal[2][k]), this->Normal[3][k]);
      this->Normal[0][k] = hn::Neg(sum);
    }
    this->AreaTerms[0] = hn::Max(hn::Max(this->AreaTerms[1], this->AreaTerms[2]),
      this->AreaTerms[3]);
    this->Volume = hn::MulAdd(this->Edge[0][0], this->Normal[1][0],
      hn::MulAdd(
        this->Edge[0][1], this->Normal[1][1], hn::Mul(this->Edge[0][2], this->Normal[1][2])));
  }

  SetupVector DepthRange() const
  {
    const auto& c = this->Corner;
    return hn::Sub(hn::Max(hn::Max(c[0][2], c[1][2]), hn::Max(c[2][2], c[3][2])),
      hn::Min(hn::Min(c[0][2], c[1][2]), hn::Min(c[2][2], c[3][2])));
  }
};

/// How far floats are to be trusted.
struct SetupBounds
{
  /// Change of depth per pixel beyond which the rounding of a corner shows: at a face where the
  /// scalar is continuous, and where it is not.
  float Steep, SteepStep;
  /// Depth by which the rounding of a face's area may move it.
  float Rounding;
  float WeightScale, WeightOffset;

  /// Rounding of a corner in pixels, and of u.
  static constexpr float PixelRounding = 3e-5f;
  static constexpr float FloatRounding = 1e-7f;
  /// What is let pass in a normalised scalar and in an optical depth.
  static constexpr float ScalarError = 1e-5f;
  static constexpr double DepthError = 2e-5;
  /// The same for the rounding of a face's area, which reaches a tenth of its bound.
  static constexpr double AreaError = 2e-4;

  explicit SetupBounds(const TileTask& task)
    : Steep(static_cast<float>(task.View->Extent))
    , WeightScale(static_cast<float>(task.View->WeightScale))
    , WeightOffset(static_cast<float>(task.View->WeightOffset))
  {
    const double share = DepthError / (PixelRounding * task.OpticalDepth);
    this->SteepStep = static_cast<float>(task.View->Extent * std::min(share, 1.0));
    this->Rounding =
      static_cast<float>(task.View->Extent * std::min(AreaError / task.OpticalDepth, 1.0));
  }
};

/// Weights of the lanes' corners, and what follows from the least.
struct SetupWeights
{
  SetupVector At[4];
  SetupVector Least;
  SetupVector ScreenDepthRounding;

  SetupWeights(const SetupCorners& c, const SetupBounds& bounds)
  {
    const SetupFloat d;
    const auto scale = hn::Set(d, bounds.WeightScale), offset = hn::Set(d, bounds.WeightOffset);
    SetupVector farthest = hn::Zero(d);
    for (int i = 0; i < 4; ++i)
    {
      this->At[i] = hn::MulAdd(scale, c.Corner[i][2], offset);
      farthest = hn::Max(farthest, hn::Abs(c.Corner[i][2]));
    }
    this->Least = hn::Min(hn::Min(this->At[0], this->At[1]), hn::Min(this->At[2], this->At[3]));
    this->ScreenDepthRounding = hn::Mul(farthest, hn::Set(d, SetupBounds::FloatRounding));
  }
};

/// The box of the lanes' cells along one axis; returns its corner's coordinate.
inline SetupVector SetUpBox(
  const SetupCorners& c, int axis, int origin, int first, int last, int* start, int* size)
{
  const SetupFloat d;
  const SetupInt di;
  const auto low = hn::Min(
    hn::Min(c.Corner[0][axis], c.Corner[1][axis]), hn::Min(c.Corner[2][axis], c.Corner[3][axis]));
  const auto high = hn::Max(
    hn::Max(c.Corner[0][axis], c.Corner[1][axis]), hn::Max(c.Corner[2][axis], c.Corner[3][axis]));
  const auto begin = hn::Max(hn::Ceil(low), hn::Set(d, static_cast<float>(first)));
  const auto end = hn::Min(hn::Floor(high), hn::Set(d, static_cast<float>(last)));
  const auto firstPixel = hn::ConvertTo(di, begin);
  const auto count = hn::Add(hn::Sub(hn::ConvertTo(di, end), firstPixel), hn::Set(di, 1));
  hn::Store(hn::Sub(firstPixel, hn::Set(di, origin)), di, start);
  hn::Store(hn::IfThenElseZero(hn::RebindMask(di, hn::Le(begin, end)), count), di, size);
  return begin;
}

/// Planes of the faces; returns the lanes in which floats do not serve. `steps`: see TileMesh.
inline hn::Mask<SetupFloat> SetUpPlanes(const SetupCorners& c, const SetupWeights& weights,
  SetupVector dx, SetupVector dy, const SetupBounds& bounds, const int* steps, int lane,
  TileGroup& group)
{
  const SetupFloat d;
  const SetupInt di;
  auto tooSteep = hn::Lt(hn::Zero(d), hn::Zero(d));
  const auto roundedPerArea = hn::Mul(c.DepthRange(), hn::Set(d, SetupBounds::FloatRounding));
  auto entries = hn::Zero(di);
  const auto stepFaces = hn::Load(di, steps);
  const auto perDepth = hn::Mul(weights.Least, weights.Least);
  const auto steep = hn::Mul(hn::Set(d, bounds.Steep), perDepth);
  const auto steepStep = hn::Mul(hn::Set(d, bounds.SteepStep), perDepth);
  const auto rounding = hn::Mul(hn::Set(d, bounds.Rounding), perDepth);
  for (int f = 0; f < 4; ++f)
  {
    const auto& n = c.Normal[f];
    const auto slope = hn::Add(hn::Abs(n[0]), hn::Abs(n[1]));
    const auto bit = hn::Set(di, 1 << f);
    const auto isStep = hn::RebindMask(d, hn::Eq(hn::And(stepFaces, bit), bit));
    const auto steepest = hn::Mul(hn::IfThenElse(isStep, steepStep, steep), hn::Abs(n[2]));
    tooSteep = hn::Or(tooSteep, hn::Not(hn::Le(slope, steepest)));
    // Of a sliver, where the area is what rounding leaves of a difference, the neighbours disagree.
    const auto rounded = hn::Mul(roundedPerArea, c.AreaTerms[f]);
    tooSteep = hn::Or(tooSteep, hn::Gt(rounded, hn::Mul(rounding, hn::Abs(n[2]))));
    const auto inverse = hn::Div(hn::Set(d, 1.0f), n[2]);
    const auto a = hn::Mul(n[0], inverse), b = hn::Mul(n[1], inverse);
    auto p = hn::NegMulAdd(a, dx, hn::NegMulAdd(b, dy, c.Corner[0][2]));
    // Face 0 is the one without corner 0.
    p = f == 0 ? hn::NegMulAdd(c.Volume, inverse, p) : p;
    hn::Store(p, d, group.P[f] + lane);
    hn::Store(hn::Neg(a), d, group.A[f] + lane);
    hn::Store(hn::Neg(b), d, group.B[f] + lane);
    const auto enters = hn::Lt(hn::Mul(n[2], c.Volume), hn::Zero(d));
    entries = hn::Or(entries, hn::IfThenElseZero(hn::RebindMask(di, enters), bit));
  }
  hn::Store(entries, di, group.Entries + lane);
  return tooSteep;
}

/// The scalar; returns the lanes in which it changes too fast.
inline hn::Mask<SetupFloat> SetUpScalar(const SetupCorners& c, const SetupWeights& weights,
  SetupVector dx, SetupVector dy, const SetupBounds& bounds, int lane, TileGroup& group)
{
  const SetupFloat d;
  const auto scale = hn::Set(d, bounds.WeightScale), offset = hn::Set(d, bounds.WeightOffset);
  const auto first = c.Corner[0][3];
  const auto inverse = hn::Div(hn::Set(d, 1.0f), c.Volume);
  SetupVector gradient[3] = { hn::Zero(d), hn::Zero(d), hn::Zero(d) };
  for (int i = 1; i < 4; ++i)
  {
    const auto rise = hn::Mul(hn::Mul(hn::Sub(c.Corner[i][3], first), weights.At[i]), inverse);
    for (int k = 0; k < 3; ++k)
    {
      gradient[k] = hn::MulAdd(c.Normal[i][k], rise, gradient[k]);
    }
  }
  const auto atCorner = hn::NegMulAdd(gradient[2], c.Corner[0][2], hn::Mul(first, offset));
  hn::Store(gradient[0], d, group.ScalarA + lane);
  hn::Store(gradient[1], d, group.ScalarB + lane);
  hn::Store(hn::MulAdd(first, scale, gradient[2]), d, group.ScalarU + lane);
  hn::Store(
    hn::MulAdd(gradient[0], dx, hn::MulAdd(gradient[1], dy, atCorner)), d, group.ScalarP + lane);
  const auto change = hn::MulAdd(hn::Add(hn::Abs(gradient[0]), hn::Abs(gradient[1])),
    hn::Set(d, SetupBounds::PixelRounding),
    hn::Mul(hn::Abs(gradient[2]), weights.ScreenDepthRounding));
  return hn::Not(hn::Le(change, hn::Mul(weights.Least, hn::Set(d, SetupBounds::ScalarError))));
}

/// The cuts, where there is anything to cut off.
inline void CutTransparent(
  const TileTask& task, const SetupCorners& c, int lane, TileGroup& group)
{
  const SetupInt di;
  if (!task.Transfer->HasTransparent)
  {
    hn::Store(hn::Zero(di), di, group.Cut + lane);
    return;
  }
  const auto least = hn::Min(
    hn::Min(c.Corner[0][3], c.Corner[1][3]), hn::Min(c.Corner[2][3], c.Corner[3][3]));
  const auto greatest = hn::Max(
    hn::Max(c.Corner[0][3], c.Corner[1][3]), hn::Max(c.Corner[2][3], c.Corner[3][3]));
  WithLookUp(*task.Transfer,
    [&](auto values) { SetUpCuts<decltype(values)>(task, least, greatest, lane, group); });
}

/// What is gathered of the cells of a batch.
struct SetupBatch
{
  static_assert(TileGroup::Batch == TileRecords::Count && TileGroup::Size % TileGroup::Batch == 0, "batches fill groups");
  TileRecords Records;
  HWY_ALIGN int Steps[TileGroup::Batch];
  HWY_ALIGN float Scalars[TileGroup::Batch];
  const bool HasScalars;

  SetupBatch(const TileTask& task, const int* cells, int count, int* exact)
    : HasScalars(!task.Mesh->CellScalars.empty())
  {
    int ids[TileGroup::Batch];
    const int allExact = task.AllExact ? 1 : 0;
    for (int k = 0; k < TileGroup::Batch; ++k)
    {
      ids[k] = cells[std::min(k, count - 1)];
      this->Steps[k] = task.Mesh->Steps[ids[k]];
      exact[k] = allExact | (task.Cells->Faces[ids[k]] & TileCells::Exact);
    }
    this->Records.Gather(task.Mesh->Corners.data(), task.Vertices->Values.data(), ids);
    for (int k = 0; this->HasScalars && k < TileGroup::Batch; ++k)
    {
      this->Scalars[k] = task.Mesh->CellScalars[ids[k]];
    }
  }
};

/// A vector of a batch from `lane` on, in the group from `at` on.
inline void SetUpLanes(const TileTask& task, const SetupBatch& batch, int lane, const TileRectangle& tile,
  const SetupBounds& bounds, int at, TileGroup& group)
{
  const SetupFloat d;
  const SetupInt di;
  SetupCorners c;
  for (int corner = 0; corner < 4; ++corner)
  {
    batch.Records.Load(d, corner, lane, c.Corner[corner]);
    c.Corner[corner][3] = batch.HasScalars ? hn::Load(d, batch.Scalars + lane) : c.Corner[corner][3];
  }
  c.Build();
  const SetupWeights weights(c, bounds);
  const auto x = SetUpBox(c, 0, tile.Left, tile.FirstX, tile.LastX, group.Left + at, group.Width + at);
  const auto y = SetUpBox(c, 1, tile.Bottom, tile.FirstY, tile.LastY, group.Bottom + at, group.Height + at);
  const auto dx = hn::Sub(x, c.Corner[0][0]), dy = hn::Sub(y, c.Corner[0][1]);
  const auto tooSteep = SetUpPlanes(c, weights, dx, dy, bounds, batch.Steps + lane, at, group);
  const auto tooFast = SetUpScalar(c, weights, dx, dy, bounds, at, group);
  const auto exact = hn::RebindMask(di, hn::Or(tooSteep, tooFast));
  hn::Store(hn::IfThenElse(exact, hn::Set(di, 1), hn::Load(di, group.Exact + at)), di, group.Exact + at);
  CutTransparent(task, c, at, group);
  task.Transfer->HasTransparent ? FindSpans<7>(group, at) : FindSpans<3>(group, at);
}

inline void SetUpGroup(const TileTask& task, const TileRectangle& tile, const SetupBounds& bounds,
  const int* cells, int count, TileGroup& group)
{
  for (int first = 0; first < count; first += TileGroup::Batch)
  {
    const SetupBatch batch(task, cells + first, count - first, group.Exact + first);
    for (int lane = 0; lane < TileGroup::Batch; lane += static_cast<int>(hn::Lanes(SetupFloat())))
    {
      SetUpLanes(task, batch, lane, tile, bounds, first + lane, group);
    }
  }
}
}
}
HWY_AFTER_NAMESPACE();

#endif
