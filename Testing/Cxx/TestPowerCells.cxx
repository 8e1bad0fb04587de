// The lifted functions against circumspheres computed directly, the order of their keys, and the
// Delaunay test.

#include "DelaunayTest.h"
#include "LiftedCell.h"
#include "PowerCells.h"
#include "TestScene.h"

#include "vtkMath.h"
#include "vtkTetra.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace
{
using Corners = std::vector<double>;
constexpr double UnitBounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };

// Multiples of 2^-20 in -1 .. 1, so that offsets of 1e7 round nothing.
double RandomCoordinate(std::mt19937& random)
{
  return std::ldexp(static_cast<double>(random() % (1u << 21)), -20) - 1.0;
}

Corners RandomTetrahedron(std::mt19937& random)
{
  Corners corners(12);
  std::generate(corners.begin(), corners.end(), [&] { return RandomCoordinate(random); });
  return corners;
}

// Flat to one part in a million, with the fourth corner over the triangle.
Corners Sliver(std::mt19937& random)
{
  Corners corners = RandomTetrahedron(random);
  for (int corner = 0; corner < 4; ++corner)
  {
    corners[3 * corner + 2] *= 1e-6;
  }
  return corners;
}

// |eye|^2 less the squared tangential distance.
double DirectKey(const Corners& corners, const double eye[4])
{
  double center[3];
  double p[4][3];
  std::copy_n(corners.data(), 12, &p[0][0]);
  const double square = vtkTetra::Circumsphere(p[0], p[1], p[2], p[3], center);
  return vtkMath::Dot(eye, eye) - vtkMath::Distance2BetweenPoints(center, eye) + square;
}

void CheckAgainstSpheres(TestChecks& checks)
{
  std::mt19937 random(3);
  PowerCells cells;
  cells.Initialize(1, UnitBounds);
  for (int run = 0; run < 2000; ++run)
  {
    const Corners corners = RandomTetrahedron(random);
    const double eye[4] = { RandomCoordinate(random), RandomCoordinate(random),
      RandomCoordinate(random), 1.0 };
    cells.SetCell(0, corners.data(), 4);
    CHECK(cells.IsCospherical(0));
    const double expected = DirectKey(corners, eye);
    CHECK_NEAR(cells.GetKey(0, eye), expected, 1e-9 * (1.0 + std::abs(expected)));
  }
}

// The lifted function is |x|^2 at the corners, however flat the cell.
void CheckSlivers(TestChecks& checks)
{
  std::mt19937 random(4);
  PowerCells cells;
  cells.Initialize(1, UnitBounds);
  for (int run = 0; run < 2000; ++run)
  {
    const Corners corners = Sliver(random);
    cells.SetCell(0, corners.data(), 4);
    CHECK(cells.IsCospherical(0));
    for (int corner = 0; corner < 4; ++corner)
    {
      const double* p = corners.data() + 3 * corner;
      const double eye[4] = { p[0], p[1], p[2], 1.0 };
      CHECK_NEAR(cells.GetKey(0, eye), vtkMath::Dot(p, p), 1e-8);
    }
  }
}

// Far from the origin every key is the same, to the last bit.
void CheckOffsets(TestChecks& checks)
{
  std::mt19937 random(5);
  PowerCells here, there;
  double bounds[6];
  std::transform(UnitBounds, UnitBounds + 6, bounds, [](double x) { return x + 1e7; });
  here.Initialize(1, UnitBounds);
  there.Initialize(1, bounds);
  for (int run = 0; run < 200; ++run)
  {
    Corners corners = RandomTetrahedron(random);
    double eye[4] = { 2.0, -3.0, 0.5, 1.0 };
    here.SetCell(0, corners.data(), 4);
    const double expected = here.GetKey(0, eye);
    std::for_each(corners.begin(), corners.end(), [](double& x) { x += 1e7; });
    std::for_each(eye, eye + 3, [](double& x) { x += 1e7; });
    there.SetCell(0, corners.data(), 4);
    CHECK(there.GetKey(0, eye) == expected);
  }
}

PowerCells RandomCells(vtkIdType count)
{
  std::mt19937 random(6);
  PowerCells cells;
  cells.Initialize(count, UnitBounds);
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    cells.SetCell(cell, RandomTetrahedron(random).data(), 4);
  }
  return cells;
}

