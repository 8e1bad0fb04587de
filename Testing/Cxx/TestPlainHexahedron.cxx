// The quick yes to hexahedra never says what the full test denies, in any numbering, winding and
// size, warped, thin, dented and folded; and it is said of those that meshes are made of.
#include "ConvexCellsTesting.h"
#include "ConvexityTest.h"
#include "PlainHexahedron.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace
{
using namespace ConvexCellsTesting;
using Ids = std::array<vtkIdType, 8>;
using Coordinates = double[8][3];

const int Corners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };

struct Counts
{
  int Plain = 0;
  int Convex = 0;
  int Wrong = 0;
};

// The same faces in a place of their own: there the quick yes is not asked.
bool IsConvexInFull(const Ids& ids, const Coordinates& points, double sign)
{
  const TetrahedralSplit::Solid copy =
    TetrahedralSplit::SolidOf(TetrahedralSplit::Shape::Hexahedron);
  return ConvexityTest::IsConvex(copy, ids.data(), points, sign);
}

Counts CountCells(double jitter, double thickness, double scale, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-jitter, jitter);
  Ids ids;
  std::iota(ids.begin(), ids.end(), vtkIdType{ 0 });
  Counts counts;
  for (int cell = 0; cell < 2000; ++cell)
  {
    Coordinates points;
    const double sign = cell % 2 ? 1.0 : -1.0, size[3] = { sign * scale, scale, thickness * scale };
    for (int i = 0; i < 24; ++i)
    {
      points[i / 3][i % 3] = size[i % 3] * (Corners[i / 3][i % 3] + shift(random));
    }
    std::shuffle(ids.begin(), ids.end(), random);
    const bool plain = PlainHexahedron::IsConvex(ids.data(), points, sign);
    const bool convex = IsConvexInFull(ids, points, sign);
    counts.Plain += plain;
    counts.Convex += convex;
    counts.Wrong += (plain && !convex) || PlainHexahedron::IsConvex(ids.data(), points, -sign);
  }
  return counts;
}

void CheckCells(double jitter, double thickness, double scale, bool manyPlain)
{
  const Counts counts = CountCells(jitter, thickness, scale, 7);
  const bool good =
    CHECK_EQUAL(counts.Wrong, 0) && CHECK(!manyPlain || counts.Plain > 0.999 * counts.Convex);
  std::cout << "jitter " << jitter << ", thickness " << thickness << ", scale " << scale << ": "
            << counts.Plain << " plain of " << counts.Convex << (good ? "\n" : ": wrong\n");
}
}

int TestPlainHexahedron(int, char*[])
{
  for (const double scale : { 1.0, 1e-30, 1e30 })
  {
    for (const double thickness : { 1.0, 1e-4 })
    {
      CheckCells(0.0, thickness, scale, true);
      CheckCells(0.1, thickness, scale, true);
      CheckCells(0.3, thickness, scale, true);
      CheckCells(0.7, thickness, scale, false);
    }
  }
  CheckCells(0.3, 1.0, 1e60, false);
  CheckCells(0.3, 1.0, 1e-60, false);
  CheckCells(0.3, 1e-12, 1.0, false);
  CheckCells(0.0, 0.0, 1.0, false);
  return Result();
}
