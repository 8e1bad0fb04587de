// Slender and warped cells by planes on the screen in double against rays through them in mesh coordinates:
// where rays enter and leave, the scalar there, and the rows of pixels, for every instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "TestTilesScreenFaces.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "ConvexTileCells.h"
#include "ConvexTileExactCell.h"
#include "ConvexTileMesh.h"
#include "ConvexTileRays.h"
#include "TileVertices.h"
#include "TileView.h"

#include "ConvexTileExactCoverage-inl.h"

#ifndef TestTilesScreenFaces_Found
#define TestTilesScreenFaces_Found
/// Of one cell or of many.
struct ScreenFacesFound
{
  int Cells = 0, Refused = 0, Pixels = 0;
  /// Covered by one of both alone, by more than a rounding; outside of the rows' spans; beside them.
  int Disputed = 0, Missed = 0, Spare = 0;
  /// Largest differences: of u as a share of the mesh's extent, of scalar * weight.
  double Depth = 0.0, Scalar = 0.0;
};
#endif

#include <algorithm>
#include <cmath>
#include <cstdlib>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// One pixel of a cell by both ways.
struct BothWays
{
  bool OnScreen, AlongRay;
  double Entry[2], Exit[2], ScalarIn[2], ScalarOut[2];

  BothWays(const ConvexTileTask& task, const CellEnds<LaneDouble>& ends, const CellBox& box,
    const ConvexTileExactCell& cell, int x, int y)
  {
    const LaneDouble d;
    BlockEnd<LaneDouble> entry, exit;
    ends.Find(hn::Set(d, double(x - box.FirstX)), hn::Set(d, double(y - box.FirstY)), entry, exit);
    this->Entry[0] = hn::GetLane(entry.U);
    this->Exit[0] = hn::GetLane(exit.U);
    this->ScalarIn[0] = hn::GetLane(entry.S);
    this->ScalarOut[0] = hn::GetLane(exit.S);
    this->OnScreen = this->Exit[0] < this->Entry[0];
    ConvexTileExactCell::Segment ray;
    this->AlongRay = cell.Cross(*task.Rays, x, y, ray);
    const TileView& view = *task.Common.View;
    this->Entry[1] = view.ScreenDepth(task.Rays->Reference + ray.Entry);
    this->Exit[1] = view.ScreenDepth(task.Rays->Reference + ray.Exit);
    this->ScalarIn[1] = ray.ScalarIn * (view.WeightScale * this->Entry[1] + view.WeightOffset);
    this->ScalarOut[1] = ray.ScalarOut * (view.WeightScale * this->Exit[1] + view.WeightOffset);
  }

  /// What either says is covered, as a share of the extent.
  double Longest(double extent) const
  {
    return std::max(this->OnScreen ? this->Entry[0] - this->Exit[0] : 0.0,
             this->AlongRay ? this->Entry[1] - this->Exit[1] : 0.0) / extent;
  }
};

inline void ComparePixel(
  const BothWays& both, double extent, bool isInSpan, ScreenFacesFound& found)
{
  // Shorter ones are rounding.
  constexpr double Shortest = 1e-9;
  found.Spare += isInSpan && !both.AlongRay ? 1 : 0;
  if (both.Longest(extent) < Shortest)
  {
    return;
  }
  found.Missed += isInSpan ? 0 : 1;
  if (both.OnScreen != both.AlongRay)
  {
    ++found.Disputed;
    return;
  }
  ++found.Pixels;
  found.Depth = std::max({ found.Depth, std::abs(both.Entry[0] - both.Entry[1]) / extent,
    std::abs(both.Exit[0] - both.Exit[1]) / extent });
  found.Scalar = std::max({ found.Scalar, std::abs(both.ScalarIn[0] - both.ScalarIn[1]),
    std::abs(both.ScalarOut[0] - both.ScalarOut[1]) });
}

