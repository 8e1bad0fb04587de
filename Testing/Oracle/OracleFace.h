/**
 * One face of a cell: its plane and its triangles, a fan from the smallest point id.
 *
 * Both depend on the points and their ids alone, so two cells that share the face get the same
 * bits, in any winding and numbering.
 */

#ifndef OracleFace_h
#define OracleFace_h

#include "OracleVertex.h"

#include <array>
#include <vector>

class OracleFace
{
public:
  /** Three vertices, ascending by id. */
  using Triangle = std::array<OracleVertex, 3>;

  /** A loop of vertices, of either winding; repeated points are dropped. */
  explicit OracleFace(std::vector<OracleVertex> loop);

  /** No normal: fewer than three points, or all on one line. */
  bool IsDegenerate() const { return !(this->Length > 0.0); }

  const OracleVector& GetPoint() const { return this->Point; }
  const OracleVector& GetNormal() const { return this->Normal; }
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }

  /** The signed distance from the plane. */
  double GetDistance(const OracleVector& position) const;

  /** The largest distance of a vertex of the face from the plane. */
  double GetWarp() const;

  /**
   * The scalar at a position in the plane. `inside` is the smallest barycentric weight in the best
   * triangle: not negative where the face holds the position; beyond, the nearest edge's scalar.
   */
  double Interpolate(const OracleVector& position, double& inside) const;

private:
  double Interpolate(const Triangle& triangle, const OracleVector& position, double& inside) const;

  OracleVector Point;
  OracleVector Normal;
  double Length = 0.0;
  std::vector<Triangle> Triangles;
};

#endif
