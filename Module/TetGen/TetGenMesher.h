/**
 * Plain arrays to TetGen and back.
 *
 * Program: Hang Si, TetGen, a Delaunay-Based Quality Tetrahedral Mesh Generator, ACM Transactions
 * on Mathematical Software 41(2), 2015. What TetGen throws becomes a reason in words.
 */
#ifndef TetGenMesher_h
#define TetGenMesher_h

#include <array>
#include <string>
#include <vector>

struct TetGenSurface
{
  /** Three per point. */
  std::vector<double> Points;
  /** Corners in Points; points that none names are left alone. */
  std::vector<std::array<int, 3>> Triangles;
};

struct TetGenSettings
{
  /** Keep what lies between the surface and its convex hull. */
  bool FillsHull = false;
  /** Make new points inside for better tetrahedra: radius of the circumsphere by the shortest edge;
   *  0 for no bound. */
  double MaximumRadiusEdgeRatio = 0.0;
  /** 0 for no bound. */
  double MaximumVolume = 0.0;
};

struct TetGenMesh
{
  /** Those of the surface first and unmoved, then the new ones. */
  std::vector<double> Points;
  /** Positive: det(p1 - p0, p2 - p0, p3 - p0) > 0. */
  std::vector<std::array<int, 4>> Tetrahedra;
  /** Why there are none; empty where all is well. */
  std::string Failure;
  /** The failure is a surface that runs through itself. */
  bool IsSelfIntersecting = false;
};

namespace TetGenMesher
{
/** Tetrahedra of what the surface encloses, cavities included. Every triangle stays as it is. */
TetGenMesh Fill(const TetGenSurface& surface, const TetGenSettings& settings);

/** Delaunay tetrahedra of points; those at the same place are used once. */
TetGenMesh Triangulate(const std::vector<double>& points);
}

#endif
