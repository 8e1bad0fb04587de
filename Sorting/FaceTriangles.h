/**
 * The triangles that a cell's faces are cut into, none of them flat, and the same from both sides of
 * a face.
 *
 * A face is the fan from its vertex of smallest id from which no triangle is flat: two edges of a
 * flat one go straight on, as do those of a node that hangs on an edge. A face without such a vertex,
 * on whose edges several nodes hang, is cut in two first, from its smallest id along the diagonal
 * that leaves the smaller part largest, and so on. Nothing but the face's ids and coordinates
 * decides, in the order from the smallest id towards its smaller neighbour.
 *
 * Ids that a face repeats in a row are taken once; a face of fewer than three is none, and so is a
 * triangle of two, where a face touches itself in a point. Not
 * guaranteed: triangles that turn alike where a face is not convex.
 */
#ifndef FaceTriangles_h
#define FaceTriangles_h

#include "TetrahedralSplit.h"

#include <array>
#include <vector>

class FaceTriangles
{
public:
  using Triangle = std::array<int, 3>;

  /** Edges go straight on that turn by less, in radians. */
  static constexpr double Straight = 1e-4;

  /** `ids` and `points`, finite and safe for TetrahedralSplit::SixVolumes, by the solid's vertices. */
  FaceTriangles(
    const TetrahedralSplit::Solid& solid, const vtkIdType* ids, const double (*points)[3]);

  /** By vertices, counter-clockwise from outside. */
  const std::vector<Triangle>& Get() const { return this->Triangles; }

  /** Whether each face is the fan from its smallest id, as TetrahedralSplit takes it. */
  bool AreFans() const { return this->Fans; }

  /**
   * A vertex such that each triangle that does not touch it makes a tetrahedron of positive volume
   * with it, or of none where two of the triangle's edges go straight on (faces without an area, and
   * narrow ones): that of smallest id where it does, else the first; -1 where there is none. `sign`:
   * -1 where the cell is inside out. `flatness`: how far behind a triangle's plane the vertex may
   * lie, by the size of the cell.
   */
  int FindApex(double sign, double flatness = 0.0) const;

  /** visit(a, b, c) for each triangle that does not touch the apex. */
  template <typename Visit>
  void VisitCone(int apex, Visit visit) const
  {
    for (const Triangle& t : this->Triangles)
    {
      if (!this->Touches(t, apex))
      {
        visit(t[0], t[1], t[2]);
      }
    }
  }

private:
  using Loop = std::vector<int>;

  void AddFace(const int* begin, const int* end);
  void Cut(const Loop& loop);
  int FindStart(const Loop& loop) const;
  bool IsStart(const Loop& loop, std::size_t start) const;
  std::size_t FindHalf(const Loop& loop) const;
  bool IsFlat(int a, int b, int c) const;
  bool SeesAll(int apex, double sign, double flatness) const;
  double AreaOf(const Triangle& t) const;
  bool Touches(const Triangle& t, int vertex) const
  {
    const vtkIdType id = this->Ids[vertex];
    return this->Ids[t[0]] == id || this->Ids[t[1]] == id || this->Ids[t[2]] == id;
  }

  const int NumberOfVertices;
  const vtkIdType* Ids;
  const double (*Points)[3];
  std::vector<Triangle> Triangles;
  bool Fans = true;
};

#endif
