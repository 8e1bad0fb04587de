// The pixels of convex cells that the Tiles engine looks for between edges, row by row, against all pixels of their
// boxes by the faces themselves: for every instruction set that this machine has none is left out, few are more, and
// what is found of them is the same to the last byte.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "TestConvexTileSpans.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "ConvexTileCoverage-inl.h"
#include "ConvexTileExactCoverage-inl.h"

#ifndef TestConvexTileSpans_Errors
#define TestConvexTileSpans_Errors
struct ConvexSpanErrors
{
  /// Pixels that are covered, of these not found; those that are found otherwise; those that spans hold.
  long long Covered = 0, Missed = 0, Different = 0, Held = 0;
  /// The longest of the pieces of rays that are not found.
  float MissedExtent = 0.0f;
  /// Rows, and those whose span leaves the box.
  long long Rows = 0, Outside = 0;
  /// Cells that were looked at, of these in double; faces that turn both ways.
  int Cells = 0, Mixed = 0, Exact = 0;
};
#endif

#include <algorithm>
#include <memory>
#include <type_traits>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
/// All of a fragment.
struct ConvexFragment
{
  int Pixel;
  float Entry, Extent, ScalarIn, ScalarOut;

  bool operator==(const ConvexFragment& other) const
  {
    return this->Pixel == other.Pixel && this->Entry == other.Entry && this->Extent == other.Extent &&
      this->ScalarIn == other.ScalarIn && this->ScalarOut == other.ScalarOut;
  }
};

std::vector<ConvexFragment> TakeFragments(TileFragments& q)
{
  std::vector<ConvexFragment> fragments;
  for (int i = 0; i < q.Count; ++i)
  {
    fragments.push_back({ q.Pixel[i], q.Entry[i], q.Extent[i], q.ScalarIn[i], q.ScalarOut[i] });
  }
  q.Count = 0;
  std::sort(fragments.begin(), fragments.end(),
    [](const ConvexFragment& a, const ConvexFragment& b) { return a.Pixel < b.Pixel; });
  return fragments;
}

void CompareFragments(
  const std::vector<ConvexFragment>& all, const std::vector<ConvexFragment>& found, ConvexSpanErrors& errors)
{
  std::size_t at = 0;
  for (const ConvexFragment& fragment : all)
  {
    const bool isFound = at < found.size() && found[at].Pixel == fragment.Pixel;
    errors.Missed += isFound ? 0 : 1;
    errors.MissedExtent = std::max(errors.MissedExtent, isFound ? 0.0f : fragment.Extent);
    errors.Different += isFound && !(found[at] == fragment) ? 1 : 0;
    at += isFound ? 1 : 0;
  }
  // What is found and not covered, or comes twice.
  errors.Different += static_cast<long long>(found.size() - at);
  errors.Covered += static_cast<long long>(all.size());
}

/// All pixels of a box.
template <class D>
void CoverAll(const CellEnds<D>& ends, const CellBox& box, int corner, TileFragments& q)
{
  const D d;
  const hn::Rebind<std::int32_t, D> di;
  for (int y = 0; y < box.GetHeight(); ++y)
  {
    for (int left = 0; left < box.GetWidth(); left += static_cast<int>(hn::Lanes(d)))
    {
      BlockEnd<D> entry, exit;
      ends.Find(Ramp(d, static_cast<hn::TFromD<D>>(left)), hn::Set(d, static_cast<hn::TFromD<D>>(y)), entry, exit);
      const auto inBox = hn::FirstN(d, static_cast<std::size_t>(box.GetWidth() - left));
      const auto covered = hn::And(inBox, hn::Lt(exit.U, entry.U));
      q.Count = AppendFragments(covered, entry.U, exit.U, entry.S, exit.S,
        Ramp(di, corner + y * TileSize::Pixels + left), q.Count, q);
    }
  }
}

