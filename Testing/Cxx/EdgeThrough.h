#ifndef EdgeThrough_h
#define EdgeThrough_h

#include <array>

/// Whether an edge of one cell runs through a triangle of another.
namespace EdgeThrough
{
using Triangle = std::array<const double*, 3>;

/// Beyond rounding, which moves a point by `slack` at most.
bool Runs(const double from[3], const double to[3], const Triangle& triangle, double slack);
}

#endif
