/**
 * The points and planes that the parts of an exterior volume share.
 *
 * Coordinates are relative to a point of the mesh, so that a mesh far from the origin loses
 * nothing. Ids of points below the mesh's number of points are the mesh's own; none of those ever
 * moves. Planes are those of boundary triangles, one for all triangles that lie in it, and of the
 * enclosure.
 */
#ifndef ExteriorGeometry_h
#define ExteriorGeometry_h

#include "CellComplex.h"
#include "PlanarRegion.h"

#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

class ExteriorGeometry
{
public:
  explicit ExteriorGeometry(const CellComplex& mesh);

  struct Plane
  {
    std::array<double, 3> Normal;
    std::array<double, 3> Origin;
    /** Two directions in the plane; with the normal they are a right-handed frame. */
    std::array<double, 3> Axes[2];
    /** The boundary triangle whose plane it is; -1 for the enclosure's. */
    int Triangle;
  };

  /** Positive on the side to which the normal points. */
  double Distance(int plane, int point) const;
  /** -1, 0 or 1: points within the tolerance are in the plane. */
  int SideOf(int plane, int point) const;
  /** Of a triangle, twice its area long. */
  std::array<double, 3> GetNormal(const int points[3]) const;
  PlanarRegion::Point Project(int plane, int point) const;
  /** The corners of the convex hull of points in a plane, counter-clockwise about its normal; fewer
   *  than three where they are in line. */
  std::vector<int> FindHull(int plane, const std::vector<int>& points) const;
  /** The point of a plane that projects to `at`: one of `near` within the tolerance, else new. */
  int FindPoint(int plane, const PlanarRegion::Point& at, const std::vector<int>& near);

  int AddPoint(const std::array<double, 3>& x);
  /** Where the edge between two points meets a plane; distances at both ends are known. */
  int AddIntersection(int from, int to, double distanceFrom, double distanceTo);
  /** Through the first point; the normal need not be of length 1. -1 where it has none. */
  int AddPlane(const std::array<double, 3>& normal, int point, int triangle);

  const double* At(int point) const { return &this->Points[3 * static_cast<std::size_t>(point)]; }
  int GetNumberOfPoints() const { return static_cast<int>(this->Points.size() / 3); }
  /** In the coordinates of the mesh. */
  std::array<double, 3> GetMeshCoordinates(int point) const;

  const CellComplex& Mesh;
  std::vector<double> Points;
  std::vector<Plane> Planes;
  /** The plane of each boundary triangle; it has the normal out of the mesh. -1 where it has no
   *  area. */
  std::vector<int> PlaneOfTriangle;
  /** Points that are closer to a plane than this lie in it: 1e-12 of the diagonal. */
  double Tolerance = 0.0;

private:
  void FindPlanes();
  void GrowPlane(int seed, const std::unordered_map<long long, int>& triangleOfEdge);

  std::array<double, 3> Center{ { 0.0, 0.0, 0.0 } };
};

#endif
