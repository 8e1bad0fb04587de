#include "CoincidentPoints.h"

#include "PointCoordinates.h"

#include "vtkSMPTools.h"

#include <atomic>
#include <cstdint>
#include <cstring>
#include <memory>

namespace
{
using Slot = std::atomic<vtkIdType>;
constexpr vtkIdType Free = -1;

// The finaliser of a 64-bit mixer: every input bit reaches every output bit.
std::uint64_t Mix(std::uint64_t bits)
{
  bits = (bits ^ (bits >> 32)) * 0x9e3779b97f4a7c15u;
  return bits ^ (bits >> 29);
}

std::uint64_t Hash(const double x[3])
{
  std::uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double value = x[axis] + 0.0; // turns -0 into 0
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    hash = Mix(hash * 31 + bits);
  }
  return hash;
}

class Table
{
public:
  Table(const PointCoordinates& points, vtkIdType numberOfPoints)
    : Points(points)
    , Size(numberOfPoints + numberOfPoints / 2 + 1)
    , Slots(new Slot[this->Size])
  {
    vtkSMPTools::For(0, this->Size,
      [this](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType slot = begin; slot < end; ++slot)
        {
          this->Slots[slot].store(Free, std::memory_order_relaxed);
        }
      });
  }

  /** The slot of the point's position, after the point has bid for it. */
  vtkIdType Insert(vtkIdType point)
  {
    double x[3];
    this->Points.Get(point, x);
    vtkIdType slot = this->FirstSlot(Hash(x));
    while (!this->Bid(point, x, this->Slots[slot]))
    {
      slot = slot + 1 < this->Size ? slot + 1 : 0;
    }
    return slot;
  }

  vtkIdType Smallest(vtkIdType slot) const
  {
    return this->Slots[slot].load(std::memory_order_relaxed);
  }

private:
  vtkIdType FirstSlot(std::uint64_t hash) const
  {
    // The high halves multiplied: uniform for any size, without a division.
    const std::uint64_t size = static_cast<std::uint64_t>(this->Size);
    return static_cast<vtkIdType>(((hash >> 32) * size) >> 32);
  }

  // False: the slot belongs to another position.
  bool Bid(vtkIdType point, const double x[3], Slot& slot) const
  {
    vtkIdType holder = slot.load(std::memory_order_relaxed);
    while (holder == Free)
    {
      if (slot.compare_exchange_weak(holder, point, std::memory_order_relaxed))
      {
        return true;
      }
    }
    double y[3];
    this->Points.Get(holder, y);
    if (x[0] != y[0] || x[1] != y[1] || x[2] != y[2])
    {
      return false;
    }
    while (point < holder && !slot.compare_exchange_weak(holder, point, std::memory_order_relaxed))
    {
    }
    return true;
  }

  const PointCoordinates& Points;
  const vtkIdType Size;
  const std::unique_ptr<Slot[]> Slots;
};
}

namespace CoincidentPoints
{
void Merge(const PointCoordinates& points, vtkIdType numberOfPoints, vtkIdType* canonical)
{
  Table table(points, numberOfPoints);
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        canonical[point] = canonical[point] < 0 ? canonical[point] : table.Insert(point);
      }
    });
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        const vtkIdType slot = canonical[point];
        canonical[point] = slot < 0 ? slot : table.Smallest(slot);
      }
    });
}
}
