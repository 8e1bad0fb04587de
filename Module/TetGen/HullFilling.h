/**
 * Imaginary tetrahedra between a mesh and its convex hull, by TetGen.
 */
#ifndef HullFilling_h
#define HullFilling_h

#include "Convexification.h"

#include <string>

struct HullFillingResult
{
  /** Cells, volumes and whether the mesh fills its hull already, as of the cutting planes. */
  ConvexificationResult Convexification;
  /** Why there are no cells; empty where all is well. */
  std::string Failure;
  bool IsSelfIntersecting = false;
};

namespace HullFilling
{
HullFillingResult Run(const CellComplex& mesh);
}

#endif