// NOLINTNEXTLINE: Highway's dispatch table names it.
void CompareCell(const ConvexTileTask& task, const TileRectangle& tile, int id, ScreenFacesFound& found)
{
  const CellBox box(task.Cells->Boxes[id], tile);
  ScreenFaces faces;
  if (task.Cells->Exact[id] != ConvexTileCells::OnScreen || box.LastX < box.FirstX || box.LastY < box.FirstY)
  {
    return;
  }
  ++found.Cells;
  if (!faces.SetUp(task, id))
  {
    ++found.Refused;
    return;
  }
  const auto faceAt = [&](int at) -> const ScreenFaces::Face&
  { return faces[at - task.Mesh->Faces.Offsets[id]]; };
  const CellEnds<LaneDouble> ends(task, id, box, faceAt);
  const RowSpans spans(EdgeList(task, id, box, faceAt), box, true);
  ConvexTileExactCell cell;
  cell.SetUp(*task.Mesh, id);
  for (int y = box.FirstY; y <= box.LastY; ++y)
  {
    for (int x = box.FirstX; x <= box.LastX; ++x)
    {
      const int row = y - box.FirstY, column = x - box.FirstX;
      ComparePixel(BothWays(task, ends, box, cell, x, y), task.Common.View->Extent,
        spans.First[row] <= column && column <= spans.Last[row], found);
    }
  }
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "ConvexTilesFrame.h"
#include "HexahedraArrays.h"
#include "TestScene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <hwy/targets.h>

#include <iostream>
#include <random>
#include <string>

namespace CellProjectionTiles
{
HWY_EXPORT(CompareCell);
}

namespace
{
ConvexTilesFrame::Scene SeenFrom(const glm::dvec3& eye, bool isParallel)
{
  ConvexTilesFrame::Scene scene;
  scene.Camera.MeshToView = glm::lookAt(eye, glm::dvec3(0.0), glm::dvec3(0.1, 0.2, 1.0));
  scene.Camera.ViewToClip = isParallel ? glm::ortho(-1.5, 1.5, -1.5, 1.5, 0.01, 20.0)
                                       : glm::perspective(0.6, 1.0, 0.01, 20.0);
  scene.Camera.ViewToWorld = glm::inverse(scene.Camera.MeshToView);
  scene.Camera.Width = scene.Camera.Height = TileSize::Pixels;
  return scene;
}

/// All cells of a mesh that floats do not serve, seen from a dozen places.
ScreenFacesFound CompareMesh(const HexahedraArrays& arrays, bool onePerCell)
{
  ConvexTilesFrame frame;
  arrays.SetMesh(frame);
  std::vector<float> scalars = arrays.Scalars;
  scalars.resize(onePerCell ? arrays.Drawn.size() : scalars.size());
  frame.SetScalars(scalars, onePerCell, 1.0f);
  frame.SetDrawn(arrays.Drawn);
  ConvexTileFaces::Bounds bounds;
  bounds.Density = 20.0;
  ScreenFacesFound found;
  for (int i = 0; i < 12; ++i)
  {
    const double angle = 0.5 * i + 0.1;
    const auto scene = SeenFrom(
      glm::dvec3(4.0 * std::cos(angle), 4.0 * std::sin(angle), 0.4 * (i % 3)), i % 4 == 3);
    frame.SetView(scene.Camera);
    frame.SetCells(scene, bounds, i % 2 == 1);
    const TileRectangle tile = TileRectangle::OfTile(0, TileSize::Pixels, TileSize::Pixels);
    for (int cell = 0; cell < frame.Mesh.GetNumberOfCells(); ++cell)
    {
      HWY_DYNAMIC_DISPATCH(CellProjectionTiles::CompareCell)(frame.Task, tile, cell, found);
    }
  }
  return found;
}

/// `planarity`: how far from their common plane corners of a face that counts as plane may be.
void Check(const std::string& name, const ScreenFacesFound& found, TestChecks& checks,
  double planarity = 0.0)
{
  std::cout << name << ": " << found.Cells << " cells, " << found.Refused << " refused, "
            << found.Pixels << " pixels, " << found.Disputed << " disputed, " << found.Missed
            << " missed, " << found.Spare << " spare, u off by " << found.Depth << ", scalar by "
            << found.Scalar << "\n";
  CHECK(found.Pixels > 1000);
  // A third of the eyes lies in a plane of faces.
  CHECK(found.Refused < found.Cells / 3);
  CHECK(found.Disputed == 0);
  CHECK(found.Missed == 0);
  CHECK_AT_MOST(found.Spare, 0.2 * found.Pixels);
  CHECK_AT_MOST(found.Depth, 1e-12 + planarity);
  CHECK_AT_MOST(found.Scalar, 1e-12 + planarity);
}

/// A lattice as flat as `height`, its points moved by `jitter` of a cell.
HexahedraArrays Slender(double height, double jitter)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-jitter / 4.0, jitter / 4.0);
  return HexahedraArrays(8,
    [&](float* point)
    {
      const double scale[3] = { 1.0, 1.0, height };
      for (int k = 0; k < 3; ++k)
      {
        point[k] = static_cast<float>(scale[k] * (point[k] + place(random)));
      }
    });
}
}

int TestTilesScreenFaces(int, char*[])
{
  TestChecks checks;
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    hwy::GetChosenTarget().Update(target);
    const std::string name = hwy::TargetName(target);
    Check(name + " plain", CompareMesh(Slender(1.0, 0.0), false), checks);
    Check(name + " warped", CompareMesh(Slender(1.0, 0.2), false), checks);
    Check(name + " flat", CompareMesh(Slender(1e-2, 0.0), false), checks);
    Check(name + " flat and warped", CompareMesh(Slender(1e-2, 0.2), false), checks);
    Check(name + " a scalar per cell", CompareMesh(Slender(1e-2, 0.2), true), checks);
    Check(name + " hardly warped", CompareMesh(Slender(1e-3, 0.1), false), checks, 2e-6);
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return checks.Result();
}
#endif
