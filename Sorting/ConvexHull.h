/**
 * The convex hull of points in space as triangles.
 *
 * Method: Barber, Dobkin, Huhdanpaa, The Quickhull Algorithm for Convex Hulls, 1996, with exact
 * signs: coplanar points need no tolerance. Points on a face of the hull that are not its corners
 * may or may not be corners of triangles.
 */
#ifndef ConvexHull_h
#define ConvexHull_h

#include <array>
#include <vector>

class ConvexHull
{
public:
  using Triangle = std::array<int, 3>;

  /** `points`: three per point; `ids`: those that count. Triangles turn counter-clockwise seen from
   *  outside; none where all points lie in one plane. */
  static std::vector<Triangle> Build(const double* points, const std::vector<int>& ids);

private:
  struct Facet
  {
    Triangle Corners;
    /** Across the edge from corner i to corner i + 1. */
    std::array<int, 3> Neighbors{ { -1, -1, -1 } };
    /** Points that see this facet; each point is kept by one. */
    std::vector<int> Outside;
    bool Alive = true;
    int VisitedFor = -1;
  };
  /** A facet that stays and its edge towards those that go. */
  struct HorizonEdge
  {
    int Facet;
    int Edge;
  };

  explicit ConvexHull(const double* points)
    : Points(points)
  {
  }
  bool Start(const std::vector<int>& ids);
  void Grow();
  int TakeFarthest(Facet& facet);
  void FindVisible(int facet, int apex, std::vector<int>& visible, std::vector<HorizonEdge>& edges);
  void ReplaceVisible(
    int apex, const std::vector<int>& visible, const std::vector<HorizonEdge>& edges);
  void Link(const std::vector<int>& fan);
  void Keep(int point, const std::vector<int>& facets);
  bool Sees(int point, const Triangle& triangle) const;
  double Height(int point, const Triangle& triangle) const;
  const double* At(int point) const { return this->Points + 3 * point; }

  const double* Points;
  std::vector<Facet> Facets;
};

#endif
