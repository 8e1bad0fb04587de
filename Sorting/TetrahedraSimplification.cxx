#include "TetrahedraSimplification.h"

#include "ErrorBalance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
constexpr int MaximumRounds = 7;
// A round that takes less than one of so many points is the last.
constexpr int LeastShare = 100;
// Cones that are better are good enough, whatever the star was like.
constexpr double GoodQuality = 1e-3;
// Rounding must not decide.
constexpr double LeastQuality = 1e-9;
// So many neighbours are asked for the field.
constexpr int MaximumTries = 14;

// The same order everywhere: neighbours should not go one after the other.
std::vector<int> Shuffle(int count)
{
  std::vector<int> order(static_cast<size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  unsigned int random = 1;
  for (int i = count - 1; i > 0; --i)
  {
    random = random * 1664525u + 1013904223u;
    std::swap(order[i], order[(random >> 8) % static_cast<unsigned int>(i + 1)]);
  }
  return order;
}
}

//------------------------------------------------------------------------------
TetrahedraSimplification::TetrahedraSimplification(std::vector<double> points,
  std::vector<double> scalars, std::vector<CollapsibleMesh::Tetrahedron> tetrahedra,
  const SimplificationSettings& settings)
  : Settings(settings)
  , Mesh(std::move(points), std::move(tetrahedra))
  , Scalars(std::move(scalars))
  , Original(this->Scalars)
  , Boundary(this->Mesh, settings.BoundaryBound)
  , Samples(this->Mesh.GetNumberOfTetrahedra())
  , Order(Shuffle(this->Mesh.GetNumberOfPoints()))
  , Changed(this->Scalars.size(), 1)
  , Tried(this->Scalars.size(), 0)
  , Seen(this->Scalars.size(), 0)
{
  this->TakeSamples();
}

//------------------------------------------------------------------------------
void TetrahedraSimplification::TakeSamples()
{
  const auto range = std::minmax_element(this->Scalars.begin(), this->Scalars.end());
  if (range.first != this->Scalars.end())
  {
    this->Range[0] = *range.first;
    this->Range[1] = *range.second;
  }
  // Points take no error while they stay; their samples come when they go.
  for (int t = 0; t < this->Mesh.GetNumberOfTetrahedra(); ++t)
  {
    double middle[3] = { 0.0, 0.0, 0.0 }, value = 0.0;
    for (const int point : this->Mesh.Get(t))
    {
      const double* x = this->Mesh.GetPoint(point);
      std::transform(x, x + 3, middle, middle, [](double c, double m) { return m + 0.25 * c; });
      value += 0.25 * this->Scalars[point];
    }
    this->Samples.Put(this->Samples.Add(middle, value), t);
    this->PlaceOf.push_back({ t, false, { { 0.25, 0.25, 0.25, 0.25 } } });
  }
}

