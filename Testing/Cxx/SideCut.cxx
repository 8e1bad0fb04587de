#include "SideCut.h"

#include <algorithm>
#include <cmath>

namespace
{
using namespace ConvexCellsTesting;
using SideCut::Ids;
using SideCut::Look;

// Edges that turn by less go straight on, in radians.
constexpr double Straight = 1e-4;

bool GoesOn(const Point& a, const Point& b, const Point& c)
{
  const Point u = Minus(b, a), v = Minus(c, b), cross = Cross(u, v);
  return std::atan2(std::sqrt(Dot(cross, cross)), Dot(u, v)) <= Straight;
}

// Not where a side touches itself: a triangle of two corners is none.
bool IsFlat(const Point& a, const Point& b, const Point& c)
{
  return a != b && a != c && (GoesOn(a, b, c) || GoesOn(b, c, a) || GoesOn(c, a, b));
}

// To the smallest id from which no triangle of the fan is flat. False where there is none: then to
// the smallest.
bool StartFan(Ids& side, const Look& at)
{
  Ids order = side;
  std::sort(order.begin(), order.end());
  order.push_back(order.front());
  for (std::size_t tried = 0; tried < order.size(); ++tried)
  {
    std::rotate(side.begin(), std::find(side.begin(), side.end(), order[tried]), side.end());
    bool flat = tried == side.size();
    for (std::size_t i = 1; side.size() > 3 && i + 1 < side.size(); ++i)
    {
      flat = flat || IsFlat(at(side[0]), at(side[i]), at(side[i + 1]));
    }
    if (!flat)
    {
      return true;
    }
  }
  return false;
}

// Twice; of the first vertex and those from `begin` to `end`.
double AreaOf(const Ids& side, std::size_t begin, std::size_t end, const Look& at)
{
  Point sum = { 0.0, 0.0, 0.0 };
  for (std::size_t i = begin; i < end; ++i)
  {
    const Point u = Minus(at(side[i]), at(side[0])), v = Minus(at(side[i + 1]), at(side[0]));
    const Point cross = Cross(u, v);
    std::transform(sum.begin(), sum.end(), cross.begin(), sum.begin(), std::plus<double>());
  }
  return std::sqrt(Dot(sum, sum));
}
}

void SideCut::VisitFan(const Ids& side, const Triangle& visit)
{
  for (std::size_t i = 1; i + 1 < side.size(); ++i)
  {
    visit(side[0], side[i], side[i + 1]);
  }
}

void SideCut::Visit(const Ids& side, const Look& at, const Triangle& visit)
{
  Ids fan = side;
  std::size_t half = 0;
  double largest = 0.0;
  const bool isWhole = StartFan(fan, at);
  for (std::size_t i = 2; !isWhole && i + 1 < side.size(); ++i)
  {
    const double smaller =
      std::min(AreaOf(side, 1, i, at), AreaOf(side, i, side.size() - 1, at));
    half = smaller > largest ? i : half;
    largest = std::max(largest, smaller);
  }
  if (half == 0)
  {
    VisitFan(fan, visit);
    return;
  }
  const auto end = side.begin() + static_cast<std::ptrdiff_t>(half);
  Ids rest(end, side.end());
  rest.insert(rest.begin(), side[0]);
  Visit(Ids(side.begin(), end + 1), at, visit);
  Visit(rest, at, visit);
}

bool SideCut::RunsBack(const Ids& side, const Look& at)
{
  bool does = false;
  for (std::size_t i = 0; i < side.size(); ++i)
  {
    const Point a = at(side[i]), b = at(side[(i + 1) % side.size()]);
    const Point c = at(side[(i + 2) % side.size()]);
    const Point back = Minus(b, Minus(c, b));
    does = does || GoesOn(a, b, back);
  }
  return does;
}
