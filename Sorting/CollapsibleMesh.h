/**
 * Tetrahedra whose edges can be collapsed onto one of their ends.
 *
 * Notation: a corner is 4 t + i, place i of tetrahedron t; a face goes by the corner across from
 * it. The star of a point is the list of its own corners. An open face is one of the boundary.
 * Tetrahedra keep their numbers, and their places; a collapse replaces one point by another in some
 * and lets the others go. Linear in the size of the stars.
 */
#ifndef CollapsibleMesh_h
#define CollapsibleMesh_h

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

class CollapsibleMesh
{
public:
  using Tetrahedron = std::array<int, 4>;

  /** Corners of the face across from corner i, counter-clockwise seen from outside. */
  static constexpr int FaceOf[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };

  /** `points`: three per point; tetrahedra are positive, a face has at most two of them. */
  CollapsibleMesh(std::vector<double> points, std::vector<Tetrahedron> tetrahedra);

  const double* GetPoint(int point) const
  {
    return &this->Points[3 * static_cast<std::size_t>(point)];
  }
  const Tetrahedron& Get(int tetrahedron) const { return this->Tetrahedra[tetrahedron]; }
  int GetNumberOfPoints() const { return static_cast<int>(this->First.size()); }
  int GetNumberOfTetrahedra() const { return static_cast<int>(this->Tetrahedra.size()); }
  bool IsAlive(int tetrahedron) const { return this->Alive[tetrahedron] != 0; }
  bool IsOpen(int corner) const { return this->Open[corner] != 0; }
  bool IsOnBoundary(int point) const { return this->OnBoundary[point] != 0; }
  bool Contains(int tetrahedron, int point) const;
  /** The place of a point that the tetrahedron contains. */
  int PlaceOf(int tetrahedron, int point) const;

  void GetStar(int point, std::vector<int>& star);

  /** The same face as its other tetrahedron has it; -1 where it is open. */
  int FindAcross(int corner);

  /** `star`: of `from`. Pairs of open faces that moved from a tetrahedron that is gone to another
   *  one. Whether the mesh is still one is for the caller to know beforehand. */
  const std::vector<std::pair<int, int>>& Collapse(int from, int to, const std::vector<int>& star);

private:
  void LinkCorners();
  void FindOpenFaces();
  void MoveFace(int from, int to);

  std::vector<double> Points;
  std::vector<Tetrahedron> Tetrahedra;
  std::vector<int> First; // corner of a point's list, by point
  std::vector<int> Next;  // by corner
  std::vector<char> Alive;
  std::vector<char> Open; // by corner
  std::vector<char> OnBoundary;
  std::vector<std::pair<int, int>> Moved;
  std::vector<int> Scratch;
};

#endif