//------------------------------------------------------------------------------
bool TetrahedraSimplification::Run()
{
  int left = this->Mesh.GetNumberOfPoints();
  for (int round = 0; round < MaximumRounds; ++round)
  {
    if (round > 0 && this->Settings.ShiftsScalars)
    {
      this->ShiftScalars();
    }
    const int collapsed = this->RunRound(round);
    if (collapsed < 0)
    {
      return false;
    }
    left -= collapsed;
    if (collapsed * LeastShare < left)
    {
      break;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
int TetrahedraSimplification::RunRound(int round)
{
  int collapsed = 0;
  const size_t step = this->Order.size() / 16 + 1;
  for (size_t i = 0; i < this->Order.size(); ++i)
  {
    if (i % step == 0 &&
        !this->Report((round + static_cast<double>(i) / this->Order.size()) / MaximumRounds))
    {
      return -1;
    }
    const int point = this->Order[i];
    if (this->Changed[point] > this->Tried[point])
    {
      this->Tried[point] = this->Clock;
      collapsed += this->TryPoint(point);
    }
  }
  return collapsed;
}

//------------------------------------------------------------------------------
bool TetrahedraSimplification::Report(double progress) const
{
  return !this->Settings.Progress || this->Settings.Progress(progress);
}

//------------------------------------------------------------------------------
bool TetrahedraSimplification::TryPoint(int point)
{
  this->Point = point;
  this->Mesh.GetStar(point, this->Star);
  const bool isOnBoundary = this->Mesh.IsOnBoundary(point);
  if (this->Star.empty() || (isOnBoundary && !this->Boundary.Take(point, this->Star)))
  {
    return false;
  }
  this->FindNeighbors(point);
  const double leastQuality = this->FindLeastQuality(point);
  int tries = 0;
  for (const std::array<double, 3>& neighbor : this->Neighbors)
  {
    const int to = static_cast<int>(neighbor[2]);
    if ((isOnBoundary && !this->Boundary.MayFollow(to)) ||
        !this->Cones.Build(this->Mesh, to, this->Star, leastQuality) ||
        (isOnBoundary && !this->Boundary.StaysNear(to)))
    {
      continue;
    }
    if (this->KeepsField())
    {
      this->Collapse(point, to);
      return true;
    }
    if (isOnBoundary)
    {
      this->Boundary.Forget();
    }
    if (++tries == MaximumTries)
    {
      break;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void TetrahedraSimplification::FindNeighbors(int point)
{
  this->Neighbors.clear();
  ++this->Look;
  this->Seen[point] = this->Look;
  const double* x = this->Mesh.GetPoint(point);
  for (const int corner : this->Star)
  {
    for (const int neighbor : this->Mesh.Get(corner / 4))
    {
      if (this->Seen[neighbor] != this->Look)
      {
        this->Seen[neighbor] = this->Look;
        const double* y = this->Mesh.GetPoint(neighbor);
        const double square = (y[0] - x[0]) * (y[0] - x[0]) + (y[1] - x[1]) * (y[1] - x[1]) +
                              (y[2] - x[2]) * (y[2] - x[2]);
        this->Neighbors.push_back(
          { { square, std::abs(this->Scalars[neighbor] - this->Scalars[point]),
            static_cast<double>(neighbor) } });
      }
    }
  }
  std::sort(this->Neighbors.begin(), this->Neighbors.end());
}

//------------------------------------------------------------------------------
double TetrahedraSimplification::FindLeastQuality(int point) const
{
  double least = GoodQuality;
  for (const int corner : this->Star)
  {
    const CollapsibleMesh::Tetrahedron& t = this->Mesh.Get(corner / 4);
    const int* base = CollapsibleMesh::FaceOf[corner % 4];
    least = std::min(
      least, CollapsedStar::QualityOf(this->Mesh.GetPoint(point), this->Mesh.GetPoint(t[base[0]]),
               this->Mesh.GetPoint(t[base[1]]), this->Mesh.GetPoint(t[base[2]])));
  }
  return std::max(least, LeastQuality);
}

//------------------------------------------------------------------------------
bool TetrahedraSimplification::KeepsField()
{
  this->Places.clear();
  int guess = 0;
  const int own = this->Samples.Add(this->Mesh.GetPoint(this->Point), this->Original[this->Point]);
  // Samples that said no before are the first of their tetrahedra: they are asked first.
  bool keeps = this->KeepsSample(own, guess);
  for (size_t i = 0; i < this->Star.size() && keeps; ++i)
  {
    const int first = this->Samples.Begin(this->Star[i] / 4);
    guess = this->Cones.FindCone(this->Star[i] / 4, guess);
    keeps = first < 0 || this->KeepsSample(first, guess);
  }
  for (size_t i = 0; i < this->Star.size() && keeps; ++i)
  {
    keeps = this->KeepsOthers(this->Star[i] / 4);
  }
  if (!keeps)
  {
    this->Samples.RemoveLast();
  }
  return keeps;
}

//------------------------------------------------------------------------------
bool TetrahedraSimplification::KeepsOthers(int tetrahedron)
{
  int before = this->Samples.Begin(tetrahedron);
  if (before < 0)
  {
    return true;
  }
  int guess = this->Cones.FindCone(tetrahedron, 0);
  for (int s = this->Samples.Next(before); s >= 0; before = s, s = this->Samples.Next(s))
  {
    if (!this->KeepsSample(s, guess))
    {
      this->Samples.MoveToFront(tetrahedron, before);
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool TetrahedraSimplification::KeepsSample(int sample, int& guess)
{
  Place place;
  const double value = this->FindPlace(sample, guess, place);
  this->Places.emplace_back(sample, place);
  return std::abs(value - this->Samples.GetValue(sample)) <= this->Settings.FieldBound;
}

//------------------------------------------------------------------------------
double TetrahedraSimplification::FindPlace(int sample, int& guess, Place& place) const
{
  const double* x = this->Samples.GetPoint(sample);
  CollapsedStar::Location location;
  this->Cones.Locate(x, guess, location);
  place.IsOutside = location.IsOutside;
  double value = 0.0;
  if (location.IsOutside && this->Mesh.IsOnBoundary(this->Point))
  {
    // The boundary has moved past it: what is near may be of another star.
    int corners[4];
    place.Tetrahedron = this->Boundary.FindNearest(x, corners, place.Weights.data());
    for (int i = 0; i < 4; ++i)
    {
      value += place.Weights[i] * this->Scalars[corners[i]];
    }
    return value;
  }
  guess = location.Cone;
  place.Tetrahedron = this->Cones.GetTetrahedron(guess);
  const int* points = this->Cones.GetPoints(guess);
  const int* places = this->Cones.GetPlaces(guess);
  for (int i = 0; i < 4; ++i)
  {
    place.Weights[places[i]] = location.Weights[i];
    value += location.Weights[i] * this->Scalars[points[i]];
  }
  return value;
}

//------------------------------------------------------------------------------
double TetrahedraSimplification::ErrorOf(int sample, int tetrahedron) const
{
  const std::array<double, 4>& weights = this->PlaceOf[sample].Weights;
  const CollapsibleMesh::Tetrahedron& t = this->Mesh.Get(tetrahedron);
  return weights[0] * this->Scalars[t[0]] + weights[1] * this->Scalars[t[1]] +
         weights[2] * this->Scalars[t[2]] + weights[3] * this->Scalars[t[3]] -
         this->Samples.GetValue(sample);
}

//------------------------------------------------------------------------------
void TetrahedraSimplification::Collapse(int point, int to)
{
  for (const int corner : this->Star)
  {
    this->Samples.Clear(corner / 4);
  }
  this->PlaceOf.resize(static_cast<size_t>(this->Samples.GetNumberOfSamples()));
  for (const std::pair<int, Place>& place : this->Places)
  {
    this->PlaceOf[place.first] = place.second;
    this->Samples.Put(place.first, place.second.Tetrahedron);
  }
  this->Boundary.Move(this->Mesh.Collapse(point, to, this->Star));
  if (this->Mesh.IsOnBoundary(point))
  {
    this->Boundary.Follow();
  }
  ++this->Clock;
  for (const std::array<double, 3>& neighbor : this->Neighbors)
  {
    this->Changed[static_cast<int>(neighbor[2])] = this->Clock;
  }
}

//------------------------------------------------------------------------------
void TetrahedraSimplification::ShiftScalars()
{
  for (const int point : this->Order)
  {
    this->Mesh.GetStar(point, this->Star);
    if (!this->Star.empty())
    {
      this->ShiftScalar(point);
    }
  }
  ++this->Clock;
  std::fill(this->Changed.begin(), this->Changed.end(), this->Clock);
}

//------------------------------------------------------------------------------
void TetrahedraSimplification::ShiftScalar(int point)
{
  this->Errors.clear();
  this->Errors.emplace_back(this->Scalars[point] - this->Original[point], 1.0);
  for (const int corner : this->Star)
  {
    const int t = corner / 4;
    for (int s = this->Samples.Begin(t); s >= 0; s = this->Samples.Next(s))
    {
      this->Errors.emplace_back(this->ErrorOf(s, t), this->PlaceOf[s].Weights[corner % 4]);
    }
  }
  const double shifted =
    this->Scalars[point] + ErrorBalance::FindShift(this->Errors, 2.0 * this->Settings.FieldBound);
  this->Scalars[point] = std::min(std::max(shifted, this->Range[0]), this->Range[1]);
}

//------------------------------------------------------------------------------
double TetrahedraSimplification::FindFieldError() const
{
  double largest = 0.0;
  for (int t = 0; t < this->Mesh.GetNumberOfTetrahedra(); ++t)
  {
    if (!this->Mesh.IsAlive(t))
    {
      continue;
    }
    for (const int point : this->Mesh.Get(t))
    {
      largest = std::max(largest, std::abs(this->Scalars[point] - this->Original[point]));
    }
    for (int s = this->Samples.Begin(t); s >= 0; s = this->Samples.Next(s))
    {
      largest = std::max(largest, this->PlaceOf[s].IsOutside ? 0.0 : std::abs(this->ErrorOf(s, t)));
    }
  }
  return largest;
}

//------------------------------------------------------------------------------
std::vector<int> TetrahedraSimplification::FindOutside() const
{
  std::vector<int> outside;
  for (int s = 0; s < this->Samples.GetNumberOfSamples(); ++s)
  {
    if (this->PlaceOf[s].IsOutside)
    {
      outside.push_back(s);
    }
  }
  return outside;
}
