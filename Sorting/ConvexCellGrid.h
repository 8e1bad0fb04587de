/**
 * The cells that ConvexCellPlan and PolyhedronPlan wrote, as a grid without points.
 */
#ifndef ConvexCellGrid_h
#define ConvexCellGrid_h

#include "vtkSmartPointer.h"

class vtkIdTypeArray;
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;

namespace ConvexCellGrid
{
/** As ConvexCellArrays. Without polyhedra, the arrays become the grid's. */
vtkSmartPointer<vtkUnstructuredGrid> Make(
  vtkUnsignedCharArray* types, vtkIdTypeArray* offsets, vtkIdTypeArray* ids);
}

#endif
