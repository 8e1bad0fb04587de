// The order of a tile's cells on plain arrays: any part of a lattice comes with every cell before those behind
// it, circles are found, and what they leave behind changes nothing of the tiles that follow.

#include "TestScene.h"
#include "TileArrays.h"
#include "TileClusters.h"
#include "TileOrder.h"
#include "TileTask.h"
#include "TileVertices.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>
#include <vector>

namespace
{
using Ids = std::vector<int>;

struct Tile
{
  TileMesh Mesh;
  TileView View;
  TileVertices Vertices;
  TileClusters Clusters;
  TileCells Cells;
  TileTask Task;

  Tile()
  {
    TileArrays arrays(6);
    arrays.LookFrom({ 1.9, 1.5, 3.5 }, 35.0, 64, 64);
    this->View.Build(arrays.Scene.Camera);
    this->Mesh.Build(arrays.Points, arrays.Corners, [](double) {});
    this->Vertices.Transform(this->Mesh.Points, this->View);
    this->Clusters.Build(this->Mesh);
    this->Clusters.SeeAll();
    this->Cells.Project(this->Mesh, this->View, this->Vertices, this->Clusters);
    this->Task.Mesh = &this->Mesh;
    this->Task.View = &this->View;
    this->Task.Vertices = &this->Vertices;
    this->Task.Cells = &this->Cells;
  }

  /// Every cell with that probability, ascending.
  Ids TakeSome(double share, unsigned int seed) const
  {
    std::mt19937 random(seed);
    std::bernoulli_distribution isTaken(share);
    Ids ids;
    for (int cell = 0; cell < this->Mesh.GetNumberOfCells(); ++cell)
    {
      if (isTaken(random))
      {
        ids.push_back(cell);
      }
    }
    return ids;
  }

  /// Cells that come after one behind them.
  int CountWrong(const Ids& order) const
  {
    std::vector<int> places(static_cast<std::size_t>(this->Mesh.GetNumberOfCells()), -1);
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      places[order[i]] = static_cast<int>(i);
    }
    int wrong = 0;
    for (const int cell : order)
    {
      for (int f = 0; f < 4; ++f)
      {
        const bool leaves = (this->Cells.Faces[cell] >> f & 1) != 0;
        const int behind = leaves ? this->Mesh.Neighbours[4 * cell + f] : cell;
        wrong += places[behind] >= 0 && places[behind] < places[cell] ? 1 : 0;
      }
    }
    return wrong;
  }

  /// Cells of which none has a face of another one, and all of which are known in floats.
  Ids TakeApart(double share, unsigned int seed) const
  {
    std::vector<char> isTaken(static_cast<std::size_t>(this->Mesh.GetNumberOfCells()), 0);
    Ids ids;
    for (const int cell : this->TakeSome(share, seed))
    {
      const int* neighbours = &this->Mesh.Neighbours[4 * cell];
      const bool isApart = std::none_of(
        neighbours, neighbours + 4, [&isTaken](int other) { return other >= 0 && isTaken[other] != 0; });
      if (isApart && (this->Cells.Faces[cell] & TileCells::Exact) == 0)
      {
        isTaken[cell] = 1;
        ids.push_back(cell);
      }
    }
    return ids;
  }

  /// How far a cell's nearest corner is.
  double DepthOf(int cell) const
  {
    double u = -1e30;
    for (int k = 0; k < 4; ++k)
    {
      u = std::max<double>(u, this->Vertices.Values[4 * this->Mesh.Corners[4 * cell + k] + 2]);
    }
    return 1.0 / (u + this->View.WeightOffset);
  }

  /// Lets a cell and one behind it hide each other; returns whether there was one.
  bool MakeCircle(int cell)
  {
    for (int f = 0; f < 4; ++f)
    {
      const int behind = this->Mesh.Neighbours[4 * cell + f];
      if ((this->Cells.Faces[cell] >> f & 1) == 0)
      {
        continue;
      }
      const int* back = &this->Mesh.Neighbours[4 * behind];
      const auto face = std::find(back, back + 4, cell) - back;
      this->Cells.Faces[behind] = static_cast<std::uint8_t>(this->Cells.Faces[behind] | 1 << face);
      return true;
    }
    return false;
  }
};

