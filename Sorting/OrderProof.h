/**
 * How wrong an order is for an eye.
 */
#ifndef OrderProof_h
#define OrderProof_h

#include "CellComplex.h"
#include "vtkType.h"

#include <vector>

namespace OrderProof
{
/** Contacts whose two cells come out in the wrong order; those seen edge-on apart, and those of
 *  cells that are not in the order. `order`: ids, farthest first. `eye`: as for
 *  ExactOrientation::SideOfEye. */
vtkIdType CountMisordered(
  const CellComplex& complex, const std::vector<vtkIdType>& order, const double eye[4]);
}

#endif
