// The rows of cells that the Tiles engine sets up in double, against all pixels of their boxes by the planes
// themselves: for every instruction set that this machine has no pixel that is covered lies outside of a row's bounds,
// and what else lies within is no farther than the bounds' margin from what any two planes leave of the row.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "TestTileExactRows.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "TileExactCoverage-inl.h"
#include "TileMesh.h"
#include "TileSpanOracle.h"

#ifndef TestTileExactRows_Errors
#define TestTileExactRows_Errors
struct TileRowErrors
{
  /// Pixels that are covered, of these outside of their row's bounds; those within the bounds, and in the boxes.
  long long Covered = 0, Missed = 0, Within = 0, Boxes = 0;
  /// Of the rows: those with bounds beyond the box.
  long long Rows = 0, Outside = 0;
  /// Of cells of which no plane is seen edge-on and no edge is level: those within a row's bounds that are not
  /// covered, at most and of all rows.
  long long Bounded = 0, Spare = 0, AllSpare = 0;
  /// In pixels along the row: how far those within lie outside of what two planes leave of it.
  double Beyond = 0.0;
};
#endif

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
// Adds what a row has that is covered, and lies outside of the bounds.
void CheckRow(const TileExactCell& cell, const TileExactRows& rows, int y, int first, int last, TileRowErrors& errors)
{
  const ExactFloat d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int left = cell.Box[0]; left <= cell.Box[2]; left += lanes)
  {
    ExactVector entry, exit;
    const auto x = Ramp(d, static_cast<double>(left));
    const auto inBox = hn::FirstN(d, static_cast<std::size_t>(cell.Box[2] - left + 1));
    const auto covered = hn::And(inBox, CoverExactLanes(cell, rows, x, y, entry, exit));
    const auto isWithin = hn::And(
      hn::Ge(x, hn::Set(d, static_cast<double>(first))), hn::Le(x, hn::Set(d, static_cast<double>(last))));
    errors.Covered += static_cast<long long>(hn::CountTrue(d, covered));
    errors.Missed += static_cast<long long>(hn::CountTrue(d, hn::AndNot(isWithin, covered)));
  }
}

void CheckRows(const TileMesh& mesh, const TileView& view, TileRowErrors& errors)
{
  for (int id = 0; id < mesh.GetNumberOfCells(); ++id)
  {
    const TileExactCell cell(mesh, view, id);
    const TileExactRows rows(cell, view);
    const TileSpanOracle oracle(cell, view);
    const bool isBounded = oracle.BoundsRows();
    const int width = std::max(cell.Box[2] - cell.Box[0] + 1, 0);
    for (int y = cell.Box[1]; y <= cell.Box[3]; ++y)
    {
      const int lane = (y - cell.Box[1]) % static_cast<int>(hn::Lanes(ExactFloat()));
      ExactBounds bounds;
      bounds.Find(rows, y - lane, cell.Box[0], cell.Box[2]);
      const int first = bounds.First[lane], last = bounds.Last[lane];
      errors.Boxes += width;
      errors.Within += std::max(last - first + 1, 0);
      errors.Outside += width > 0 && (first < cell.Box[0] || last > cell.Box[2]) ? 1 : 0;
      ++errors.Rows;
      const long long covered = errors.Covered;
      CheckRow(cell, rows, y, first, last, errors);
      const long long spare = std::max(last - first + 1, 0) - (errors.Covered - covered);
      errors.Bounded += isBounded ? 1 : 0;
      errors.Spare = std::max(errors.Spare, isBounded ? spare : 0);
      errors.AllSpare += isBounded ? spare : 0;
      for (int x = first; x <= last; ++x)
      {
        errors.Beyond = std::max(errors.Beyond, oracle.FindOutside(x, y));
      }
    }
  }
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "HardTetrahedra.h"
#include "TestScene.h"

#include <hwy/targets.h>

#include <glm/gtc/matrix_transform.hpp>

#include <iostream>
#include <numeric>
#include <vector>

namespace CellProjectionTiles
{
HWY_EXPORT(CheckRows);
}

namespace
{
// Parallel views have 32 pixels a unit.
TileMesh MakeMesh(int kind, int count)
{
  const std::vector<float> corners = HardTetrahedra(kind, count, 11u + static_cast<unsigned int>(kind)).Corners;
  std::vector<float> points;
  for (std::size_t i = 0; i < corners.size(); i += 4)
  {
    points.insert(points.end(), { (corners[i] + 0.5f) / 32.0f - 1.0f, (corners[i + 1] + 0.5f) / 32.0f - 1.0f,
      corners[i + 2], 0.0f });
  }
  std::vector<int> ids(points.size() / 4);
  std::iota(ids.begin(), ids.end(), 0);
  TileMesh mesh;
  mesh.Build(points, ids, [](double) {});
  return mesh;
}

// Parallel along rows and columns of pixels; from outside; from among the cells.
std::vector<TileView::Camera> MakeCameras()
{
  std::vector<TileView::Camera> cameras(4);
  cameras[0].MeshToView = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -3.0));
  cameras[0].ViewToClip = glm::ortho(-1.0, 1.0, -1.0, 1.0, 2.0, 4.0);
  const glm::dvec3 eyes[3] = { { 0.2, 0.1, 3.0 }, { 0.1, -0.3, 0.05 }, { 0.4, 0.3, 0.2 } };
  for (int i = 0; i < 3; ++i)
  {
    TileView::Camera& camera = cameras[i + 1];
    camera.MeshToView = glm::lookAt(eyes[i], glm::dvec3(0.0), glm::dvec3(0.1, 1.0, 0.0));
    camera.ViewToClip = glm::perspective(i == 0 ? 0.7 : 1.4, 1.0, i == 0 ? 1.0 : 0.01, 10.0);
  }
  for (TileView::Camera& camera : cameras)
  {
    camera.Width = camera.Height = 64;
  }
  return cameras;
}

void CheckKind(TestChecks& checks, int kind)
{
  const TileMesh mesh = MakeMesh(kind, 300);
  TileRowErrors errors;
  for (const TileView::Camera& camera : MakeCameras())
  {
    TileView view;
    CHECK(view.Build(camera));
    HWY_DYNAMIC_DISPATCH(CellProjectionTiles::CheckRows)(mesh, view, errors);
  }
  std::cout << "  " << HardTetrahedra::GetName(kind) << ": of " << errors.Boxes << " pixels in boxes "
            << errors.Covered << " are covered, " << errors.Missed << " missed, " << errors.Within
            << " within the bounds of " << errors.Rows << " rows, " << errors.Beyond << " pixels beside at most; "
            << errors.AllSpare << " spare, " << errors.Spare << " at most, in " << errors.Bounded << " bounded rows\n";
  CHECK(errors.Missed == 0);
  CHECK(errors.Outside == 0);
  CHECK(errors.Covered > 100);
  // A 64th of a pixel more on either side.
  CHECK_AT_MOST(errors.Beyond, 1.0 / 64.0 + 1e-9);
  CHECK(errors.Spare <= 2);
  CHECK(errors.Bounded > errors.Rows / 2);
  CHECK(errors.AllSpare < errors.Bounded / 12);
}
}

int TestTileExactRows(int, char*[])
{
  TestChecks checks;
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    hwy::GetChosenTarget().Update(target);
    std::cout << hwy::TargetName(target) << "\n";
    for (int kind = 0; kind < HardTetrahedra::NumberOfKinds; ++kind)
    {
      CheckKind(checks, kind);
    }
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return checks.Result();
}
#endif
