/**
 * Stable parallel sort of 32-bit keys that carry 32-bit ids, smallest key first.
 *
 * Method: least significant digit first, four digits of 8 bits (three of 11 scatter to more
 * places than the cache holds, and are a quarter slower). The items are counted and scattered in
 * contiguous shares, so that the result does not depend on the number of threads. Digits that all
 * keys share are skipped.
 *
 * Linear in the number of items; nothing is allocated while the number does not grow.
 */
#ifndef RadixSort_h
#define RadixSort_h

#include <algorithm>
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

  /** To be filled before Sort, and read after it; Sort moves the items to another address. */
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
  struct Digit;
  void Count(int share, int shares, const Digit& digit);
  bool Accumulate(int shares);
  void Scatter(int share, int shares, const Digit& digit);

  std::vector<Item> Items;
  std::vector<Item> Sorted;
  /** Per share and digit value: first how often, then where the next item goes. */
  std::vector<std::uint32_t> Places;
};

#endif
