/**
 * The best order of cells that have none.
 */
#ifndef GroupOrder_h
#define GroupOrder_h

#include <functional>
#include <vector>

namespace GroupOrder
{
using Visit = std::function<void(int)>;

/** Reorders `cells`, given from far to near by their centres, so that as many as can be follow
 *  those behind them; where only circles are left, the farthest goes first. `visitNearer`: calls
 *  back with each cell that must come after one; cells that are not in the group are passed over.
 */
void Sort(
  std::vector<int>& cells, const std::function<void(int cell, const Visit& visit)>& visitNearer);
}

#endif
