#include "RadixSort.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace
{
constexpr int Values = 1 << 8;
// A thread costs more to wake than this many items cost to sort.
constexpr std::size_t SmallestShare = 8192;
// More than one, so that a thread that is held up holds up little.
constexpr int SharesPerThread = 4;

std::size_t BeginOf(int share, int shares, std::size_t count)
{
  return count * static_cast<std::size_t>(share) / static_cast<std::size_t>(shares);
}

template <typename Work>
void ForEachShare(int shares, Work work)
{
  vtkSMPTools::For(0, shares, 1,
    [&work](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType share = begin; share < end; ++share)
      {
        work(static_cast<int>(share));
      }
    });
}
}

//------------------------------------------------------------------------------
struct RadixSort::Digit
{
  int Shift;
  std::uint32_t Of(const Item& item) const { return item.Key >> this->Shift & (Values - 1); }
};

//------------------------------------------------------------------------------
void RadixSort::SetNumberOfItems(std::size_t count)
{
  this->Items.resize(count);
  this->Sorted.resize(count);
}

//------------------------------------------------------------------------------
void RadixSort::Count(int share, int shares, const Digit& digit)
{
  std::uint32_t* places = this->Places.data() + static_cast<std::size_t>(share) * Values;
  std::fill_n(places, Values, 0);
  const Item* items = this->Items.data();
  const std::size_t end = BeginOf(share + 1, shares, this->Items.size());
  for (std::size_t i = BeginOf(share, shares, this->Items.size()); i < end; ++i)
  {
    ++places[digit.Of(items[i])];
  }
}

//------------------------------------------------------------------------------
// False where all items have the same value.
bool RadixSort::Accumulate(int shares)
{
  std::uint32_t place = 0;
  for (int value = 0; value < Values; ++value)
  {
    const std::uint32_t before = place;
    for (int share = 0; share < shares; ++share)
    {
      std::uint32_t& entry = this->Places[static_cast<std::size_t>(share) * Values + value];
      const std::uint32_t count = entry;
      entry = place;
      place += count;
    }
    if (place - before == this->Items.size())
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void RadixSort::Scatter(int share, int shares, const Digit& digit)
{
  std::uint32_t* places = this->Places.data() + static_cast<std::size_t>(share) * Values;
  // Copies: the compiler must take it that writing an item may move the arrays.
  const Item* items = this->Items.data();
  Item* sorted = this->Sorted.data();
  const Digit local = digit;
  const std::size_t end = BeginOf(share + 1, shares, this->Items.size());
  for (std::size_t i = BeginOf(share, shares, this->Items.size()); i < end; ++i)
  {
    const Item item = items[i];
    sorted[places[local.Of(item)]++] = item;
  }
}

//------------------------------------------------------------------------------
void RadixSort::Sort()
{
  const std::size_t most = this->Items.size() / SmallestShare + 1;
  const int shares = static_cast<int>(std::min<std::size_t>(
    most, SharesPerThread * std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads())));
  this->Places.resize(static_cast<std::size_t>(shares) * Values);
  for (const Digit& digit : { Digit{ 0 }, Digit{ 8 }, Digit{ 16 }, Digit{ 24 } })
  {
    ForEachShare(shares, [&](int share) { this->Count(share, shares, digit); });
    if (this->Accumulate(shares))
    {
      ForEachShare(shares, [&](int share) { this->Scatter(share, shares, digit); });
      this->Items.swap(this->Sorted);
    }
  }
}
