// The Tiles engine at its limits, on plain arrays: images of one pixel or one row, cells a million times
// larger than a pixel or smaller than a millionth, points behind the eye, planes and points that are
// infinite or no numbers, 100,000 cells in one pixel. Never a crash; numbers where there are some.

#include "TestScene.h"
#include "TileArrays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
constexpr int Size = 80;

bool IsFinite(const std::vector<float>& image)
{
  return std::all_of(image.begin(), image.end(), [](float x) { return std::isfinite(x); });
}

double AlphaAt(const TileArrays& arrays, int x, int y)
{
  return arrays.Engine.GetImage()[4 * (y * arrays.Scene.Camera.Width + x) + 3];
}

void Scale(TileArrays& arrays, float factor)
{
  for (float& x : arrays.Points)
  {
    x *= factor;
  }
}

void CheckSizes(TestChecks& checks)
{
  TileArrays arrays(3);
  arrays.SetFunction(false);
  arrays.SetMesh();
  for (const auto& size : { std::array<int, 2>{ { 1, 1 } }, { { 1, 200 } }, { { 200, 1 } },
         { { 64, 65 } }, { { 0, 0 } }, { { 0, 5 } }, { { 5, -1 } } })
  {
    arrays.LookFrom({ 1.0, 2.0, 4.0 }, 30.0, std::max(size[0], 1), std::max(size[1], 1));
    arrays.Scene.Camera.Width = size[0];
    arrays.Scene.Camera.Height = size[1];
    const bool hasPixels = size[0] > 0 && size[1] > 0;
    CHECK(arrays.Render() == hasPixels);
    if (hasPixels)
    {
      CHECK(IsFinite(arrays.Engine.GetImage()));
      CHECK(AlphaAt(arrays, size[0] / 2, size[1] / 2) > 0.1);
    }
  }
}

// Through the middle of cells the way is all of the near part: alpha is that of the length.
void CheckLargeCells(TestChecks& checks)
{
  TileArrays arrays(1);
  arrays.SetFunction(false, 1e6);

  arrays.SetMesh();
  // The eye a millionth before a face: its pixels are a millionth of the cells.
  arrays.LookFrom({ 0.1, 0.2, 1.0 + 1e-6 }, 1e-4, Size, Size);
  CHECK(arrays.Render());
  CHECK(IsFinite(arrays.Engine.GetImage()));
  // Inside, points all around.
  arrays.SetFunction(false, 2.0);
  arrays.LookFrom({ 0.1, 0.2, 0.3 }, 100.0, Size, Size);
  CHECK(arrays.Render());
  CHECK(IsFinite(arrays.Engine.GetImage()));
  for (const int pixel : { 0, Size / 2, Size - 1 })
  {
    CHECK(AlphaAt(arrays, pixel, pixel) > 0.05 && AlphaAt(arrays, pixel, pixel) < 1.0);
  }
}

void CheckSmallCells(TestChecks& checks)
{
  // 100,000 cells and more in one pixel, and each less than a millionth of it.
  TileArrays arrays(26);
  CHECK(arrays.GetNumberOfCells() > 100000);
  arrays.SetFunction(false, 1e-3);
  Scale(arrays, 2e-3f);
  arrays.SetMesh();
  arrays.LookFrom({ 0.0, 0.1, 5.0 }, 30.0, Size + 1, Size + 1);
  CHECK(arrays.Render());
  CHECK(IsFinite(arrays.Engine.GetImage()));
  const std::vector<float> image = arrays.Engine.GetImage();
  // One ray through the middle of the viewport meets it.
  CHECK(AlphaAt(arrays, Size / 2, Size / 2) > 0.5);
  const auto lit = std::count_if(image.begin(), image.end(), [](float x) { return x > 0.0f; });
  CHECK(lit >= 4 && lit <= 16);
}

void CheckBehindTheEye(TestChecks& checks)
{
  TileArrays arrays(3);
  arrays.SetFunction(false);
  for (std::size_t at = 2; at < arrays.Points.size(); at += 4)
  {
    arrays.Points[at] += 8.0f;
  }
  arrays.SetMesh();
  arrays.LookFrom({ 0.0, 0.1, 5.0 }, 30.0, Size, Size);
  CHECK(arrays.Render());
  const std::vector<float>& image = arrays.Engine.GetImage();
  CHECK(std::all_of(image.begin(), image.end(), [](float x) { return x == 0.0f; }));
}

void CheckInfinity(TestChecks& checks)
{
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float value : { infinity, -infinity, std::nanf(""), 3e38f })
  {
    TileArrays arrays(3);
    arrays.SetFunction(false);
    arrays.Points[4 * 21] = value;
    arrays.Points[4 * 42 + 2] = value;
    arrays.SetMesh();
    arrays.LookFrom({ 1.0, 2.0, 4.0 }, 30.0, Size, Size);
    CHECK(arrays.Render());

    TileArrays cut(3);
    cut.SetFunction(false);
    cut.SetMesh();
    cut.LookFrom({ 1.0, 2.0, 4.0 }, 30.0, Size, Size);
    cut.Scene.ClippingPlanes = { { 0.0f, 0.0f, 1.0f, value }, { value, 0.0f, 0.0f, 0.0f } };
    CHECK(cut.Render());
  }
}
}

int TestTilesExtremes(int, char*[])
{
  TestChecks checks;
  CheckSizes(checks);
  CheckLargeCells(checks);
  CheckSmallCells(checks);
  CheckBehindTheEye(checks);
  CheckInfinity(checks);
  return checks.Result();
}
