/**
 * The triangles of cells' faces, each with the side of its plane on which its cell lies.
 */
#ifndef CellFaces_h
#define CellFaces_h

#include "FaceTriangles.h"

#include <cstddef>
#include <vector>

/** A triangle of a face. */
struct FaceTriangle
{
  /** Ascending. */
  int Points[3];
  int Cell;
  /** 1 where the cell lies on the side to which (p1 - p0) x (p2 - p0) points, -1 on the other, 0
   *  where the cell is flat. */
  signed char Side;
  /** One of several triangles of its face. */
  bool IsPart;
  /** 1 where the cell's own list of the face runs as Points do, -1 where it runs the other way. */
  signed char Turn;
};

class CellFaces
{
public:
  /** `points`: three per point. */
  explicit CellFaces(const double* points)
    : Points(points)
  {
  }

  /** Four corners in any order. */
  void AddTetrahedron(int cell, const int corners[4]);
  /** A face of a convex cell whose corners are `cellPoints`, as FaceTriangles cuts it. Ids that repeat
   *  are taken once. */
  void AddFace(int cell, std::vector<int> face, const std::vector<int>& cellPoints);

  /** To be called after the faces of a cell, with the number of triangles before it. Where faces
   *  are so warped that the cell is not convex, corners mislead about the sides; then they are
   *  taken from the way in which the cell lists its faces, if it lists all of them alike. */
  void SettleSides(std::size_t first);

  std::vector<FaceTriangle> Triangles;

private:
  void AddTriangle(int cell, const int corners[3], int side, bool isPart, int turn);
  std::vector<FaceTriangles::Triangle> CutFace(const std::vector<int>& face) const;
  bool IsWoundAlike(std::size_t first) const;
  int FindSide(
    const int corners[3], const std::vector<int>& face, const std::vector<int>& cellPoints) const;
  const double* At(int point) const { return this->Points + 3 * static_cast<long long>(point); }

  const double* Points;
};

#endif
