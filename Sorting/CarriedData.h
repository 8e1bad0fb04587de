/**
 * Point and cell data that go along when points and cells are chosen anew.
 */
#ifndef CarriedData_h
#define CarriedData_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDataSetAttributes;

namespace CarriedData
{
/** The arrays of `from` that have one tuple for each of `tuples` points or cells: no other can be
 *  carried. */
vtkSmartPointer<vtkDataSetAttributes> WholeArrays(vtkDataSetAttributes* from, vtkIdType tuples);

/** Tuple i of each array of `to` is tuple sources[i] of `from`. `more`: how many tuples are to be
 *  interpolated after them; arrays that cannot be, such as global ids, are then left out. */
void CopyTuples(vtkDataSetAttributes* from, vtkDataSetAttributes* to, const vtkIdType* sources,
  vtkIdType count, vtkIdType more = 0);
}

#endif
