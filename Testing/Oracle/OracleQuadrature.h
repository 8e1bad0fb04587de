/**
 * Gauss-Legendre rule on [0, 1] with running integrals: exact for polynomials of degree 2 n - 1
 * over the whole interval, and for those of degree n - 1 from 0 to each node.
 */

#ifndef OracleQuadrature_h
#define OracleQuadrature_h

#include <array>

class OracleQuadrature
{
public:
  static constexpr int Size = 8;
  using Values = std::array<double, Size>;

  OracleQuadrature();

  /** Where the integrand is wanted, ascending in (0, 1). */
  const Values& GetNodes() const { return this->Nodes; }

  /** The integral over [0, 1] of what has these values at the nodes. */
  double Integrate(const Values& values) const;

  /** The integrals from 0 to each node. */
  Values IntegrateToNodes(const Values& values) const;

private:
  Values Nodes;
  Values Weights;
  std::array<Values, Size> Running;
};

#endif
