/**
 * The boundary triangles about a point, and whether they may follow it onto a neighbour.
 *
 * They may where the boundary stays one surface (the link condition: Dey, Edelsbrunner, Guha,
 * Nekhayev, Topology Preserving Edge Contraction, 1999), no triangle turns by more than 60 degrees,
 * and every corner and middle of the original's boundary triangles is within a bound of it: each
 * middle, and each corner that is gone, is kept by the triangle that it is nearest to.
 */
#ifndef BoundaryPatch_h
#define BoundaryPatch_h

#include "CollapsibleMesh.h"
#include "FieldSamples.h"

#include <utility>
#include <vector>

class BoundaryPatch
{
public:
  /** `bound`: of the distance. */
  BoundaryPatch(CollapsibleMesh& mesh, double bound);

  /** Takes the triangles about a point of the boundary; false where they are no disk. */
  bool Take(int point, const std::vector<int>& star);

  /** Whether they may follow the point; to be asked before any tetrahedron is looked at. */
  bool MayFollow(int to);
  /** The same for the shape that they would have; MayFollow has said yes. */
  bool StaysNear(int to);
  /** The tetrahedron, as it would be, of the triangle nearest to a place; its corners, and their
   *  weights at its nearest place. After StaysNear has said yes. */
  int FindNearest(const double x[3], int corners[4], double weights[4]) const;

  /** After StaysNear has said yes, either: keeps what it found out, or forgets it. */
  void Follow();
  void Forget();

  /** Open faces that have new tetrahedra, as CollapsibleMesh::Collapse gives them; before Follow.
   */
  void Move(const std::vector<std::pair<int, int>>& faces);

  /** The largest distance of corners and middles now. */
  double FindLargestDistance() const;

private:
  /** (Point, A, B) turns counter-clockwise seen from outside. */
  struct Triangle
  {
    int Face;
    int A;
    int B;
  };

  bool IsDisk() const;
  bool FindWings(int to, int wings[2]) const;
  bool KeepsEdges(int to, const int wings[2]);
  bool KeepsLink(int to);
  bool KeepsPairs(int to) const;
  bool AddFollower(const Triangle& triangle, int to);
  bool Place(int sample);

  CollapsibleMesh& Mesh;
  const double Bound;
  FieldSamples Samples; // by open face
  int Point = -1;
  int To = -1;
  std::vector<int> Star;
  std::vector<int> OtherStar;
  std::vector<Triangle> Triangles;
  std::vector<Triangle> Followers; // about `to`; Face is that of the tetrahedron they will have
  std::vector<std::pair<int, int>> Places; // sample, follower
  std::vector<int> Marks;                  // by point
  int Mark = 0;
};

#endif
