#include "PowerCells.h"

#include "LiftedCell.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <numeric>

namespace
{
constexpr vtkIdType Grain = 16384;
// So many spheres are on their way from memory while others are written.
constexpr std::ptrdiff_t Ahead = 16;

// The first item of another key than the one before it.
vtkIdType BeginOfRuns(const RadixSort::Item* items, vtkIdType begin, vtkIdType count)
{
  while (begin > 0 && begin < count && items[begin].Key == items[begin - 1].Key)
  {
    ++begin;
  }
  return begin;
}

const RadixSort::Item* EndOfRun(const RadixSort::Item* begin, const RadixSort::Item* end)
{
  const RadixSort::Item* next = begin + 1;
  while (next < end && next->Key == begin->Key)
  {
    ++next;
  }
  return next;
}
}

//------------------------------------------------------------------------------
void PowerCells::Initialize(vtkIdType numberOfCells, const double bounds[6])
{
  double size = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double center = 0.5 * bounds[2 * axis] + 0.5 * bounds[2 * axis + 1];
    this->Center[axis] = std::isfinite(center) ? center : 0.0;
    size = std::max(size, 0.5 * bounds[2 * axis + 1] - 0.5 * bounds[2 * axis]);
  }
  // A power of two: coordinates lose no bit to it.
  this->Scale = size > 0.0 && std::isfinite(size) ? std::ldexp(1.0, -std::ilogb(size)) : 1.0;
  this->Lifts.resize(numberOfCells);
  this->Cospherical.resize(numberOfCells);
  this->Shared.Clear();
  this->HasShared = false;
}

//------------------------------------------------------------------------------
void PowerCells::SetCell(vtkIdType cell, const double* corners, int count)
{
  constexpr int small = 8;
  double onStack[small][3];
  const std::unique_ptr<double[][3]> onHeap(count > small ? new double[count][3] : nullptr);
  double(*relative)[3] = count > small ? onHeap.get() : onStack;
  for (int i = 0; i < 3 * count; ++i)
  {
    relative[i / 3][i % 3] = (corners[i] - this->Center[i % 3]) * this->Scale;
  }
  const LiftedCell fit = LiftedCell::Fit(relative, count);
  PowerLift& lift = this->Lifts[cell];
  std::copy_n(fit.Gradient, 3, lift.Gradient);
  lift.Constant = fit.Constant;
  this->Cospherical[cell] = fit.Cospherical;
}

//------------------------------------------------------------------------------
PowerCells::Eye PowerCells::Transform(const double eye[4]) const
{
  Eye transformed = { { eye[0], eye[1], eye[2], eye[3] } };
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    double& x = transformed.X[axis];
    x = eye[3] == 0.0 ? x : (x - this->Center[axis]) * this->Scale;
    largest = std::max(largest, std::abs(x));
  }
  if (largest > 1.0 || (eye[3] == 0.0 && largest > 0.0))
  {
    for (double& x : transformed.X)
    {
      x /= largest;
    }
  }
  return transformed;
}

//------------------------------------------------------------------------------
double PowerCells::GetKey(vtkIdType cell, const double eye[4]) const
{
  return this->Lifts[cell].Evaluate(this->Transform(eye).X);
}

//------------------------------------------------------------------------------
vtkIdType PowerCells::CountCells(const RadixSort::Item* begin, const RadixSort::Item* end) const
{
  return std::accumulate(begin, end, vtkIdType(0),
    [this](vtkIdType sum, const RadixSort::Item& item)
    { return sum + this->Shared.CountCells(item.Id); });
}

//------------------------------------------------------------------------------
void PowerCells::FindPlaces()
{
  const auto count = static_cast<vtkIdType>(this->Sort.GetNumberOfItems());
  const vtkIdType chunks = (count + Grain - 1) / Grain;
  const RadixSort::Item* items = this->Sort.GetItems();
  this->Places.assign(static_cast<std::size_t>(chunks) + 1, 0);
  vtkSMPTools::For(0, chunks, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType chunk = begin; chunk < end; ++chunk)
      {
        this->Places[chunk + 1] =
          this->CountCells(items + chunk * Grain, items + std::min(count, (chunk + 1) * Grain));
      }
    });
  std::partial_sum(this->Places.begin(), this->Places.end(), this->Places.begin());
}

