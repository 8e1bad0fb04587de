#include "MortonOrder.h"

#include "vtkBoundingBox.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdint>

namespace
{
constexpr double Resolution = 2097151.0; // 21 bits

// Leaves two free bits between any two of the 21.
std::uint64_t Spread(std::uint64_t x)
{
  x = (x | (x << 32)) & 0x1f00000000ffffULL;
  x = (x | (x << 16)) & 0x1f0000ff0000ffULL;
  x = (x | (x << 8)) & 0x100f00f00f00f00fULL;
  x = (x | (x << 4)) & 0x10c30c30c30c30c3ULL;
  return (x | (x << 2)) & 0x1249249249249249ULL;
}
}

namespace MortonOrder
{
//------------------------------------------------------------------------------
std::vector<int> Find(const std::vector<double>& points, const vtkBoundingBox& box)
{
  struct Key
  {
    std::uint64_t Code;
    int Id;
  };
  std::vector<Key> keys(points.size() / 3);
  const double* low = box.GetMinPoint();
  const double largest = box.GetMaxLength();
  vtkSMPTools::For(0, static_cast<vtkIdType>(keys.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        std::uint64_t code = 0;
        for (int k = 0; k < 3; ++k)
        {
          const double x = largest > 0.0 ? (points[3 * i + k] - low[k]) / largest : 0.0;
          const double cell = std::min(std::max(0.0, x * Resolution), Resolution);
          code |= Spread(static_cast<std::uint64_t>(cell)) << k;
        }
        keys[i] = { code, static_cast<int>(i) };
      }
    });
  vtkSMPTools::Sort(keys.begin(), keys.end(),
    [](const Key& a, const Key& b) { return a.Code != b.Code ? a.Code < b.Code : a.Id < b.Id; });
  std::vector<int> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(), [](const Key& key) { return key.Id; });
  return order;
}
}
