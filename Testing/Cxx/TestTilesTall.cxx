// Large images are drawn in tall tiles: as the same image in strips, whose tiles are square, but for rounding. Whether
// the order is known, proven or wrong, and behind opaque pixels; the same bytes for any number of threads.

#include "TestScene.h"
#include "TileArrays.h"
#include "TileCells.h"

#include "vtkSMPTools.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <iostream>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace
{
using Image = std::vector<float>;
constexpr int Size = 1024;
constexpr int StripRows = 64;

// Where the mesh covers a part of many tiles.
void SetUp(TileArrays& arrays, double unitDistance)
{
  arrays.SetMesh();
  arrays.SetFunction(false, unitDistance);
  arrays.LookFrom({ 1.5, 2.0, 3.5 }, 55.0, Size, Size);
}

// The image of `arrays`, of which nothing changes, strip after strip.
Image DrawStrips(TestChecks& checks, TileArrays& arrays)
{
  const TileView::Camera whole = arrays.Scene.Camera;
  Image image;
  for (int first = 0; first < Size; first += StripRows)
  {
    const double middle = (2.0 * first + StripRows) / Size - 1.0, stretch = double(Size) / StripRows;
    const glm::dmat4 strip = glm::translate(
      glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, stretch, 1.0)), glm::dvec3(0.0, -middle, 0.0));
    arrays.Scene.Camera.ViewToClip = strip * whole.ViewToClip;
    arrays.Scene.Camera.Height = StripRows;
    CHECK(arrays.Render());
    image.insert(image.end(), arrays.Engine.GetImage().begin(), arrays.Engine.GetImage().end());
  }
  arrays.Scene.Camera = whole;
  return image;
}

// Returns what was counted in the image as a whole.
TileCounts CompareStrips(TestChecks& checks, TileArrays& arrays, const std::string& name)
{
  CHECK(arrays.Render());
  const Image whole = arrays.Engine.GetImage();
  const TileCounts counts = arrays.Engine.GetCounts();
  std::cout << name << ": " << counts.RepairedPixels << " pixels repaired, " << counts.HiddenCells
            << " cells hidden\n";
  CHECK(*std::max_element(whole.begin(), whole.end()) > 0.1f);
  CHECK_AT_MOST(TileArrays::LargestDifference(whole, DrawStrips(checks, arrays)), 2e-5);
  return counts;
}

void CheckShapes(TestChecks& checks)
{
  CHECK(TileSize::RowShiftOf(Size, Size, 1000) == TileSize::TallShift);
  CHECK(TileSize::RowShiftOf(Size, StripRows, 1000) == TileSize::Shift);
  CHECK(TileSize::RowShiftOf(512, 512, 1000) == TileSize::Shift);
  CHECK(TileSize::RowShiftOf(Size, Size, 4'000'000) == TileSize::Shift);
}

void CheckOrders(TestChecks& checks)
{
  TileArrays arrays(5);
  SetUp(arrays, 0.2);
  const TileCounts known = CompareStrips(checks, arrays, "order known");
  CHECK(known.RepairedPixels == 0 && known.TrustedFragments > 0);
  arrays.Scene.TrustsOrder = false;
  CHECK(CompareStrips(checks, arrays, "order proven").TrustedFragments == 0);
  std::vector<vtkIdType> order(static_cast<std::size_t>(arrays.GetNumberOfCells()));
  std::iota(order.begin(), order.end(), vtkIdType(0));
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  arrays.Scene.BackToFront = &order;
  CHECK(CompareStrips(checks, arrays, "order wrong").RepairedPixels > Size * Size / 20);
}

// A second mesh before the first one or behind it, seen from where SetUp looks from: rays enter twice.
void CheckGap(TestChecks& checks)
{
  for (const float side : { -1.0f, 1.0f })
  {
    TileArrays arrays(4);
    const std::vector<float> first = arrays.Points, scalars = arrays.Scalars;
    const std::vector<int> corners = arrays.Corners;
    const float way[4] = { 0.3f * side, 0.4f * side, 0.7f * side, 0.0f };
    for (std::size_t i = 0; i < first.size(); ++i)
    {
      arrays.Points[i] = 0.4f * first[i] - way[i % 4];
      arrays.Points.push_back(0.4f * first[i] + way[i % 4]);
    }
    arrays.Scalars.insert(arrays.Scalars.end(), scalars.begin(), scalars.end());
    for (const int corner : corners)
    {
      arrays.Corners.push_back(corner + static_cast<int>(scalars.size()));
    }
    SetUp(arrays, 0.1);
    CHECK(CompareStrips(checks, arrays, side > 0.0f ? "a mesh before" : "a mesh behind").RepairedPixels > 0);
  }
}

void CheckDense(TestChecks& checks)
{
  TileArrays arrays(16);
  SetUp(arrays, 0.004);
  CHECK(CompareStrips(checks, arrays, "dense").HiddenCells > 0);
}

void CheckThreads(TestChecks& checks)
{
  TileArrays arrays(8);
  SetUp(arrays, 0.2);
  std::vector<Image> images;
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::Initialize(threads);
    CHECK(arrays.Render());
    images.push_back(arrays.Engine.GetImage());
    CHECK(images.back() == images.front());
  }
  vtkSMPTools::Initialize(0);
}
}

int TestTilesTall(int, char*[])
{
  TestChecks checks;
  CheckShapes(checks);
  CheckOrders(checks);
  CheckGap(checks);
  CheckDense(checks);
  CheckThreads(checks);
  return checks.Result();
}