//------------------------------------------------------------------------------
// Items that hold all of their keys.
void PowerCells::WriteRuns(
  const Eye& eye, const RadixSort::Item* items, const RadixSort::Item* end, vtkIdType* to) const
{
  std::vector<Run> runs;
  std::vector<Tie> ties;
  const bool isCell = this->Shared.IsEmpty();
  while (items < end)
  {
    // Most keys are alone.
    for (; isCell && items + 1 < end && items[0].Key != items[1].Key; ++items)
    {
      *to++ = items->Id;
    }
    if (!isCell && end - items > 2 * Ahead)
    {
      this->Shared.FetchBegin(items[2 * Ahead].Id);
      this->Shared.FetchCells(items[Ahead].Id);
    }
    const RadixSort::Item* next = EndOfRun(items, end);
    if (next - items == 1)
    {
      to = this->WriteCells(items->Id, to);
    }
    else
    {
      runs.push_back({ ties.size(), ties.size() + (next - items), to });
      to += isCell ? next - items : this->CountCells(items, next);
      std::transform(items, next, std::back_inserter(ties),
        [](const RadixSort::Item& item) { return Tie{ 0.0, item.Id }; });
    }
    items = next;
  }
  this->WriteTies(eye, runs, ties);
}

//------------------------------------------------------------------------------
// The runs of equal keys that begin in the chunk.
void PowerCells::WriteChunk(const Eye& eye, vtkIdType chunk, vtkIdType* order) const
{
  const RadixSort::Item* items = this->Sort.GetItems();
  const auto count = static_cast<vtkIdType>(this->Sort.GetNumberOfItems());
  const vtkIdType begin = BeginOfRuns(items, chunk * Grain, count);
  const vtkIdType end = BeginOfRuns(items, std::min(count, (chunk + 1) * Grain), count);
  this->WriteRuns(eye, items + begin, items + end,
    order + this->Places[chunk] + this->CountCells(items + chunk * Grain, items + begin));
}

//------------------------------------------------------------------------------
void PowerCells::WriteShared(const Eye& eye, vtkIdType* order)
{
  this->FindPlaces();
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Places.size()) - 1, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType chunk = begin; chunk < end; ++chunk)
      {
        this->WriteChunk(eye, chunk, order);
      }
    });
}

//------------------------------------------------------------------------------
void PowerCells::WriteTies(
  const Eye& eye, const std::vector<Run>& runs, std::vector<Tie>& ties) const
{
  // All keys first: the memory then fetches many spheres at a time.
  const PowerLift* spheres = this->GetSpheres().data();
  for (Tie& tie : ties)
  {
    tie.Key = spheres[tie.Sphere].Evaluate(eye.X);
  }
  for (const Run& run : runs)
  {
    std::sort(ties.begin() + run.Begin, ties.begin() + run.End,
      [](const Tie& a, const Tie& b)
      { return a.Key < b.Key || (a.Key == b.Key && a.Sphere < b.Sphere); });
    vtkIdType* to = run.To;
    for (std::size_t i = run.Begin; i < run.End; ++i)
    {
      to = this->WriteCells(ties[i].Sphere, to);
    }
  }
}

//------------------------------------------------------------------------------
vtkIdType* PowerCells::WriteCells(std::uint32_t sphere, vtkIdType* order) const
{
  if (!this->Shared.IsEmpty())
  {
    return this->Shared.WriteCells(sphere, order);
  }
  *order = sphere;
  return order + 1;
}

//------------------------------------------------------------------------------
void PowerCells::SortBackToFront(const double point[4], std::vector<vtkIdType>& order)
{
  if (!this->HasShared)
  {
    this->Shared.Build(this->Lifts);
    this->HasShared = true;
  }
  const Eye eye = this->Transform(point);
  order.resize(this->Lifts.size());
  const PowerLift* spheres = this->GetSpheres().data();
  this->Sort.SetKeys(this->GetSpheres().size(),
    [&](std::size_t sphere) { return RadixSort::KeyOf(spheres[sphere].Evaluate(eye.X)); });
  const bool isShared = !this->Shared.IsEmpty();
  this->Sort.Sort(
    [&](const RadixSort::Item* items, std::size_t begin, std::size_t end)
    {
      // Where spheres have several cells the place of the first is not known yet.
      if (!isShared)
      {
        this->WriteRuns(eye, items + begin, items + end, order.data() + begin);
      }
    });
  if (isShared)
  {
    this->WriteShared(eye, order.data());
  }
}
