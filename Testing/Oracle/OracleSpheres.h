/**
 * The bounding spheres of cells, in the cells' order, and one sphere around every 8, 64 and 512 of them in a row: a
 * ray that misses such a run is not asked cell by cell.
 *
 * Every sphere may be too large, none too small: no cell that a ray meets is left out.
 */

#ifndef OracleSpheres_h
#define OracleSpheres_h

#include "OracleRay.h"
#include "OracleVertex.h"

#include <array>
#include <vector>

class OracleSpheres
{
public:
  /** The mean of the vertices, about which a cell's sphere is. */
  static OracleVector GetCenter(const std::vector<OracleVertex>& vertices);

  /** The sphere of the next cell. */
  void Add(const std::vector<OracleVertex>& vertices);

  /** How many cells from `index` on are a run, or one cell, that the ray misses as a whole; 0: it may meet the cell. */
  std::size_t CountMissed(const OracleRay& ray, std::size_t index) const;

private:
  struct Sphere
  {
    OracleVector Center;
    double Radius;
  };
  static constexpr std::size_t Run = 8;

  static Sphere Enclose(const Sphere& a, const Sphere& b);
  static bool Meets(const OracleRay& ray, const Sphere& sphere);

  // Of single cells, then of runs, each of 8 of the level before.
  std::array<std::vector<Sphere>, 4> Levels;
};

#endif