bool Sort(TileOrder& order, const Tile& tile, Ids& ids)
{
  Ids work;
  return order.Sort(tile.Task, ids.data(), static_cast<int>(ids.size()), work);
}

bool HasEntered(const TileOrder& order, const Tile& tile, const Ids& ids)
{
  Ids entered;
  std::copy_if(ids.begin(), ids.end(), std::back_inserter(entered),
    [&tile](int cell) { return (tile.Cells.Faces[cell] & TileCells::Entered) != 0; });
  return !entered.empty() && order.GetEntered() == entered;
}

void CheckParts(TestChecks& checks, const Tile& tile, bool isProven)
{
  TileOrder order;
  // The fewest: less than what is taken at a time.
  for (const double share : { 1.0, 0.7, 0.3, 0.002 })
  {
    for (unsigned int seed = 0; seed < 5; ++seed)
    {
      const Ids ids = tile.TakeSome(share, seed);
      Ids sorted = ids;
      CHECK(Sort(order, tile, sorted) == isProven);
      CHECK(share < 0.1 || HasEntered(order, tile, ids));
      CHECK(tile.CountWrong(sorted) == 0);
      std::sort(sorted.begin(), sorted.end());
      CHECK(sorted == ids);
    }
  }
  Ids none;
  CHECK(Sort(order, tile, none) == isProven && order.GetEntered().empty());
}

void CheckCircles(TestChecks& checks, Tile tile)
{
  tile.Task.Mesh = &tile.Mesh;
  tile.Task.Cells = &tile.Cells;
  const std::vector<std::uint8_t> faces = tile.Cells.Faces;
  const Ids ids = tile.TakeSome(0.8, 9);
  TileOrder order;
  int circles = 0;
  for (int cell = 100; cell < 120; ++cell)
  {
    circles += tile.MakeCircle(cell) ? 1 : 0;
  }
  CHECK(circles > 10);
  // So often that what a tile might leave behind would add up to a cell of the next one.
  for (int round = 0; round < 200; ++round)
  {
    Ids sorted = ids;
    CHECK(!Sort(order, tile, sorted));
    std::sort(sorted.begin(), sorted.end());
    CHECK(sorted == ids);
  }
  // Without circles, and of other cells.
  tile.Cells.Faces = faces;
  for (const double share : { 0.5, 0.8, 1.0 })
  {
    Ids again = tile.TakeSome(share, 9), fresh = again;
    TileOrder other;
    CHECK(Sort(order, tile, again) == Sort(other, tile, fresh));
    CHECK(again == fresh);
    CHECK(tile.CountWrong(again) == 0);
  }
}

// Of a sparse mesh those that nothing hides come nearest first, but for what is less than a step of the tile's depth.
void CheckNearest(TestChecks& checks, const Tile& tile)
{
  TileOrder order;
  for (unsigned int seed = 0; seed < 5; ++seed)
  {
    Ids ids = tile.TakeApart(0.5, seed);
    CHECK(ids.size() > 100);
    std::vector<double> depths;
    Sort(order, tile, ids);
    std::transform(
      ids.begin(), ids.end(), std::back_inserter(depths), [&tile](int cell) { return tile.DepthOf(cell); });
    const auto ends = std::minmax_element(depths.begin(), depths.end());
    const double step = (*ends.second - *ends.first) / 250.0;
    const bool isNearest = std::is_sorted(
      depths.begin(), depths.end(), [step](double later, double depth) { return later < depth - step; });
    CHECK(step > 0.0 && isNearest);
  }
}
}

int TestTileOrder(int, char*[])
{
  TestChecks checks;
  Tile tile;
  CheckParts(checks, tile, true);
  CheckCircles(checks, tile);
  std::vector<unsigned char> few(static_cast<std::size_t>(tile.Mesh.GetNumberOfCells()), 0);
  few[0] = 1;
  tile.Mesh.SetDrawn(few);
  CheckParts(checks, tile, false);
  CheckNearest(checks, tile);
  CheckCircles(checks, tile);
  return checks.Result();
}
