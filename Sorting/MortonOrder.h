/**
 * Points along a curve that keeps neighbours close: the order of their interleaved coordinates
 * (Morton 1966).
 */
#ifndef MortonOrder_h
#define MortonOrder_h

#include <vector>

class vtkBoundingBox;

namespace MortonOrder
{
/** `points`: three per point, within `box`. Their ids in order; points that are not finite come
 *  first. */
std::vector<int> Find(const std::vector<double>& points, const vtkBoundingBox& box);
}

#endif
