/**
 * The cells that a ray can meet: tetrahedra, convex polyhedra and cells with warped faces. Every
 * ray is clipped against every cell whose bounding sphere it meets.
 */

#ifndef OracleCells_h
#define OracleCells_h

#include "OraclePolyhedron.h"
#include "OracleSpheres.h"
#include "OracleTetrahedron.h"
#include "OracleWarpedCell.h"

#include <vector>

class OracleCells
{
public:
  /**
   * `loops` are the faces of indices into `vertices`. Cells with a non-finite value and flat cells
   * (all vertices in one plane, to rounding) are dropped.
   */
  void AddTetrahedron(const std::vector<OracleVertex>& vertices);
  void AddPolyhedron(
    const std::vector<OracleVertex>& vertices, const std::vector<std::vector<int>>& loops);

  /** False for flat cells and those with a value that is not finite. */
  static bool IsSolid(const std::vector<OracleVertex>& vertices);

  /** Replaces `segments` by those of the ray, nearest first by their middles. */
  void Clip(const OracleRay& ray, std::vector<OracleSegment>& segments) const;

private:
  template <typename Cell>
  static void Clip(const OracleRay& ray, const OracleSpheres& spheres,
    const std::vector<Cell>& cells, std::vector<OracleSegment>& segments);

  OracleSpheres TetrahedronSpheres;
  std::vector<OracleTetrahedron> Tetrahedra;
  OracleSpheres PolyhedronSpheres;
  std::vector<OraclePolyhedron> Polyhedra;
  OracleSpheres WarpedSpheres;
  std::vector<OracleWarpedCell> WarpedCells;
};

#endif
