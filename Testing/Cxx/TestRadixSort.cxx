// The radix sort is std::stable_sort on keys of every kind, and keys compare as their floats do.

#include "RadixSort.h"
#include "TestScene.h"

#include <algorithm>
#include <chrono>
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

bool SortsAsStableSort(RadixSort& sort, std::size_t count, std::uint32_t mask)
{
  std::mt19937 random(7);
  Items items(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    items[i] = { static_cast<std::uint32_t>(random()) & mask, static_cast<std::uint32_t>(i) };
  }
  sort.SetNumberOfItems(count);
  std::copy(items.begin(), items.end(), sort.GetItems());
  sort.Sort();
  std::stable_sort(items.begin(), items.end(),
    [](const RadixSort::Item& a, const RadixSort::Item& b) { return a.Key < b.Key; });
  return AreEqual(items, sort);
}

void CheckOrder(TestChecks& checks)
{
  RadixSort sort;
  for (const std::size_t count : { 0, 1, 2, 3, 1000, 8191, 8192, 100000, 1300000, 5 })
  {
    for (const std::uint32_t mask : { 0xffffffffu, 0x0u, 0x7u, 0x003ff800u, 0xffc00000u })
    {
      CHECK(SortsAsStableSort(sort, count, mask));
    }
  }
}

void CheckKeys(TestChecks& checks)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const float ascending[] = { -infinity, -3e38f, -1.0f, -1e-30f, -1e-42f, 0.0f, 1e-42f, 1e-30f,
    1.0f, std::nextafter(1.0f, 2.0f), 3e38f, infinity };
  for (std::size_t i = 1; i < std::size(ascending); ++i)
  {
    CHECK(RadixSort::KeyOf(ascending[i - 1]) < RadixSort::KeyOf(ascending[i]));
  }
  CHECK(RadixSort::KeyOf(-0.0f) == RadixSort::KeyOf(0.0f));
  CHECK(RadixSort::KeyOf(std::nanf("")) == RadixSort::KeyOf(-infinity));
}

// Nothing is allocated for a second array of the same size: the two buffers only change places.
void CheckBuffers(TestChecks& checks)
{
  RadixSort sort;
  CHECK(SortsAsStableSort(sort, 50000, 0xffffffffu));
  const RadixSort::Item* first = sort.GetItems();
  CHECK(SortsAsStableSort(sort, 50000, 0xffffffffu));
  const RadixSort::Item* second = sort.GetItems();
  CHECK(SortsAsStableSort(sort, 50000, 0xffffffffu));
  CHECK(sort.GetItems() == first || sort.GetItems() == second);
}

// Printed, never checked.
void PrintSpeed()
{
  constexpr std::size_t count = 1300000;
  RadixSort sort;
  sort.SetNumberOfItems(count);
  double best = 1e9;
  for (int run = 0; run < 9; ++run)
  {
    std::mt19937 random(run);
    for (std::size_t i = 0; i < count; ++i)
    {
      const float value = std::ldexp(static_cast<float>(random()), -30) - 2.0f;
      sort.GetItems()[i] = { RadixSort::KeyOf(value), static_cast<std::uint32_t>(i) };
    }
    const auto start = std::chrono::steady_clock::now();
    sort.Sort();
    best = std::min(
      best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::cout << "1.3 M items: " << 1e-6 * count / best << " M keys/s\n";
}
}

int TestRadixSort(int, char*[])
{
  TestChecks checks;
  CheckOrder(checks);
  CheckKeys(checks);
  CheckBuffers(checks);
  PrintSpeed();
  return checks.Result();
}