bool IsSorted(const PowerCells& cells, const std::vector<vtkIdType>& order, const double eye[4])
{
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    const double before = cells.GetKey(order[i - 1], eye), after = cells.GetKey(order[i], eye);
    if (before > after || (before == after && order[i - 1] > order[i]))
    {
      return false;
    }
  }
  return true;
}

bool IsPermutation(std::vector<vtkIdType> order, vtkIdType count)
{
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (order[i] != static_cast<vtkIdType>(i))
    {
      return false;
    }
  }
  return static_cast<vtkIdType>(order.size()) == count;
}

void CheckOrder(TestChecks& checks)
{
  constexpr vtkIdType count = 50000;
  PowerCells cells = RandomCells(count);
  std::vector<vtkIdType> order;
  const double eyes[][4] = { { 3, 2, 1, 1 }, { 0, 0, 0, 1 }, { 0.1, 0.2, 0.3, 1 }, { 1e6, 1, 1, 1 },
    { 0, 0, 1, 0 }, { -1, 2, 3, 0 }, { 1e300, -1e300, 1, 1 }, { 1e-9, 0, 0, 0 } };
  for (const auto& eye : eyes)
  {
    cells.SortBackToFront(eye, order);
    CHECK(IsPermutation(order, count));
    CHECK(IsSorted(cells, order, eye));
  }
}

// Keys that are one float, and as long a run of equal ones: double decides, then the id.
void CheckTies(TestChecks& checks)
{
  constexpr int count = 60000;
  PowerCells cells;
  cells.Initialize(count, UnitBounds);
  for (int cell = 0; cell < count; ++cell)
  {
    const double x = 0.5 + 1e-13 * ((cell * 7919) % 20011);
    const double corners[12] = { x, 0, 0, x + 0.25, 0, 0, x, 0.25, 0, x, 0, 0.25 };
    cells.SetCell(cell, corners, 4);
  }
  std::vector<vtkIdType> order;
  for (const double w : { 0.0, 1.0 })
  {
    const double eye[4] = { 1.0, 0.5, 0.25, w };
    cells.SortBackToFront(eye, order);
    CHECK(IsPermutation(order, count));
    CHECK(IsSorted(cells, order, eye));
  }
}

// Six tetrahedra of each box: those of its halves in turn.
PowerCells MakeBoxes(int boxes)
{
  constexpr int steps[6][2] = { { 1, 3 }, { 2, 3 }, { 2, 6 }, { 1, 5 }, { 4, 6 }, { 4, 5 } };
  std::mt19937 random(7);
  PowerCells cells;
  cells.Initialize(6 * boxes, UnitBounds);
  for (int box = 0; box < boxes; ++box)
  {
    double low[3], size[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = RandomCoordinate(random);
      size[axis] = 1e-3 * (1.1 + RandomCoordinate(random));
    }
    for (int cell = 0; cell < 6; ++cell)
    {
      double corners[12];
      for (int i = 0; i < 12; ++i)
      {
        const int corner = i < 3 ? 0 : i < 9 ? steps[cell][i / 3 - 1] : 7;
        corners[i] = low[i % 3] + (corner >> i % 3 & 1) * size[i % 3];
      }
      cells.SetCell(6 * box + cell, corners, 4);
    }
  }
  return cells;
}

// Cells of one sphere have one key and follow each other.
void CheckBoxes(TestChecks& checks)
{
  constexpr int boxes = 20000;
  PowerCells cells = MakeBoxes(boxes);
  std::vector<vtkIdType> order;
  const double eye[4] = { 3.1, 2.3, -1.7, 1.0 };
  cells.SortBackToFront(eye, order);
  CHECK(IsPermutation(order, 6 * boxes));
  CHECK(IsSorted(cells, order, eye));
  int apart = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    apart += order[i] != order[i - i % 6] + static_cast<vtkIdType>(i % 6) ? 1 : 0;
  }
  CHECK_AT_MOST(apart, 0);
}

// A direction is what eyes tend to that go away along it.
void CheckDirection(TestChecks& checks)
{
  constexpr vtkIdType count = 5000;
  PowerCells cells = RandomCells(count);
  const double direction[4] = { 1.0, 2.0, -0.5, 0.0 };
  for (const double distance : { 1e4, 1e6, 1e8 })
  {
    const double eye[4] = { distance, 2.0 * distance, -0.5 * distance, 1.0 };
    int wrong = 0;
    for (vtkIdType cell = 1; cell < count; ++cell)
    {
      const double far = cells.GetKey(cell, eye) - cells.GetKey(cell - 1, eye);
      const double limit = cells.GetKey(cell, direction) - cells.GetKey(cell - 1, direction);
      wrong += far * limit < 0.0 ? 1 : 0;
    }
    CHECK_AT_MOST(wrong, static_cast<int>(10.0 * count / distance));
  }
}

