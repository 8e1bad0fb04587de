/**
 * A cell that is curved, or next to a curved one, and goes out as the pieces that CurvedCells has of
 * it. Those of negative volume are turned, those without one dropped.
 */
#ifndef ReplacedCell_h
#define ReplacedCell_h

#include "ConvexCellPlan.h"

class ConvexCellPoints;
class CurvedCells;

namespace ReplacedCell
{
/** Moves the cursor past what Write will write. */
ConvexCellPlan Plan(const CurvedCells& curved, const ConvexCellPoints& points, vtkIdType cell,
  ConvexCellCursor& cursor);

void Write(const CurvedCells& curved, const ConvexCellPoints& points, vtkIdType cell,
  const ConvexCellArrays& arrays, ConvexCellCursor& cursor);
}

#endif
