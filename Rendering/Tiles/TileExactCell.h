/**
 * One tetrahedron on the screen, set up in double from its points in the mesh.
 *
 * For the cells that floats on the screen do not serve: those that reach the near or the far plane
 * or behind the eye, with a face seen almost edge-on, or so thin that their scalar changes faster
 * than a float's step. Any eye will do, inside the cell too.
 *
 * A face's plane comes from its points in ascending order: both of its cells find the same numbers
 * and agree on every pixel. A ray inside the plane of a face counts as moved a little, all rays to
 * the same side.
 */
#ifndef TileExactCell_h
#define TileExactCell_h

#include <glm/vec3.hpp>

#include <array>

class TileMesh;
class TileView;

class TileExactCell
{
public:
  TileExactCell(const TileMesh& mesh, const TileView& view, int cell);

  /** Of face f: A x + B y + E + C u is 0 on it, Inverse is -1 / C; a value below Tolerance counts
   * as Nudge. */
  struct Plane
  {
    double A, B, C, E;
    double Inverse, Tolerance, Nudge;
    /** Whether rays enter the cell there: inside u lies below the plane. */
    bool IsEntry;
  };
  std::array<Plane, 4> Planes;
  /** scalar * weight = A x + B y + C u + E. */
  double ScalarA = 0.0, ScalarB = 0.0, ScalarC = 0.0, ScalarE = 0.0;
  /** What is drawn is cut into parts over which a ray's weight (class TileView) falls to no lesser share, or rounding
   * would prove them out of order; at most so many, from no greater multiple of the last weight on. */
  static constexpr double LeastShare = 0.25, MostWeight = 17592186044416.0;
  static constexpr int MostParts = 24;
  /** First and last pixel column, first and last row; empty where last < first. */
  std::array<int, 4> Box{ { 0, 0, -1, -1 } };
  /** Whether all of it lies between the near and the far plane. */
  bool IsBetween = false;

private:
  using Points = std::array<glm::dvec3, 4>;

  void SetPlanes(const Points& points, bool positive, const TileView& view);
  void SetScalar(const Points& points, const double (&scalars)[4], const TileView& view);
  void SetBox(const Points& points, const TileView& view);
};

#endif
