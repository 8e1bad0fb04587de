/**
 * A BSP tree of the boundary triangles of a mesh: their order for any eye.
 *
 * Paper: Comba, Klosowski, Max, Mitchell, Silva, Williams, Fast Polyhedral Cell Sorting for
 * Interactive Rendering of Unstructured Grids, 1999. Auto-partition: every plane is that of a
 * triangle, the one of a few candidates that cuts the fewest others. Triangles that lie within
 * 1e-12 of the mesh's diagonal of a plane are taken to lie in it.
 */
#ifndef BoundaryBSP_h
#define BoundaryBSP_h

#include "CellComplex.h"

#include <array>
#include <random>
#include <vector>

class BoundaryBSP
{
public:
  using Point = std::array<double, 3>;

  /** A convex part of a boundary triangle. */
  struct Fragment
  {
    /** Which of the complex's. */
    int Triangle;
    /** Where its corners are in the points of the tree. */
    int Begin, End;
    /** Whether the triangle's normal is that of its node's plane. */
    bool Agrees;
  };
  /** A fragment as an eye sees it: 1 where it sees the outside of the boundary, -1 where the
   *  inside, 0 edge-on (within 1e-12 of the distance: no ray passes through it). */
  struct Visit
  {
    int Fragment;
    int Side;
  };

  /** The complex must stay as it is while the tree is used. */
  void Build(const CellComplex& complex, int candidates = 5);

  /** Every fragment once, farthest first. `eye`: as for ExactOrientation::SideOfEye. */
  void Traverse(const double eye[4], std::vector<Visit>& visits) const;

  const std::vector<Fragment>& GetFragments() const { return this->Fragments; }
  const Point* GetCorners(const Fragment& fragment) const
  {
    return this->Corners.data() + fragment.Begin;
  }

private:
  struct Plane
  {
    Point Normal;
    double Offset;
  };
  struct Node
  {
    /** The triangle in whose plane it lies, and what of Fragments is its own. */
    int Triangle;
    int Begin, End;
    /** Nodes, or -1. */
    int Front = -1, Back = -1;
  };
  /** Fragments that still want a node, and whose child that will be. */
  struct Task
  {
    std::vector<Fragment> Fragments;
    int Parent;
    bool Front;
  };

  void TakeBoundary(std::vector<Fragment>& fragments);
  Plane PlaneOf(int triangle) const;
  double DistanceOf(const Plane& plane, const Point& p) const;
  /** 1 in front, -1 behind, 0 within, 2 cut. */
  int Classify(const Plane& plane, const Fragment& fragment) const;
  int ChooseTriangle(const std::vector<Fragment>& fragments, int candidates);
  void Divide(const Task& task, int candidates, std::vector<Task>& open);
  void Cut(const Plane& plane, const Fragment& fragment, Fragment& front, Fragment& back);
  bool IsEdgeOn(int triangle, const double eye[4]) const;
  const double* PointOf(int triangle, int corner) const;

  const CellComplex* Complex = nullptr;
  double Tolerance = 0.0;
  std::mt19937 Random;
  std::vector<Point> Corners;
  std::vector<Fragment> Fragments;
  std::vector<Node> Nodes;
};

#endif
