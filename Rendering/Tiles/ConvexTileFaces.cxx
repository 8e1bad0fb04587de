// Compiled once for each instruction set that the machine may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ConvexTileFaces.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "ConvexTileFaces.h"
#include "ConvexTileMesh.h"
#include "TileClusterBlocks.h"
#include "TileRecords-inl.h"
#include "TileVertices.h"
#include "TileView.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

using FaceFloat = hn::CappedTag<float, TileRecords::Count>;
using FaceVector = hn::Vec<FaceFloat>;
using FaceMask = hn::Mask<FaceFloat>;

/// The bounds in units of the screen.
struct FaceLimits
{
  float Steep, SteepStep, Rounding, Scalar, Pixel, WeightScale, WeightOffset;
  float FarthestScreenDepth;

  /// Half a step of a coordinate of the screen, and of products of two, in their own units.
  static constexpr double FloatRounding = 3e-8;
  static constexpr double AreaRounding = 2e-7;
  /// What is let pass in a pixel's sum where a face's place is off by a rounding.
  static constexpr double StepError = 2e-5;
  static constexpr double AreaError = 2e-4;

  FaceLimits(const TileView& view, const ConvexTileFaces::Bounds& bounds)
  {
    const double pixel = FloatRounding * std::max({ view.Width, view.Height, 64 });
    this->Pixel = static_cast<float>(pixel);
    this->Steep = static_cast<float>(bounds.Steep * view.Extent);
    this->SteepStep = static_cast<float>(
      view.Extent * std::min(StepError / (pixel * bounds.Density), bounds.Steep));
    this->Rounding = static_cast<float>(view.Extent * std::min(AreaError / bounds.Density, 1.0));
    this->Scalar = static_cast<float>(bounds.ScalarError);
    this->WeightScale = static_cast<float>(view.WeightScale);
    this->WeightOffset = static_cast<float>(view.WeightOffset);
  }
};

/// One vector of faces: corners as x, y, u and scalar * weight; 1 to 3 from corner 0.
struct FaceLanes
{
  FaceVector First[4], Edge[4][4];
  FaceVector LeastWeight, Areas[2], Terms;
  FaceMask HasTwo, UsesSecond;

  void Load(const TileRecords& records, int lane, const FaceLimits& limits)
  {
    const FaceFloat d;
    const auto scale = hn::Set(d, limits.WeightScale), offset = hn::Set(d, limits.WeightOffset);
    for (int i = 0; i < 4; ++i)
    {
      records.Load(d, i, lane, this->Edge[i]);
      const auto weight = hn::MulAdd(scale, this->Edge[i][2], offset);
      this->LeastWeight = i == 0 ? weight : hn::Min(this->LeastWeight, weight);
      this->Edge[i][3] = hn::Mul(this->Edge[i][3], weight);
    }
    for (int k = 0; k < 4; ++k)
    {
      this->First[k] = this->Edge[0][k];
      for (int i = 1; i < 4; ++i)
      {
        this->Edge[i][k] = hn::Sub(this->Edge[i][k], this->First[k]);
      }
    }
    this->FindAreas();
  }

  static FaceVector Area(const FaceVector (&a)[4], const FaceVector (&b)[4])
  {
    return hn::MulSub(a[0], b[1], hn::Mul(a[1], b[0]));
  }

  void FindAreas()
  {
    const FaceFloat d;
    const auto& e = this->Edge;
    this->Areas[0] = Area(e[1], e[2]);
    this->Areas[1] = hn::IfThenElseZero(this->HasTwo, Area(e[2], e[3]));
    this->UsesSecond = hn::Gt(hn::Abs(this->Areas[1]), hn::Abs(this->Areas[0]));
    const auto reach = [&](int i) { return hn::Max(hn::Abs(e[i][0]), hn::Abs(e[i][1])); };
    this->Terms = hn::Mul(reach(2), hn::Max(reach(1), reach(3)));
    this->Terms = hn::Max(this->Terms, hn::Set(d, 1e-30f));
  }

  FaceVector Pick(int first, int second, int k) const
  {
    return hn::IfThenElse(this->UsesSecond, this->Edge[second][k], this->Edge[first][k]);
  }
  FaceVector BaseArea() const
  {
    return hn::IfThenElse(this->UsesSecond, this->Areas[1], this->Areas[0]);
  }
  FaceVector OtherArea() const
  {
    return hn::IfThenElse(this->UsesSecond, this->Areas[0], this->Areas[1]);
  }
  /// The range of a value over the corners, at most twice.
  FaceVector Range(int k) const
  {
    return hn::Max(
      hn::Abs(this->Edge[1][k]), hn::Max(hn::Abs(this->Edge[2][k]), hn::Abs(this->Edge[3][k])));
  }
};

