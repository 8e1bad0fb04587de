/**
 * The best order of cells that may hide each other in circles.
 */
#ifndef GroupOrder_h
#define GroupOrder_h

#include <utility>
#include <vector>

namespace GroupOrder
{
/** Items 0 .. count - 1, numbered from far to near by their centres; `relations`: pairs of them,
 *  the first before the second. Gives the circles and the single items that are in none, in an
 *  order that follows all relations between them. Within a circle as many relations as can be are
 *  followed; where there is no choice left, the farthest item goes first. */
std::vector<std::vector<int>> Find(int count, const std::vector<std::pair<int, int>>& relations);
}

#endif
