#include "GroupOrder.h"

#include "StrongComponents.h"

#include <algorithm>
#include <set>

namespace
{
using Relations = std::vector<std::pair<int, int>>;

// The items that the relations lead to, one list per item.
std::vector<std::vector<int>> ListTargets(int count, const Relations& relations, bool forward)
{
  std::vector<std::vector<int>> lists(static_cast<size_t>(count));
  for (const auto& relation : relations)
  {
    lists[forward ? relation.first : relation.second].push_back(
      forward ? relation.second : relation.first);
  }
  return lists;
}

void SortCircle(std::vector<int>& circle, const std::vector<std::vector<int>>& after)
{
  std::sort(circle.begin(), circle.end());
  std::vector<int> waiting(circle.size(), 0);
  const auto forAfter = [&](int item, const auto& act)
  {
    for (const int next : after[item])
    {
      const auto found = std::lower_bound(circle.begin(), circle.end(), next);
      if (found != circle.end() && *found == next)
      {
        act(static_cast<int>(found - circle.begin()));
      }
    }
  };
  std::set<int> left, free;
  for (int place = 0; place < static_cast<int>(circle.size()); ++place)
  {
    forAfter(circle[place], [&](int next) { ++waiting[next]; });
    left.insert(place);
  }
  std::vector<int> sorted;
  while (!left.empty())
  {
    const int place = free.empty() ? *left.begin() : *free.begin();
    free.erase(place);
    left.erase(place);
    sorted.push_back(circle[place]);
    forAfter(circle[place],
      [&](int next)
      {
        if (--waiting[next] == 0 && left.count(next) > 0)
        {
          free.insert(next);
        }
      });
  }
  circle = std::move(sorted);
}
}

namespace GroupOrder
{
//------------------------------------------------------------------------------
std::vector<std::vector<int>> Find(int count, const Relations& relations)
{
  const std::vector<std::vector<int>> after = ListTargets(count, relations, true);
  const std::vector<std::vector<int>> before = ListTargets(count, relations, false);
  std::vector<std::vector<int>> groups;
  // Walked against the relations, a circle is given out after all that comes before it.
  StrongComponents components;
  components.Reset(count);
  const auto getEdge = [&](int item, int edge)
  { return edge < static_cast<int>(before[item].size()) ? before[item][edge] : -2; };
  for (int item = 0; item < count; ++item)
  {
    if (!components.HasSeen(item))
    {
      components.Walk(
        item, getEdge, [](int) { return false; },
        [&](std::vector<int>& circle)
        {
          SortCircle(circle, after);
          groups.push_back(circle);
        });
    }
  }
  return groups;
}
}
