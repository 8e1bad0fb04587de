#include "PowerCells.h"

#include "LiftedCell.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace
{
constexpr vtkIdType Grain = 16384;

double Evaluate(const PowerCells::Lift& lift, const double eye[4])
{
  return lift.Gradient[0] * eye[0] + lift.Gradient[1] * eye[1] + lift.Gradient[2] * eye[2] +
         lift.Constant * eye[3];
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
  this->Keys.resize(numberOfCells);
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
  Lift& lift = this->Lifts[cell];
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
  return Evaluate(this->Lifts[cell], this->Transform(eye).X);
}

//------------------------------------------------------------------------------
void PowerCells::FillItems(const Eye& eye, vtkIdType begin, vtkIdType end)
{
  RadixSort::Item* items = this->Sort.GetItems();
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    const double key = Evaluate(this->Lifts[cell], eye.X);
    this->Keys[cell] = key;
    items[cell] = { RadixSort::KeyOf(key), static_cast<std::uint32_t>(cell) };
  }
}

//------------------------------------------------------------------------------
// Writes the runs of equal keys that begin in begin .. end.
void PowerCells::WriteRuns(vtkIdType begin, vtkIdType end, vtkIdType* order) const
{
  const RadixSort::Item* items = this->Sort.GetItems();
  const vtkIdType count = this->GetNumberOfCells();
  while (begin > 0 && begin < end && items[begin].Key == items[begin - 1].Key)
  {
    ++begin;
  }
  while (begin < end)
  {
    order[begin] = items[begin].Id;
    vtkIdType next = begin + 1;
    while (next < count && items[next].Key == items[begin].Key)
    {
      ++next;
    }
    if (next - begin > 1)
    {
      this->WriteRun(begin, next, order);
    }
    begin = next;
  }
}

//------------------------------------------------------------------------------
void PowerCells::WriteRun(vtkIdType begin, vtkIdType end, vtkIdType* order) const
{
  const RadixSort::Item* items = this->Sort.GetItems();
  const double* keys = this->Keys.data();
  const auto isFarther = [keys](vtkIdType a, vtkIdType b)
  { return keys[a] < keys[b] || (keys[a] == keys[b] && a < b); };
  for (vtkIdType i = begin; i < end; ++i)
  {
    order[i] = items[i].Id;
  }
  std::sort(order + begin, order + end, isFarther);
}

//------------------------------------------------------------------------------
void PowerCells::SortBackToFront(const double point[4], std::vector<vtkIdType>& order)
{
  const Eye eye = this->Transform(point);
  const vtkIdType count = this->GetNumberOfCells();
  this->Sort.SetNumberOfItems(static_cast<std::size_t>(count));
  order.resize(static_cast<std::size_t>(count));
  vtkSMPTools::For(
    0, count, Grain, [&](vtkIdType begin, vtkIdType end) { this->FillItems(eye, begin, end); });
  this->Sort.Sort();
  vtkSMPTools::For(0, count, Grain,
    [&](vtkIdType begin, vtkIdType end) { this->WriteRuns(begin, end, order.data()); });
}