/// A function over both triangles: A dx + B dy + Fold max(g, 0).
struct FaceFunction
{
  FaceVector A, B, Fold;
  /// Its steepest change per pixel on either triangle.
  FaceVector Slope;

  FaceFunction(const FaceLanes& f, int k, FaceVector gx, FaceVector gy)
  {
    const FaceFloat d;
    // Base triangle: corners 0, 1, 2 or 0, 2, 3.
    const FaceVector p[3] = { f.Pick(1, 2, 0), f.Pick(1, 2, 1), f.Pick(1, 2, k) };
    const FaceVector q[3] = { f.Pick(2, 3, 0), f.Pick(2, 3, 1), f.Pick(2, 3, k) };
    const auto inverse = hn::Div(hn::Set(d, 1.0f), f.BaseArea());
    this->A = hn::Mul(hn::MulSub(p[2], q[1], hn::Mul(q[2], p[1])), inverse);
    this->B = hn::Mul(hn::MulSub(q[2], p[0], hn::Mul(p[2], q[0])), inverse);
    const auto beyond = hn::NegMulAdd(
      this->A, f.Pick(3, 1, 0), hn::NegMulAdd(this->B, f.Pick(3, 1, 1), f.Pick(3, 1, k)));
    this->Fold = hn::IfThenElseZero(f.HasTwo, hn::Div(beyond, hn::Abs(f.OtherArea())));
    const auto here = hn::Add(hn::Abs(this->A), hn::Abs(this->B));
    const auto there = hn::Add(hn::Abs(hn::MulAdd(this->Fold, gx, this->A)),
      hn::Abs(hn::MulAdd(this->Fold, gy, this->B)));
    this->Slope = hn::Max(here, there);
  }
};

/// Where floats serve: comparisons fail for what is not a number.
inline FaceMask IsTrusted(const FaceLanes& f, const FaceFunction& u, const FaceFunction& s,
  FaceMask isStep, FaceMask isWarped, const FaceLimits& limits)
{
  const FaceFloat d;
  const auto square = hn::Mul(f.LeastWeight, f.LeastWeight);
  const auto steep =
    hn::IfThenElse(isStep, hn::Set(d, limits.SteepStep), hn::Set(d, limits.Steep));
  const auto scalarError = hn::Mul(hn::Set(d, limits.Scalar), f.LeastWeight);
  auto good = hn::Le(u.Slope, hn::Mul(steep, square));
  good = hn::And(good, hn::Le(hn::Mul(s.Slope, hn::Set(d, limits.Pixel)), scalarError));
  const auto least = hn::IfThenElse(f.HasTwo,
    hn::Min(hn::Abs(f.Areas[0]), hn::Abs(f.Areas[1])), hn::Abs(f.Areas[0]));
  const auto rounded = hn::Mul(f.Terms, hn::Set(d, float(FaceLimits::AreaRounding)));
  const auto depthError = hn::Mul(hn::Set(d, limits.Rounding), square);
  good = hn::And(good, hn::Le(hn::Mul(rounded, f.Range(2)), hn::Mul(depthError, least)));
  good = hn::And(good, hn::Le(hn::Mul(rounded, f.Range(3)), hn::Mul(scalarError, least)));
  // The sign of both areas is beyond doubt, and the same but for warped faces.
  const auto doubt = hn::MulAdd(hn::Set(d, 8.0f * limits.Pixel),
    hn::Add(f.Range(0), f.Range(1)), rounded);
  good = hn::And(good, hn::Lt(doubt, least));
  const auto agree = hn::Ge(hn::Mul(f.Areas[0], f.Areas[1]), hn::Zero(d));
  return hn::And(good, hn::Or(agree, isWarped));
}

struct FaceGroup
{
  HWY_ALIGN float Out[4][TileRecords::Count][4];
  HWY_ALIGN int HasTwo[TileRecords::Count];
  HWY_ALIGN int IsWarped[TileRecords::Count];
  HWY_ALIGN int IsStep[TileRecords::Count];
};

