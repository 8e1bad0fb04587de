/**
 * Stable parallel sort of 32-bit keys that carry 32-bit ids, smallest key first.
 *
 * Method: the leading 8 bits part the items into buckets, all threads together; each bucket is then
 * sorted by one thread, by 16 bits more, least significant digit first, and by insertion for the
 * few items that differ in the last bits alone. Items cross from one thread to another once only:
 * where two cores share no cache that costs 160 ns a line, and four passes over all items took
 * three times as long there. A bucket that is too large for one thread's cache is parted again, by
 * the leading bits in which its keys differ. Items are counted and scattered in contiguous shares,
 * so that the result does not depend on the number of threads.
 *
 * Linear in the number of items, but for keys that differ in their last 8 bits alone; nothing is
 * allocated for other keys while the number does not grow, but a thread's own bucket of 512 KB at most.
 */
#ifndef RadixSort_h
#define RadixSort_h

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

class RadixSort
{
public:
  struct Item
  {
    std::uint32_t Key;
    std::uint32_t Id;
  };

  /** Called with a part of the sorted items, from `begin` up to `end`, that holds all items of its
   *  keys. `items`: all, sorted or not yet. */
  using Visitor = std::function<void(const Item* items, std::size_t begin, std::size_t end)>;

  /** Makes the items 0 .. count - 1; `getKey(i)` gives each its key, from any thread. */
  template <class GetKey>
  void SetKeys(std::size_t count, GetKey getKey);
  std::size_t GetNumberOfItems() const { return this->Items.size(); }
  const Item* GetItems() const { return this->Items.data(); }

  /** Once after SetKeys; then GetItems has them sorted. `visit`: once for every part, from any
   *  thread, as soon as the part is sorted and while it is in the thread's cache. */
  void Sort(const Visitor& visit);

  /** An integer that compares as the number does; close numbers share one. Steps of 2^-31 about 0
   *  that grow with the square of the number: finer than a float's from 1e-3 to 2^8, which is
   *  where most keys lie when coordinates are about 1. NaN counts as the largest number. */
  static std::uint32_t KeyOf(double value)
  {
    // Every step rounds monotonically; value / (1 + |value|) would not.
    const double share = 1.0 / (1.0 + std::abs(value));
    const double place = 2147483648.0 * (value < 0.0 ? share : 2.0 - share);
    return static_cast<std::uint32_t>(std::min(4294967295.0, place));
  }

private:
  static constexpr int Values = 1 << 8;
  /** For all items; those whose keys fill but a part of 32 bits are parted again. */
  static constexpr int FirstShift = 24;
  /** A contiguous part of the items, parted by the bits of (key - Least) from Shift up. */
  struct Range
  {
    std::size_t Begin;
    std::size_t End;
    std::uint32_t Least;
    int Shift;
  };
  using Bounds = std::array<std::size_t, Values + 1>;

  static int CountShares(std::size_t items);
  static std::size_t BeginOf(const Range& range, int share, int shares);
  void SetNumberOfItems(std::size_t count);
  void FindDigit(Range& range, int shares);
  void Count(const Range& range, int share, int shares);
  void Accumulate(const Range& range, int shares, Bounds& buckets);
  void Scatter(const Range& range, int share, int shares);
  void Part(const Range& range, int shares, const Visitor& visit);
  void SortLargeBucket(
    const Range& range, std::size_t begin, std::size_t end, const Visitor& visit);
  void SortBucket(const Range& range, std::size_t begin, std::size_t end);

  std::vector<Item> Items;
  std::vector<Item> Sorted;
  /** Of each thread, for a bucket: what a thread writes to all the time stays in its cache. */
  std::unique_ptr<vtkSMPThreadLocal<std::vector<Item>>> Between{
    new vtkSMPThreadLocal<std::vector<Item>>
  };
  /** Per share and value: first how often, then where the next item goes. */
  std::vector<std::uint32_t> Places;
  /** Per share the least and the greatest key. */
  std::vector<std::array<std::uint32_t, 2>> Extremes;
};

//------------------------------------------------------------------------------
template <class GetKey>
void RadixSort::SetKeys(std::size_t count, GetKey getKey)
{
  this->SetNumberOfItems(count);
  const Range all = { 0, count, 0, 0 };
  const int shares = CountShares(count);
  vtkSMPTools::For(0, shares, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (auto share = static_cast<int>(first); share < last; ++share)
      {
        std::uint32_t* const places = this->Places.data() + share * Values;
        Item* const items = this->Items.data();
        const std::size_t end = BeginOf(all, share + 1, shares);
        for (std::size_t i = BeginOf(all, share, shares); i < end; ++i)
        {
          const std::uint32_t key = getKey(i);
          items[i] = { key, static_cast<std::uint32_t>(i) };
          ++places[key >> FirstShift];
        }
      }
    });
}

#endif
