// Rays that begin just before an eye among the cells: for every instruction set that this machine has the Tiles engine
// cuts them in parts that follow one on another, none with too many digits for a float, from where a ray enters a cell
// to where it leaves it by the planes one by one; and hands the queue on between rows of a cell that would fill it.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "TestTileParts.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "TileCoverage-inl.h"
#include "TileMesh.h"
#include "TileSpanOracle.h"

#ifndef TestTileParts_Errors
#define TestTileParts_Errors
struct TilePartErrors
{
  /// How far inside a cell a pixel lies that is left out, how far outside one that is not; in pixels.
  double Missed = 0.0, Held = 0.0;
  /// As a share of the weight there: of where rays enter, leave, and go on in the next part.
  double Entries = 0.0, Exits = 0.0, Gaps = 0.0;
  /// Of scalars as a share of their terms, of how far the weight falls along a part as a share of how far it may.
  double Scalars = 0.0, Shares = 0.0;
  /// Fragments that are no cell's or not in their turn, queues that are too full.
  int Wrong = 0;
  int Queues = 0, Rays = 0, CutRays = 0, MostParts = 0;
};
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
class PartCheck
{
public:
  PartCheck(const TileTask& task, const TileRectangle& tile, TilePartErrors& errors)
    : Task(task)
    , View(*task.View)
    , Tile(tile)
    , Errors(errors)
    , Parts(TileSize::Pixels * TileSize::Pixels)
  {
    this->Queue.NamesCells = true;
    this->Forget();
  }

  // All of the mesh in double, as the engine does.
  void CoverCells()
  {
    const int cells = this->Task.Mesh->GetNumberOfCells();
    TileGroup group;
    std::fill_n(group.Exact, TileGroup::Size, 1);
    for (this->Cell = 0; this->Cell < cells; ++this->Cell)
    {
      std::uint32_t box;
      const int ids[1] = { this->Cell };
      CoverGroup(this->Task, this->Tile, group, ids, 0, 1, &box, this->Queue, [this] { this->HandOn(); });
      // Full or not: the next cell is another one.
      this->HandOn();
      this->CheckCell();
    }
  }

private:
  struct Part
  {
    double Entry, Exit, ScalarIn, ScalarOut;
  };

  void HandOn()
  {
    TileFragments& q = this->Queue;
    // What is packed is stored in whole vectors.
    this->Errors.Wrong += q.Count > TileFragments::Capacity - 64 ? 1 : 0;
    q.NameCells();
    for (int at = 0; at < q.Count; ++at)
    {
      const int pixel = q.Pixel[at];
      const bool isGood = q.Cell[at] == this->Cell && pixel >= 0 && pixel < TileSize::Pixels * TileSize::Pixels;
      this->Errors.Wrong += isGood ? 0 : 1;
      this->Parts[isGood ? pixel : 0].push_back(
        { q.Entry[at], static_cast<double>(q.Entry[at]) - q.Extent[at], q.ScalarIn[at], q.ScalarOut[at] });
    }
    this->Errors.Queues += q.Count > 0 ? 1 : 0;
    this->Forget();
  }

  void Forget()
  {
    std::fill_n(this->Queue.Pixel, TileFragments::Capacity, -1);
    std::fill_n(this->Queue.Cell, TileFragments::Capacity, -1);
    this->Queue.Count = 0;
  }

  void CheckCell()
  {
    const TileSpanOracle oracle(TileExactCell(*this->Task.Mesh, this->View, this->Cell), this->View);
    for (int pixel = 0; pixel < TileSize::Pixels * TileSize::Pixels; ++pixel)
    {
      const int x = this->Tile.Left + pixel % TileSize::Pixels, y = this->Tile.Bottom + pixel / TileSize::Pixels;
      std::vector<Part>& parts = this->Parts[pixel];
      if (x <= this->Tile.LastX && y <= this->Tile.LastY)
      {
        this->CheckRay(oracle, x, y, parts);
      }
      else
      {
        this->Errors.Wrong += static_cast<int>(parts.size());
      }
      parts.clear();
    }
  }

