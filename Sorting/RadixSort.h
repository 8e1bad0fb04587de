/**
 * Stable parallel sort of 32-bit keys that carry 32-bit ids, smallest key first.
 *
 * Method: the leading 8 bits in which the keys differ part the items into buckets, all threads
 * together; each bucket is then sorted by one thread, least significant digit first. Items cross
 * from one thread to another once only: where two cores share no cache that costs 160 ns a line,
 * and four passes over all items took three times as long there. A bucket that is too large for
 * one thread's cache is parted again. Items are counted and scattered in contiguous shares, so that
 * the result does not depend on the number of threads.
 *
 * Linear in the number of items; nothing is allocated while the number does not grow.
 */
#ifndef RadixSort_h
#define RadixSort_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

class RadixSort
{
public:
  struct Item
  {
    std::uint32_t Key;
    std::uint32_t Id;
  };

  /** Makes room; what the items hold is then undefined. */
  void SetNumberOfItems(std::size_t count);
  std::size_t GetNumberOfItems() const { return this->Items.size(); }

  /** To be filled before Sort, and read after it, at the same address. */
  Item* GetItems() { return this->Items.data(); }
  const Item* GetItems() const { return this->Items.data(); }

  void Sort();

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
  /** A contiguous part of the items, parted by the bits of (key - Least) from Shift up. */
  struct Range
  {
    std::size_t Begin;
    std::size_t End;
    std::uint32_t Least;
    int Shift;
  };
  using Bounds = std::array<std::size_t, Values + 1>;

  void SortRange(std::size_t begin, std::size_t end);
  void FindDigit(Range& range, int shares);
  void Count(const Range& range, int share, int shares);
  void Accumulate(const Range& range, int shares, Bounds& buckets);
  void Scatter(const Range& range, int share, int shares);
  void SortLargeBucket(const Range& range, std::size_t begin, std::size_t end);
  void SortBucket(const Range& range, std::size_t begin, std::size_t end);

  std::vector<Item> Items;
  std::vector<Item> Sorted;
  /** Per share and value: first how often, then where the next item goes. */
  std::vector<std::uint32_t> Places;
  /** Per share the least and the greatest key. */
  std::vector<std::array<std::uint32_t, 2>> Extremes;
};

#endif
