/**
 * A vertex of a cell: the mesh's point id (it fixes every choice that two cells must make alike),
 * the position in world units relative to the mesh's centre, the scalar, its gradient where one is
 * asked for, and where colours do not come from the scalar a colour, or in X the scalar of it.
 */

#ifndef OracleVertex_h
#define OracleVertex_h

#include "OracleVector.h"

struct OracleVertex
{
  long long Id = 0;
  OracleVector Position;
  double Scalar = 0.0;
  OracleVector Gradient;
  OracleVector Color;
};

#endif