void ProjectFaceLanes(
  const TileRecords& records, int lane, const FaceLimits& limits, FaceGroup& group)
{
  const FaceFloat d;
  const hn::RebindToSigned<FaceFloat> di;
  auto flag = [&](const int* flags)
  { return hn::RebindMask(d, hn::Ne(hn::Load(di, flags + lane), hn::Zero(di))); };
  FaceLanes f;
  f.HasTwo = flag(group.HasTwo);
  f.Load(records, lane, limits);
  // Above 0 on the other triangle's side of the diagonal.
  const auto side = hn::IfThenElse(
    f.UsesSecond, hn::Neg(f.Areas[0]), f.Areas[1]);
  const auto gx = hn::CopySign(hn::Abs(f.Edge[2][1]), hn::Neg(hn::Mul(f.Edge[2][1], side)));
  const auto gy = hn::CopySign(hn::Abs(f.Edge[2][0]), hn::Mul(f.Edge[2][0], side));
  FaceFunction u(f, 2, gx, gy);
  const auto isWarped = flag(group.IsWarped);
  u.Fold = hn::IfThenElseZero(isWarped, u.Fold);
  const FaceFunction s(f, 3, gx, gy);
  const auto good = IsTrusted(f, u, s, flag(group.IsStep), isWarped, limits);
  const auto one = hn::CopySign(hn::Set(d, 1.0f), f.BaseArea());
  const auto zero = hn::Zero(d);
  const auto mixed = hn::IfThenElseZero(
    hn::Lt(hn::Mul(f.Areas[0], f.Areas[1]), zero), hn::CopySign(hn::Set(d, 1.0f), side));
  const std::size_t at = static_cast<std::size_t>(lane);
  hn::StoreInterleaved4(f.First[0], f.First[1], f.First[2], u.A, d, group.Out[0][at]);
  hn::StoreInterleaved4(u.B, f.First[3], s.A, s.B, d, group.Out[1][at]);
  hn::StoreInterleaved4(gx, gy, u.Fold, s.Fold, d, group.Out[2][at]);
  hn::StoreInterleaved4(
    hn::IfThenElseZero(good, one), mixed, zero, zero, d, group.Out[3][at]);
}

// NOLINTNEXTLINE: Highway's dispatch table names it.
void ProjectFaces(const ConvexTileMesh& mesh, const TileView& view, const TileVertices& vertices,
  const ConvexTileFaces::Bounds& bounds, int begin, int end, ConvexTileFace* faces)
{
  const FacePieces& pieces = *mesh.Pieces;
  const FaceLimits limits(view, bounds);
  TileRecords records;
  FaceGroup group;
  int ids[TileRecords::Count];
  for (int first = begin; first < end; first += TileRecords::Count)
  {
    const int count = std::min(end - first, TileRecords::Count);
    for (int k = 0; k < TileRecords::Count; ++k)
    {
      const int face = first + std::min(k, count - 1);
      ids[k] = pieces.Offsets[face];
      group.HasTwo[k] = pieces.Corners[ids[k]][2] != pieces.Corners[ids[k]][3] ? 1 : 0;
      group.IsWarped[k] = pieces.Planes[face].IsWarped ? 1 : 0;
      group.IsStep[k] = mesh.Steps[face];
    }
    records.Gather(pieces.Corners[0].data(), vertices.Values.data(), ids);
    for (int lane = 0; lane < TileRecords::Count; lane += static_cast<int>(hn::Lanes(FaceFloat())))
    {
      ProjectFaceLanes(records, lane, limits, group);
    }
    for (int k = 0; k < count; ++k)
    {
      float* out = &faces[first + k].X;
      for (int part = 0; part < 4; ++part)
      {
        std::memcpy(out + 4 * part, group.Out[part][k], 4 * sizeof(float));
      }
      // Faces of more than two triangles are left to class ConvexTileExactCell.
      const bool isLong = pieces.Offsets[first + k + 1] > ids[k] + 1;
      faces[first + k].Side = isLong ? 0.0f : faces[first + k].Side;
    }
  }
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace CellProjectionTiles
{
HWY_EXPORT(ProjectFaces);
}

//------------------------------------------------------------------------------
void ConvexTileFaces::Project(const ConvexTileMesh& mesh, const TileView& view,
  const TileVertices& vertices, const TileClusterBlocks& blocks, const Bounds& bounds)
{
  const int faces = mesh.GetNumberOfFaces();
  this->Values.resize(static_cast<std::size_t>(faces));
  constexpr int Size = TileClusterBlocks::Size;
  vtkSMPTools::For(0, (faces + Size - 1) / Size, 128,
    [&](vtkIdType begin, vtkIdType end)
    {
      const auto isSeen = [&](vtkIdType block)
      { return blocks.IsSeen(static_cast<std::size_t>(block)); };
      for (vtkIdType block = begin; block < end; ++block)
      {
        const auto first = static_cast<int>(block) * Size;
        while (block < end && isSeen(block))
        {
          ++block;
        }
        const int last = std::min(static_cast<int>(block) * Size, faces);
        if (first < last)
        {
          HWY_DYNAMIC_DISPATCH(CellProjectionTiles::ProjectFaces)
          (mesh, view, vertices, bounds, first, last, this->Values.data());
        }
      }
    });
}
#endif
