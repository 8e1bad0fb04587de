/**
 * The gradient of the scalar at every point of a mesh of tetrahedra: the mean of those of the
 * tetrahedra around the point, weighted by their volumes.
 *
 * Tetrahedra that the oracle does not draw (flat, hidden, with a value that is not finite) have no
 * part in it.
 */

#ifndef OracleGradients_h
#define OracleGradients_h

#include "OracleVertex.h"

#include <unordered_map>
#include <vector>

class OracleGradients
{
public:
  /** Four vertices in any order. */
  void AddTetrahedron(const std::vector<OracleVertex>& vertices);

  /** Zero for a point of no tetrahedron. */
  OracleVector GetGradient(long long id) const;

private:
  struct Sum
  {
    OracleVector Gradient;
    double Volume = 0.0;
  };
  std::unordered_map<long long, Sum> Sums;
};

#endif
