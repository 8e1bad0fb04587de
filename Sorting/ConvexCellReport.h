/**
 * What became of which cells: the table of vtkConvexCells::GetReport().
 */
#ifndef ConvexCellReport_h
#define ConvexCellReport_h

#include "ConvexCellPlan.h"

#include <vector>

class vtkTable;

namespace ConvexCellReport
{
/** By input cell: its plan, its VTK type, and how many cells it became. */
void Fill(const std::vector<ConvexCellPlan>& plans, const std::vector<unsigned char>& types,
  const std::vector<int>& outputs, vtkTable* report);
}

#endif
