/**
 * The shift of one value that makes the largest of several errors least.
 */
#ifndef ErrorBalance_h
#define ErrorBalance_h

#include <utility>
#include <vector>

namespace ErrorBalance
{
/** `errors`: of each its size now, and how much of the shift it takes (0 .. 1). The shift lies in
 *  -reach .. reach; 0 where none makes the largest error less. */
double FindShift(const std::vector<std::pair<double, double>>& errors, double reach);
}

#endif