/// `faceAt`: as that of class CellFaces.
template <class D, class FaceAt>
void CheckCell(const ConvexTileTask& task, const TileRectangle& tile, int id, const CellBox& box, const FaceAt& faceAt,
  TileFragments& q, ConvexSpanErrors& errors)
{
  const CellEnds<D> ends(task, id, box, faceAt);
  if (!ends.AreBoth())
  {
    return;
  }
  const int corner = CornerPixel(box, tile);
  const RowSpans spans(EdgeList(task, id, box, faceAt), box, std::is_same_v<D, LaneDouble>);
  CoverAll(ends, box, corner, q);
  const std::vector<ConvexFragment> all = TakeFragments(q);
  CoverSpans(ends, spans, box.GetHeight(), corner, q);
  CompareFragments(all, TakeFragments(q), errors);
  for (int row = 0; row < box.GetHeight(); ++row)
  {
    const int first = spans.First[row], last = spans.Last[row];
    errors.Held += std::max(last - first + 1, 0);
    errors.Outside += first < 0 || last >= box.GetWidth() ? 1 : 0;
    ++errors.Rows;
  }
}

void CheckConvexSpans(const ConvexTileTask& task, const TileRectangle& tile, ConvexSpanErrors& errors)
{
  const auto q = std::make_unique<TileFragments>();
  for (int id = 0; id < task.Mesh->GetNumberOfCells(); ++id)
  {
    const CellBox box(task.Cells->Boxes[id], tile);
    const bool isExact = task.Cells->Exact[id] != ConvexTileCells::None;
    const int begin = task.Mesh->Faces.Offsets[id];
    ScreenFaces inDouble;
    if (box.GetWidth() <= 0 || box.GetHeight() <= 0 || (isExact && !inDouble.SetUp(task, id)))
    {
      continue;
    }
    ++errors.Cells;
    errors.Exact += isExact ? 1 : 0;
    const auto face = [&](int at) -> const ConvexTileFace& { return task.Faces->Values[task.Mesh->Faces.Values[at]]; };
    const auto doubleFace = [&](int at) -> const ScreenFaces::Face& { return inDouble[at - begin]; };
    for (int at = begin; at < task.Mesh->Faces.Offsets[id + 1]; ++at)
    {
      errors.Mixed += face(at).IsMixed != 0.0f ? 1 : 0;
    }
    isExact ? CheckCell<LaneDouble>(task, tile, id, box, doubleFace, *q, errors)
            : CheckCell<CoverFloat>(task, tile, id, box, face, *q, errors);
  }
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "HardConvexCells.h"
#include "TestScene.h"
#include "TileClusters.h"

#include "vtkUnstructuredGrid.h"

#include <hwy/targets.h>

#include <glm/gtc/matrix_transform.hpp>

#include <iostream>

namespace CellProjectionTiles
{
HWY_EXPORT(CheckConvexSpans);
}

namespace
{
/// Cells as an engine holds them; a view of them.
struct Frame
{
  std::vector<float> Points;
  ConvexCellFaces Loops;
  FacePieces Pieces;
  CellPlanes Planes;
  ConvexTileMesh Mesh;
  TileClusters Clusters;
  TileView View;
  TileVertices Vertices;
  ConvexTileFaces Faces;
  ConvexTileCells Cells;
  ConvexTileTask Task;

  explicit Frame(vtkUnstructuredGrid* grid)
  {
    std::vector<float> scalars;
    for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
    {
      double x[3];
      grid->GetPoint(id, x);
      for (const double k : x)
      {
        this->Points.push_back(static_cast<float>(k));
      }
      this->Points.push_back(0.0f);
      scalars.push_back(static_cast<float>(0.5 + 0.2 * x[0] + 0.1 * x[1]));
    }
    this->Loops.Build(grid);
    this->Pieces.Build(this->Points, this->Loops.Loops);
    this->Planes.Build(this->Points, this->Loops, this->Pieces);
    this->Mesh.Build(this->Points, this->Loops, this->Pieces, this->Planes);
    this->Mesh.SetScalars(scalars, false, 1.0f);
    std::vector<unsigned int> drawn(static_cast<std::size_t>(grid->GetNumberOfCells()));
    for (std::size_t i = 0; i < drawn.size(); ++i)
    {
      drawn[i] = static_cast<unsigned int>(i);
    }
    this->Mesh.SetDrawn(drawn);
    this->Clusters.Build(this->Mesh);
    this->Clusters.SeeAll();
  }

  void LookFrom(const TileView::Camera& camera, bool allExact)
  {
    this->View.Build(camera);
    this->Vertices.Transform(this->Mesh.Points, this->View);
    // So thin that floats are trusted wherever they are numbers.
    ConvexTileFaces::Bounds bounds;
    bounds.Density = 1e-6;
    bounds.ScalarError = 1e3;
    bounds.Steep = 1e6;
    this->Faces.Project(this->Mesh, this->View, this->Vertices, this->Clusters.GetFaces(), bounds);
    this->Cells.Project(this->Mesh, this->View, this->Vertices, this->Clusters, this->Faces, allExact);
    this->Task.Mesh = &this->Mesh;
    this->Task.Bounds = bounds;
    this->Task.Faces = &this->Faces;
    this->Task.Cells = &this->Cells;
    this->Task.Common.View = &this->View;
    this->Task.Common.Vertices = &this->Vertices;
  }
};

// Parallel along rows and columns of pixels, and in perspective.
TileView::Camera MakeCamera(bool isParallel)
{
  TileView::Camera camera;
  const glm::dvec3 eye(0.3, 0.2, 3.0);
  camera.MeshToView = isParallel ? glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -3.0))
                                 : glm::lookAt(eye, glm::dvec3(0.0), glm::dvec3(0.1, 1.0, 0.0));
  camera.ViewToClip = isParallel ? glm::ortho(-1.0, 1.0, -1.0, 1.0, 1.0, 5.0) : glm::perspective(0.7, 1.0, 1.0, 6.0);
  camera.Width = camera.Height = 128;
  return camera;
}

