// The radix sort is std::stable_sort on keys of every kind, and keys compare as their numbers do.

#include "RadixSort.h"
#include "TestScene.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <random>

namespace
{
using Items = std::vector<RadixSort::Item>;

bool AreEqual(const Items& expected, RadixSort& sort)
{
  return std::equal(expected.begin(), expected.end(), sort.GetItems(),
    [](const RadixSort::Item& a, const RadixSort::Item& b)
    { return a.Key == b.Key && a.Id == b.Id; });
}

// Every item is in one part, sorted when it is visited, together with all of its key.
bool SortsAsStableSort(RadixSort& sort, Items items)
{
  const Items unsorted = items;
  std::stable_sort(items.begin(), items.end(),
    [](const RadixSort::Item& a, const RadixSort::Item& b) { return a.Key < b.Key; });
  std::vector<int> visits(items.size(), 0);
  std::atomic<int> wrong(0);
  sort.SetKeys(items.size(), [&](std::size_t i) { return unsorted[i].Key; });
  sort.Sort(
    [&](const RadixSort::Item* sorted, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        ++visits[i];
        wrong += sorted[i].Key != items[i].Key || sorted[i].Id != items[i].Id;
      }
      wrong += begin > 0 && items[begin - 1].Key == items[begin].Key;
    });
  return wrong == 0 && AreEqual(items, sort) &&
         std::all_of(visits.begin(), visits.end(), [](int count) { return count == 1; });
}

bool SortsAsStableSort(RadixSort& sort, std::size_t count, std::uint32_t mask)
{
  std::mt19937 random(7);
  Items items(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    items[i] = { static_cast<std::uint32_t>(random()) & mask, static_cast<std::uint32_t>(i) };
  }
  return SortsAsStableSort(sort, items);
}

void CheckOrder(TestChecks& checks)
{
  RadixSort sort;
  // The last but one is more than eight threads share.
  for (const std::size_t count : { 0, 1, 2, 3, 1000, 8191, 8192, 100000, 300000, 5 })
  {
    for (const std::uint32_t mask : { 0xffffffffu, 0x0u, 0x7u, 0x003ff800u, 0xffc00000u })
    {
      CHECK(SortsAsStableSort(sort, count, mask));
    }
  }
}

void CheckKeys(TestChecks& checks)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double ascending[] = { -infinity, -1e6, -1e3, -1.0, -1e-9, 0.0, 1e-9, 0.5, 1.0, 1.0 + 1e-8,
    1e3, 1e6, infinity };
  for (std::size_t i = 1; i < std::size(ascending); ++i)
  {
    CHECK(RadixSort::KeyOf(ascending[i - 1]) < RadixSort::KeyOf(ascending[i]));
  }
  CHECK(RadixSort::KeyOf(-0.0) == RadixSort::KeyOf(0.0));
  CHECK(RadixSort::KeyOf(std::nan("")) == RadixSort::KeyOf(infinity));
  std::mt19937_64 random(9);
  for (int run = 0; run < 200000; ++run)
  {
    const double value = std::ldexp(static_cast<double>(random()), run % 120 - 120) - 1.0;
    CHECK(RadixSort::KeyOf(value) <= RadixSort::KeyOf(std::nextafter(value, infinity)));
  }
}

// Nothing is allocated for more arrays of the same size: two take turns.
void CheckBuffers(TestChecks& checks)
{
  RadixSort sort;
  CHECK(SortsAsStableSort(sort, 50000, 0xffffffffu));
  const RadixSort::Item* first = sort.GetItems();
  CHECK(SortsAsStableSort(sort, 50000, 0xffffffffu));
  CHECK(SortsAsStableSort(sort, 50000, 0xffffffffu));
  CHECK(sort.GetItems() == first);
}

// Keys that lie in one or two of the 256 buckets are parted again.
void CheckUnevenKeys(TestChecks& checks)
{
  RadixSort sort;
  std::mt19937 random(11);
  for (const std::uint32_t spread : { 0x0u, 0x3u, 0xffffu, 0xfffffu })
  {
    Items items(400000);
    for (std::size_t i = 0; i < items.size(); ++i)
    {
      const std::uint32_t key = 0x70000000u + (static_cast<std::uint32_t>(random()) & spread);
      items[i] = { i == 5 ? 0u : i == 70000 ? 0xffffffffu : key, static_cast<std::uint32_t>(i) };
    }
    CHECK(SortsAsStableSort(sort, items));
  }
}

// The many fill one bucket of the first pass, by the largest key, and of the second, by the next.
void CheckThirdParting(TestChecks& checks)
{
  constexpr std::uint32_t least = 0x10000000u;
  RadixSort sort;
  std::mt19937 random(13);
  Items items(200000);
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    items[i] = { least + (static_cast<std::uint32_t>(random()) & 0xffu),
      static_cast<std::uint32_t>(i) };
  }
  items[7].Key = least + (1u << 16);
  items[90000].Key = least + (1u << 31);
  CHECK(SortsAsStableSort(sort, items));
}
}

int TestRadixSort(int, char*[])
{
  TestChecks checks;
  CheckOrder(checks);
  CheckKeys(checks);
  CheckUnevenKeys(checks);
  CheckThirdParting(checks);
  CheckBuffers(checks);
  return checks.Result();
}
