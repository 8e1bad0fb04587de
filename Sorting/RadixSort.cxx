#include "RadixSort.h"

#include <hwy/cache_control.h>

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
// By so many places items may move on average before insertion gives way to another sort.
constexpr std::size_t MostMoves = 4;
// Two lines of the cache.
constexpr std::size_t Ahead = 16;
// Buckets are many and small.
constexpr vtkIdType BucketsAtATime = 4;

// Items whose leading bits are in order: those that differ in the others are few, and close.
void Settle(RadixSort::Item* begin, RadixSort::Item* end)
{
  const std::size_t most = MostMoves * static_cast<std::size_t>(end - begin);
  std::size_t moves = 0;
  for (RadixSort::Item* at = begin + 1; at < end; ++at)
  {
    if (at[-1].Key <= at->Key)
    {
      continue;
    }
    const RadixSort::Item item = *at;
    RadixSort::Item* to = at;
    for (; to > begin && to[-1].Key > item.Key; --to)
    {
      *to = to[-1];
    }
    *to = item;
    moves += static_cast<std::size_t>(at - to);
    if (moves > most)
    {
      std::stable_sort(begin, end,
        [](const RadixSort::Item& a, const RadixSort::Item& b) { return a.Key < b.Key; });
      return;
    }
  }
}

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
}

//------------------------------------------------------------------------------
int RadixSort::CountShares(std::size_t items)
{
  return static_cast<int>(std::min<std::size_t>(items / SmallestShare + 1,
    SharesPerThread * std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads())));
}

//------------------------------------------------------------------------------
std::size_t RadixSort::BeginOf(const Range& range, int share, int shares)
{
  const std::size_t count = range.End - range.Begin;
  return range.Begin + count * static_cast<std::size_t>(share) / static_cast<std::size_t>(shares);
}

//------------------------------------------------------------------------------
void RadixSort::SetNumberOfItems(std::size_t count)
{
  this->Items.resize(count);
  this->Sorted.resize(count);
  this->Places.assign(static_cast<std::size_t>(CountShares(count)) * Values, 0);
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
  range.Least = UINT32_MAX;
  for (int share = 0; share < shares; ++share)
  {
    range.Least = std::min(range.Least, this->Extremes[share][0]);
    greatest = std::max(greatest, this->Extremes[share][1]);
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
    Item* const to = sorted + places[(item.Key - local.Least) >> local.Shift]++;
    // The bucket's next line: the processor foresees few streams, and these are as many as buckets.
    hwy::Prefetch(to + Ahead);
    *to = item;
  }
}

//------------------------------------------------------------------------------
// Two passes, so that the items end where they began, over the leading bits that are left.
void RadixSort::SortBucket(const Range& range, std::size_t begin, std::size_t end)
{
  constexpr int passes = 2;
  const int rest = std::max(0, range.Shift - 8 * passes);
  std::uint32_t places[passes][Values] = {};
  Item* from = this->Sorted.data() + begin;
  const std::size_t count = end - begin;
  std::vector<Item>& between = this->Between->Local();
  between.resize(std::max(between.size(), count));
  Item* to = between.data();
  const auto digitOf = [rest, least = range.Least](const Item& item, int pass)
  { return (item.Key - least) >> (rest + 8 * pass) & (Values - 1); };
  for (std::size_t i = 0; i < count; ++i)
  {
    for (int pass = 0; pass < passes; ++pass)
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
  if (rest > 0)
  {
    Settle(from, from + count);
  }
}

//------------------------------------------------------------------------------
void RadixSort::SortLargeBucket(
  const Range& range, std::size_t begin, std::size_t end, const Visitor& visit)
{
  if (range.Shift == 0)
  {
    visit(this->Sorted.data(), begin, end);
    return;
  }
  vtkSMPTools::For(static_cast<vtkIdType>(begin), static_cast<vtkIdType>(end),
    static_cast<vtkIdType>(SmallestShare),
    [this](vtkIdType first, vtkIdType last)
    { std::copy(&this->Sorted[first], &this->Sorted[first] + (last - first), &this->Items[first]); });
  Range bucket = { begin, end, 0, 0 };
  const int shares = CountShares(end - begin);
  this->FindDigit(bucket, shares);
  this->Places.resize(static_cast<std::size_t>(shares) * Values);
  ForEach(shares, 1, [&](int share) { this->Count(bucket, share, shares); });
  this->Part(bucket, shares, visit);
}

//------------------------------------------------------------------------------
// Of items that are counted.
void RadixSort::Part(const Range& range, int shares, const Visitor& visit)
{
  Bounds buckets;
  this->Accumulate(range, shares, buckets);
  ForEach(shares, 1, [&](int share) { this->Scatter(range, share, shares); });
  ForEach(Values, BucketsAtATime,
    [&](int value)
    {
      const std::size_t count = buckets[value + 1] - buckets[value];
      if (count > 0 && count <= LargestBucket)
      {
        this->SortBucket(range, buckets[value], buckets[value + 1]);
        visit(this->Sorted.data(), buckets[value], buckets[value + 1]);
      }
    });
  for (int value = 0; value < Values; ++value)
  {
    if (buckets[value + 1] - buckets[value] > LargestBucket)
    {
      this->SortLargeBucket(range, buckets[value], buckets[value + 1], visit);
    }
  }
}

//------------------------------------------------------------------------------
void RadixSort::Sort(const Visitor& visit)
{
  if (!this->Items.empty())
  {
    const Range all = { 0, this->Items.size(), 0, FirstShift };
    this->Part(all, static_cast<int>(this->Places.size() / Values), visit);
    this->Items.swap(this->Sorted);
  }
}
