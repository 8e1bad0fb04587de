/**
 * Points at the very same coordinates, named by the smallest of their ids.
 *
 * Method: one open-addressed hash table of ids, filled by all threads at once; a slot belongs to
 * one position for good and holds the smallest id seen there. Linear time however the points are
 * spread (a bucket locator is quadratic in its fullest bucket, so that one far outlier stalls it),
 * and the answer does not depend on the threads. Coordinates are compared as numbers, without a
 * tolerance; -0 equals 0.
 */
#ifndef CoincidentPoints_h
#define CoincidentPoints_h

#include "vtkType.h"

class PointCoordinates;

namespace CoincidentPoints
{
/**
 * `canonical`, one per point: on entry, negative values exclude points (those that are not finite
 * must be) and stay; on return, the others are the smallest id at the point's position.
 */
void Merge(const PointCoordinates& points, vtkIdType numberOfPoints, vtkIdType* canonical);
}

#endif
