#include "CoincidentPoints.h"

#include "PointCoordinates.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <memory>

namespace
{
// A point's id, and above it some bits of its position's hash: most others differ there, and their
// coordinates, far away in memory, need not be looked at.
using Slot = std::atomic<std::uint64_t>;
constexpr std::uint64_t Free = ~std::uint64_t{ 0 };
constexpr int IdBits = 44;
constexpr std::uint64_t IdMask = (std::uint64_t{ 1 } << IdBits) - 1;
// So many slots are on their way from memory while others are filled.
constexpr int Ahead = 16;

void Prefetch(const void* address)
{
#if defined(__GNUC__)
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

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

  /** The slots of the points' positions, after each has bid for its own; those below 0 have none. */
  void Insert(vtkIdType begin, vtkIdType end, vtkIdType* slots)
  {
    std::uint64_t hashes[Ahead];
    for (vtkIdType first = begin; first < end; first += Ahead)
    {
      const vtkIdType last = std::min(first + Ahead, end);
      double x[3];
      for (vtkIdType point = first; point < last; ++point)
      {
        this->Points.Get(point, x);
        hashes[point - first] = Hash(x);
        Prefetch(&this->Slots[this->FirstSlot(hashes[point - first])]);
      }
      for (vtkIdType point = first; point < last; ++point)
      {
        slots[point] = slots[point] < 0 ? slots[point] : this->Insert(point, hashes[point - first]);
      }
    }
  }

  /** Whether two points lie at the same position. */
  bool HasCoincident() const { return this->Coincident.load(std::memory_order_relaxed); }

  vtkIdType Smallest(vtkIdType slot) const
  {
    return static_cast<vtkIdType>(this->Slots[slot].load(std::memory_order_relaxed) & IdMask);
  }

private:
  vtkIdType Insert(vtkIdType point, std::uint64_t hash)
  {
    double x[3];
    this->Points.Get(point, x);
    const std::uint64_t bid = (hash << IdBits) | static_cast<std::uint64_t>(point);
    vtkIdType slot = this->FirstSlot(hash);
    while (!this->Bid(bid, x, this->Slots[slot]))
    {
      slot = slot + 1 < this->Size ? slot + 1 : 0;
    }
    return slot;
  }

  vtkIdType FirstSlot(std::uint64_t hash) const
  {
    // The high halves multiplied: uniform for any size, without a division.
    const std::uint64_t size = static_cast<std::uint64_t>(this->Size);
    return static_cast<vtkIdType>(((hash >> 32) * size) >> 32);
  }

  // False: the slot belongs to another position.
  bool Bid(std::uint64_t bid, const double x[3], Slot& slot)
  {
    std::uint64_t holder = slot.load(std::memory_order_relaxed);
    while (holder == Free)
    {
      if (slot.compare_exchange_weak(holder, bid, std::memory_order_relaxed))
      {
        return true;
      }
    }
    double y[3];
    if ((holder ^ bid) >> IdBits != 0)
    {
      return false;
    }
    this->Points.Get(static_cast<vtkIdType>(holder & IdMask), y);
    if (x[0] != y[0] || x[1] != y[1] || x[2] != y[2])
    {
      return false;
    }
    this->Coincident.store(true, std::memory_order_relaxed);
    while (bid < holder && !slot.compare_exchange_weak(holder, bid, std::memory_order_relaxed))
    {
    }
    return true;
  }

  const PointCoordinates& Points;
  const vtkIdType Size;
  const std::unique_ptr<Slot[]> Slots;
  std::atomic<bool> Coincident{ false };
};
}

namespace CoincidentPoints
{
void Merge(const PointCoordinates& points, vtkIdType numberOfPoints, vtkIdType* canonical)
{
  Table table(points, numberOfPoints);
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end) { table.Insert(begin, end, canonical); });
  const bool any = table.HasCoincident();
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        const vtkIdType slot = canonical[point];
        canonical[point] = slot < 0 ? slot : any ? table.Smallest(slot) : point;
      }
    });
}
}
