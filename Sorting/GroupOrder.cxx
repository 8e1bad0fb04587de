#include "GroupOrder.h"

#include <set>
#include <unordered_map>

namespace GroupOrder
{
//------------------------------------------------------------------------------
void Sort(
  std::vector<int>& cells, const std::function<void(int cell, const Visit& visit)>& visitNearer)
{
  std::unordered_map<int, int> placeOf;
  for (size_t place = 0; place < cells.size(); ++place)
  {
    placeOf[cells[place]] = static_cast<int>(place);
  }
  std::vector<int> waiting(cells.size(), 0);
  const auto forNearer = [&](int place, const Visit& visit)
  {
    visitNearer(cells[place],
      [&](int cell)
      {
        const auto found = placeOf.find(cell);
        if (found != placeOf.end())
        {
          visit(found->second);
        }
      });
  };
  std::set<int> left, free;
  for (int place = 0; place < static_cast<int>(cells.size()); ++place)
  {
    forNearer(place, [&](int nearer) { ++waiting[nearer]; });
    left.insert(place);
  }
  for (const int place : left)
  {
    if (waiting[place] == 0)
    {
      free.insert(place);
    }
  }
  std::vector<int> sorted;
  while (!left.empty())
  {
    const int place = free.empty() ? *left.begin() : *free.begin();
    free.erase(place);
    left.erase(place);
    sorted.push_back(cells[place]);
    forNearer(place,
      [&](int nearer)
      {
        if (--waiting[nearer] == 0 && left.count(nearer) > 0)
        {
          free.insert(nearer);
        }
      });
  }
  cells = std::move(sorted);
}
}