  void CheckRay(const TileSpanOracle& oracle, int x, int y, const std::vector<Part>& parts)
  {
    const TileSpanOracle::Ray ray = oracle.Cross(x, y);
    (parts.empty() ? this->Errors.Missed : this->Errors.Held) =
      parts.empty() ? std::max(this->Errors.Missed, ray.Inside) : std::max(this->Errors.Held, -ray.Inside);
    // Along a plane a ray enters anywhere.
    if (parts.empty() || ray.Inside < 1e-7)
    {
      return;
    }
    const double most = TileExactCell::MostWeight * this->WeightAt(ray.Exit);
    const double first = std::min(this->WeightAt(ray.Entry), most);
    Raise(this->Errors.Entries, std::abs(this->WeightAt(parts.front().Entry) - first) / first);
    Raise(this->Errors.Exits, std::abs(parts.back().Exit - ray.Exit) / this->ScaleAt(ray.Exit));
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      this->CheckPart(oracle, x, y, parts, i);
    }
    ++this->Errors.Rays;
    this->Errors.CutRays += parts.size() > 1 ? 1 : 0;
    this->Errors.MostParts = std::max(this->Errors.MostParts, static_cast<int>(parts.size()));
  }

  void CheckPart(const TileSpanOracle& oracle, int x, int y, const std::vector<Part>& parts, std::size_t i)
  {
    const Part& part = parts[i];
    const bool isLast = i + 1 == parts.size();
    // The last part may be short, no other one is.
    const double share = this->WeightAt(part.Exit) / this->WeightAt(part.Entry) / TileExactCell::LeastShare - 1.0;
    Raise(this->Errors.Shares, isLast ? -share : std::abs(share));
    const TileSpanOracle::Scalar in = oracle.ScalarAt(x, y, part.Entry), out = oracle.ScalarAt(x, y, part.Exit);
    Raise(this->Errors.Scalars, std::abs(part.ScalarIn - in.Value) / in.Terms);
    Raise(this->Errors.Scalars, std::abs(part.ScalarOut - out.Value) / out.Terms);
    if (!isLast)
    {
      Raise(this->Errors.Gaps, std::abs(parts[i + 1].Entry - part.Exit) / this->ScaleAt(part.Exit));
    }
  }

  static void Raise(double& error, double value) { error = value <= error ? error : value; }
  double WeightAt(double u) const { return this->View.WeightScale * u + this->View.WeightOffset; }
  // What a float that stands for u is rounded by a share of.
  double ScaleAt(double u) const { return this->WeightAt(u) + std::abs(this->View.WeightOffset); }

  const TileTask& Task;
  const TileView& View;
  const TileRectangle Tile;
  TilePartErrors& Errors;
  int Cell = 0;
  TileFragments Queue;
  /// Of the cell, for each pixel of the tile in the order that they came in.
  std::vector<std::vector<Part>> Parts;
};

void CheckParts(const TileTask& task, const TileRectangle& tile, TilePartErrors& errors)
{
  std::make_unique<PartCheck>(task, tile, errors)->CoverCells();
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "TestScene.h"
#include "TileArrays.h"

#include <hwy/targets.h>

#include <glm/gtc/matrix_transform.hpp>

#include <iostream>

namespace CellProjectionTiles
{
HWY_EXPORT(CheckParts);
}

namespace
{
TilePartErrors CheckView(const TileMesh& mesh, const glm::dvec3& eye, double nearPlane)
{
  TileView::Camera camera;
  camera.Width = 100;
  camera.Height = 70;
  camera.MeshToView = glm::lookAt(eye, glm::dvec3(0.4, 0.2, 0.1), glm::dvec3(0.1, 1.0, 0.0));
  camera.ViewToClip = glm::perspective(1.2, 10.0 / 7.0, nearPlane, 20.0);
  TileView view;
  view.Build(camera);
  TileTask task;
  task.Mesh = &mesh;
  task.View = &view;
  TilePartErrors errors;
  for (int tile = 0; tile < 4; ++tile)
  {
    HWY_DYNAMIC_DISPATCH(CellProjectionTiles::CheckParts)
    (task, TileRectangle::OfTile(tile, camera.Width, camera.Height), errors);
  }
  std::cout << "  near plane at " << nearPlane << ": " << errors.Rays << " rays, " << errors.CutRays << " cut, "
            << errors.MostParts << " parts at most, " << errors.Queues << " queues; missed by " << errors.Missed
            << ", held by " << errors.Held << ", entries " << errors.Entries << ", exits " << errors.Exits
            << ", gaps " << errors.Gaps << ", scalars " << errors.Scalars << ", shares " << errors.Shares << "\n";
  return errors;
}

// `parts`: of the longest ray.
void CheckNearPlane(TestChecks& checks, const TileMesh& mesh, double nearPlane, int parts)
{
  // In a cell, and in the plane of a face.
  for (const glm::dvec3& eye : { glm::dvec3(0.05, 0.02, 0.11), glm::dvec3(0.25, 0.25, -0.1) })
  {
    const TilePartErrors errors = CheckView(mesh, eye, nearPlane);
    CHECK(errors.Wrong == 0);
    CHECK_AT_MOST(errors.Missed, 1e-7);
    CHECK_AT_MOST(errors.Held, 1e-7);
    CHECK_AT_MOST(errors.Entries, 5e-7);
    CHECK_AT_MOST(errors.Exits, 5e-7);
    CHECK_AT_MOST(errors.Gaps, 5e-7);
    CHECK_AT_MOST(errors.Scalars, 5e-7);
    CHECK_AT_MOST(errors.Shares, 1e-6);
    CHECK(errors.CutRays > 5000);
    CHECK(errors.MostParts >= parts && errors.MostParts <= TileExactCell::MostParts);
    // More than cells of a tile have.
    CHECK(errors.Queues > 4 * mesh.GetNumberOfCells());
  }
}
}

int TestTileParts(int, char*[])
{
  TestChecks checks;
  TileArrays arrays(1);
  for (std::size_t i = 0; i < arrays.Scalars.size(); ++i)
  {
    arrays.Points[4 * i + 3] = arrays.Scalars[i];
  }
  TileMesh mesh;
  mesh.Build(arrays.Points, arrays.Corners, [](double) {});
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    hwy::GetChosenTarget().Update(target);
    std::cout << hwy::TargetName(target) << "\n";
    CheckNearPlane(checks, mesh, 1e-9, 14);
    // All but in the eye: nothing before so many parts counts.
    CheckNearPlane(checks, mesh, 1e-14, 22);
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return checks.Result();
}
#endif