void CheckFlatAndBroken(TestChecks& checks)
{
  const double nan = std::nan("");
  const double corners[4][12] = { { 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0 },
    { 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0 }, { 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1 },
    { 0, 0, nan, 1, 0, 0, 0, 1, 0, 0, 0, 1 } };
  PowerCells cells;
  cells.Initialize(5, UnitBounds);
  const double eye[4] = { 3.0, 2.0, 1.0, 1.0 };
  for (int cell = 0; cell < 4; ++cell)
  {
    cells.SetCell(cell, corners[cell], 4);
    CHECK(!cells.IsCospherical(cell));
    CHECK(std::isfinite(cells.GetKey(cell, eye)));
  }
  cells.SetCell(4, nullptr, 0);
  std::vector<vtkIdType> order;
  cells.SortBackToFront(eye, order);
  CHECK(IsPermutation(order, 5));
}

double SumOfSquares(const LiftedCell& cell, const double (*corners)[3], int count)
{
  double sum = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const double* p = corners[i];
    sum += std::pow(vtkMath::Dot(cell.Gradient, p) + cell.Constant - vtkMath::Dot(p, p), 2);
  }
  return sum;
}

// A box has a sphere; a bent one takes the best fit: any other function is worse.
void CheckManyCorners(TestChecks& checks)
{
  double corners[12][3];
  for (int i = 0; i < 8; ++i)
  {
    corners[i][0] = i & 1 ? 0.7 : -0.1;
    corners[i][1] = i & 2 ? 0.3 : 0.2;
    corners[i][2] = i & 4 ? 1e-3 : 0.9;
  }
  CHECK(LiftedCell::Fit(corners, 8).Cospherical);
  CHECK_AT_MOST(SumOfSquares(LiftedCell::Fit(corners, 8), corners, 8), 1e-28);
  std::copy_n(&corners[0][0], 12, &corners[8][0]);
  CHECK(LiftedCell::Fit(corners, 12).Cospherical);
  corners[5][0] += 0.2;
  const LiftedCell best = LiftedCell::Fit(corners, 8);
  CHECK(!best.Cospherical);
  for (int coefficient = 0; coefficient < 8; ++coefficient)
  {
    LiftedCell other = best;
    (coefficient < 6 ? other.Gradient[coefficient / 2] : other.Constant) +=
      coefficient % 2 ? 1e-4 : -1e-4;
    CHECK(SumOfSquares(best, corners, 8) < SumOfSquares(other, corners, 8));
  }
}

void CheckOutside(TestChecks& checks)
{
  const double p0[3] = { 0, 0, 0 }, p1[3] = { 1, 0, 0 }, p2[3] = { 0, 1, 0 }, a[3] = { 0, 0, -1 };
  const auto outside = [&](double x, double y, double z)
  {
    const double b[3] = { x, y, z };
    const bool result = DelaunayTest::IsStrictlyOutside(p0, p1, p2, a, b);
    CHECK(result == DelaunayTest::IsStrictlyOutside(p1, p0, p2, a, b));
    return result;
  };
  CHECK(!outside(1, 1, 0) && !outside(1, 1, -1) && !outside(0.5, 0.5, 0.1));
  CHECK(outside(0.5, 0.5, 0.5) && outside(1, 1, 1e-12) && outside(1e10, 3, 5));
  CHECK(!outside(1, 1 - 1e-12, 0) && !outside(1, 1 + 1e-16, 0));
  const double flat[3] = { 1, 1, 0 }, far[3] = { 0.3, 0.3, 9 };
  CHECK(!DelaunayTest::IsStrictlyOutside(p0, p1, p2, flat, far));
}
}

int TestPowerCells(int, char*[])
{
  TestChecks checks;
  CheckAgainstSpheres(checks);
  CheckSlivers(checks);
  CheckOffsets(checks);
  CheckOrder(checks);
  CheckTies(checks);
  CheckBoxes(checks);
  CheckDirection(checks);
  CheckFlatAndBroken(checks);
  CheckManyCorners(checks);
  CheckOutside(checks);
  return checks.Result();
}
