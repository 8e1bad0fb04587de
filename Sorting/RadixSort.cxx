#include "RadixSort.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace
{
// A thread costs more to wake than this many items cost to sort.
constexpr std::size_t SmallestShare = 8192;
// More than one, so that a thread that is held up holds up little.
constexpr int SharesPerThread = 4;
// Twice 8 bytes of this many items fit the cache of one core.
constexpr std::size_t LargestBucket = 1 << 16;
// Buckets are many and small.
constexpr vtkIdType BucketsAtATime = 4;

template <typename Work>
void ForEach(vtkIdType count, vtkIdType grain, Work work)
{
  vtkSMPTools::For(0, count, grain,
    [&work](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        work(static_cast<int>(i));
      }
    });
}

template <typename Range>
std::size_t BeginOf(const Range& range, int share, int shares)
{
  const std::size_t count = range.End - range.Begin;
  return range.Begin + count * static_cast<std::size_t>(share) / static_cast<std::size_t>(shares);
}
}

//------------------------------------------------------------------------------
void RadixSort::SetNumberOfItems(std::size_t count)
{
  this->Items.resize(count);
  this->Sorted.resize(count);
}

//------------------------------------------------------------------------------
void RadixSort::FindDigit(Range& range, int shares)
{
  this->Extremes.resize(shares);
  ForEach(shares, 1,
    [&](int share)
    {
      const Item* item = this->Items.data() + BeginOf(range, share, shares);
      const Item* const end = this->Items.data() + BeginOf(range, share + 1, shares);
      std::uint32_t least = item->Key;
      std::uint32_t greatest = least;
      for (; item != end; ++item)
      {
        least = std::min(least, item->Key);
        greatest = std::max(greatest, item->Key);
      }
      this->Extremes[share] = { { least, greatest } };
    });
  std::uint32_t greatest = 0;
  range.Least = this->Extremes[0][0];
  for (const auto& extremes : this->Extremes)
  {
    range.Least = std::min(range.Least, extremes[0]);
    greatest = std::max(greatest, extremes[1]);
  }
  range.Shift = 0;
  while ((greatest - range.Least) >> range.Shift >= Values)
  {
    ++range.Shift;
  }
}

//------------------------------------------------------------------------------
void RadixSort::Count(const Range& range, int share, int shares)
{
  std::uint32_t* places = this->Places.data() + static_cast<std::size_t>(share) * Values;
  std::fill_n(places, Values, 0);
  const Item* items = this->Items.data();
  const Range local = range;
  const std::size_t end = BeginOf(range, share + 1, shares);
  for (std::size_t i = BeginOf(range, share, shares); i < end; ++i)
  {
    ++places[(items[i].Key - local.Least) >> local.Shift];
  }
}

//------------------------------------------------------------------------------
void RadixSort::Accumulate(const Range& range, int shares, Bounds& buckets)
{
  std::size_t place = range.Begin;
  for (int value = 0; value < Values; ++value)
  {
    buckets[value] = place;
    for (int share = 0; share < shares; ++share)
    {
      std::uint32_t& entry = this->Places[static_cast<std::size_t>(share) * Values + value];
      const std::uint32_t count = entry;
      entry = static_cast<std::uint32_t>(place);
      place += count;
    }
  }
  buckets[Values] = place;
}

//------------------------------------------------------------------------------
void RadixSort::Scatter(const Range& range, int share, int shares)
{
  std::uint32_t* places = this->Places.data() + static_cast<std::size_t>(share) * Values;
  // Copies: the compiler must take it that writing an item may move the arrays.
  const Item* items = this->Items.data();
  Item* sorted = this->Sorted.data();
  const Range local = range;
  const std::size_t end = BeginOf(range, share + 1, shares);
  for (std::size_t i = BeginOf(range, share, shares); i < end; ++i)
  {
    const Item item = items[i];
    sorted[places[(item.Key - local.Least) >> local.Shift]++] = item;
  }
}

//------------------------------------------------------------------------------
// An odd number of passes over the bits that are left, so that the items end where they began.
void RadixSort::SortBucket(const Range& range, std::size_t begin, std::size_t end)
{
  constexpr int mostPasses = 3;
  const int passes = range.Shift > 8 ? mostPasses : 1;
  std::uint32_t places[mostPasses][Values] = {};
  Item* from = this->Sorted.data() + begin;
  Item* to = this->Items.data() + begin;
  const std::size_t count = end - begin;
  const auto digitOf = [least = range.Least](const Item& item, int pass)
  { return (item.Key - least) >> (8 * pass) & (Values - 1); };
  for (std::size_t i = 0; i < count; ++i)
  {
    for (int pass = 0; pass < mostPasses; ++pass)
    {
      ++places[pass][digitOf(from[i], pass)];
    }
  }
  for (int pass = 0; pass < passes; ++pass, std::swap(from, to))
  {
    std::exclusive_scan(places[pass], places[pass] + Values, places[pass], 0u);
    for (std::size_t i = 0; i < count; ++i)
    {
      const Item item = from[i];
      to[places[pass][digitOf(item, pass)]++] = item;
    }
  }
}

//------------------------------------------------------------------------------
void RadixSort::SortLargeBucket(const Range& range, std::size_t begin, std::size_t end)
{
  vtkSMPTools::For(static_cast<vtkIdType>(begin), static_cast<vtkIdType>(end),
    static_cast<vtkIdType>(SmallestShare),
    [this](vtkIdType first, vtkIdType last)
    { std::copy(&this->Sorted[first], &this->Sorted[first] + (last - first), &this->Items[first]); });
  if (range.Shift > 0)
  {
    this->SortRange(begin, end);
  }
}

//------------------------------------------------------------------------------
void RadixSort::SortRange(std::size_t begin, std::size_t end)
{
  Range range = { begin, end, 0, 0 };
  const std::size_t most = (end - begin) / SmallestShare + 1;
  const int shares = static_cast<int>(std::min<std::size_t>(
    most, SharesPerThread * std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads())));
  this->Places.resize(static_cast<std::size_t>(shares) * Values);
  Bounds buckets;
  this->FindDigit(range, shares);
  ForEach(shares, 1, [&](int share) { this->Count(range, share, shares); });
  this->Accumulate(range, shares, buckets);
  ForEach(shares, 1, [&](int share) { this->Scatter(range, share, shares); });
  ForEach(Values, BucketsAtATime,
    [&](int value)
    {
      if (buckets[value + 1] - buckets[value] <= LargestBucket)
      {
        this->SortBucket(range, buckets[value], buckets[value + 1]);
      }
    });
  for (int value = 0; value < Values; ++value)
  {
    if (buckets[value + 1] - buckets[value] > LargestBucket)
    {
      this->SortLargeBucket(range, buckets[value], buckets[value + 1]);
    }
  }
}

//------------------------------------------------------------------------------
void RadixSort::Sort()
{
  if (!this->Items.empty())
  {
    this->SortRange(0, this->Items.size());
  }
}
