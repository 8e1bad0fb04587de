// Signs against whole-number arithmetic: points at random, in one plane, and one unit off it; far
// from the origin, and scaled down.

#include "ExactOrientation.h"
#include "TestScene.h"

#include <array>
#include <cstdint>
#include <random>

namespace
{
__extension__ using Wide = __int128;
using Point = std::array<std::int64_t, 3>;

int SignOf(Wide x)
{
  return (x > 0) - (x < 0);
}

int TrueSide(const Point& u, const Point& v, const Point& w)
{
  Wide sum = 0;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    sum += (Wide(u[j]) * v[k] - Wide(u[k]) * v[j]) * w[i];
  }
  return SignOf(sum);
}

Point Minus(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

struct Doubles
{
  double X[3];

  Doubles(const Point& p, double scale)
    : X{ scale * static_cast<double>(p[0]), scale * static_cast<double>(p[1]),
      scale * static_cast<double>(p[2]) }
  {
  }
};

class Signs
{
public:
  // Powers of two keep whole numbers exact.
  Signs(TestChecks& checks, std::int64_t offset, double scale)
    : Checks(checks)
    , Offset(offset)
    , Scale(scale)
  {
  }

  void CheckPoint(const Point& a, const Point& b, const Point& c, const Point& p)
  {
    const int expected = TrueSide(Minus(b, a), Minus(c, a), Minus(p, a));
    const Doubles da(this->Shifted(a), this->Scale), db(this->Shifted(b), this->Scale),
      dc(this->Shifted(c), this->Scale), dp(this->Shifted(p), this->Scale);
    this->Take(expected, ExactOrientation::SideOfPoint(da.X, db.X, dc.X, dp.X));
    this->Take(-expected, ExactOrientation::SideOfPoint(db.X, da.X, dc.X, dp.X));
    const double eye[4] = { dp.X[0], dp.X[1], dp.X[2], 1.0 };
    this->Take(expected, ExactOrientation::SideOfEye(da.X, db.X, dc.X, eye));
  }

  void CheckDirection(const Point& a, const Point& b, const Point& c, const Point& direction)
  {
    const int expected = TrueSide(Minus(b, a), Minus(c, a), direction);
    const Doubles da(this->Shifted(a), this->Scale), db(this->Shifted(b), this->Scale),
      dc(this->Shifted(c), this->Scale), d(direction, 1.0);
    this->Take(expected, ExactOrientation::SideOfDirection(da.X, db.X, dc.X, d.X));
    const double eye[4] = { d.X[0], d.X[1], d.X[2], 0.0 };
    this->Take(-expected, ExactOrientation::SideOfEye(da.X, dc.X, db.X, eye));
  }

  int GetZeros() const { return this->Zeros; }

private:
  Point Shifted(const Point& p) const
  {
    return { p[0] + this->Offset, p[1] - this->Offset, p[2] + 3 * this->Offset };
  }

  void Take(int expected, int found)
  {
    TestChecks& checks = this->Checks;
    CHECK(expected == found);
    this->Zeros += expected == 0;
  }

  TestChecks& Checks;
  const std::int64_t Offset;
  const double Scale;
  int Zeros = 0;
};

void TestAt(TestChecks& checks, std::int64_t size, std::int64_t offset, double scale)
{
  std::mt19937_64 random(7);
  std::uniform_int_distribution<std::int64_t> coordinate(-size, size);
  std::uniform_int_distribution<std::int64_t> factor(-40, 40);
  const auto point = [&]() {
    return Point{ coordinate(random), coordinate(random), coordinate(random) };
  };
  Signs signs(checks, offset, scale);
  for (int i = 0; i < 4000; ++i)
  {
    const Point a = point(), b = point(), c = point();
    signs.CheckPoint(a, b, c, point());
    signs.CheckDirection(a, b, c, point());
    // In the plane, and a unit off it along one axis.
    Point p = a, direction{ 0, 0, 0 };
    const std::int64_t s = factor(random), t = factor(random);
    for (int k = 0; k < 3; ++k)
    {
      direction[k] = s * (b[k] - a[k]) + t * (c[k] - a[k]);
      p[k] += direction[k];
    }
    signs.CheckPoint(a, b, c, p);
    signs.CheckDirection(a, b, c, direction);
    p[i % 3] += i % 2 == 0 ? 1 : -1;
    direction[i % 3] += i % 2 == 0 ? 1 : -1;
    signs.CheckPoint(a, b, c, p);
    signs.CheckDirection(a, b, c, direction);
    // A triangle without an area has no sides.
    signs.CheckPoint(a, b, b, point());
    signs.CheckDirection(a, a, c, point());
  }
  // Of eight kinds of triples four are ties, with two or three signs each.
  CHECK(signs.GetZeros() >= 4 * 4000 * 2);
}
}

int TestExactOrientation(int, char*[])
{
  TestChecks checks;
  TestAt(checks, 1 << 4, 0, 1.0);
  TestAt(checks, 1 << 20, 0, 1.0);
  TestAt(checks, std::int64_t(1) << 30, 0, 1.0);
  TestAt(checks, 1 << 10, 10000000, 1.0);
  TestAt(checks, 1 << 20, std::int64_t(1) << 40, 1.0);
  TestAt(checks, 1 << 20, 0, 1.0 / (std::int64_t(1) << 44));
  return checks.Result();
}