void CheckKind(TestChecks& checks, int kind, bool allExact)
{
  // Those are large.
  const int count = kind == HardConvexCells::AlongRows ? 120 : 300;
  Frame frame(HardConvexCells::Make(kind, count, 3u + static_cast<unsigned int>(kind)));
  ConvexSpanErrors errors;
  for (const bool isParallel : { true, false })
  {
    frame.LookFrom(MakeCamera(isParallel), allExact);
    for (int tile = 0; tile < 4; ++tile)
    {
      HWY_DYNAMIC_DISPATCH(CellProjectionTiles::CheckConvexSpans)(
        frame.Task, TileRectangle::OfTile(tile, 128, 128), errors);
    }
  }
  std::cout << "  " << HardConvexCells::GetName(kind) << ": " << errors.Cells << " cells, " << errors.Exact
            << " in double, " << errors.Mixed << " mixed faces, " << errors.Covered << " pixels, " << errors.Missed
            << " missed of " << errors.MissedExtent << ", " << errors.Different << " found otherwise, " << errors.Held
            << " held in " << errors.Rows << " rows\n";
  // What is next to nothing may reach over its edges by rounding of its planes in floats, or end beside a row.
  const bool isFine = !allExact && (kind == HardConvexCells::Flat || kind == HardConvexCells::BesideRows);
  CHECK(errors.Missed <= (isFine ? 3 : 0));
  CHECK_AT_MOST(errors.MissedExtent, 1e-8);
  CHECK(errors.Different == 0);
  CHECK(errors.Outside == 0);
  CHECK(errors.Held - errors.Covered < errors.Rows / 2);
  CHECK(errors.Cells > 200 && errors.Covered > 200);
}
}

int TestConvexTileSpans(int, char*[])
{
  TestChecks checks;
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    hwy::GetChosenTarget().Update(target);
    std::cout << hwy::TargetName(target) << "\n";
    for (int kind = 0; kind < HardConvexCells::NumberOfKinds; ++kind)
    {
      CheckKind(checks, kind, false);
      CheckKind(checks, kind, true);
    }
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return checks.Result();
}
#endif
