/**
 * Stable parallel sort of 32-bit keys that carry 32-bit ids, smallest key first.
 *
 * Method: least significant digit first, three digits of 11, 11 and 10 bits. Each thread counts and
 * scatters one contiguous share of the items, so that the result does not depend on the number of
 * threads. Digits that all keys share are skipped.
 *
 * Linear in the number of items; nothing is allocated while the number does not grow.
 */
#ifndef RadixSort_h
#define RadixSort_h

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
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

  void Sort();

  /** An integer that compares as the number does; NaN counts as the smallest number, -0 as 0. */
  static std::uint32_t KeyOf(float value)
  {
    const float number = value == value ? value + 0.0f : -std::numeric_limits<float>::infinity();
    std::uint32_t bits;
    std::memcpy(&bits, &number, sizeof(bits));
    return bits >> 31 ? ~bits : bits | 0x80000000u;
  }

private:
  struct Digit;
  void Count(int share, int shares, const Digit& digit);
  bool Accumulate(int shares, const Digit& digit);
  void Scatter(int share, int shares, const Digit& digit);

  std::vector<Item> Items;
  std::vector<Item> Sorted;
  /** Per share and digit value: first how often, then where the next item goes. */
  std::vector<std::uint32_t> Places;
};

#endif
