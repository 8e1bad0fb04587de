/**
 * The surface about a mesh, hull or box, and what it leaves to be filled.
 *
 * Paper: Roettger et al. 2004, section 6.1, steps 1 to 4: the mesh's boundary turned inside out and
 * the enclosure's faces; what appears in both is removed, by area and not by triangle, for a hull
 * is seldom triangulated as the mesh that touches it.
 */
#ifndef Enclosure_h
#define Enclosure_h

#include "ExteriorPart.h"
#include "PlanarRegion.h"

#include <unordered_map>
#include <vector>

class ExteriorGeometry;

class Enclosure
{
public:
  explicit Enclosure(ExteriorGeometry& geometry);

  void TakeConvexHull();
  void TakeBox();

  /** The exterior volume: no faces where the mesh fills the enclosure. */
  ExteriorPart FindExterior();
  /** Of the whole, the mesh included. */
  double GetVolume() const;
  /** Whether a part lies outside of one of its planes. */
  bool IsOutside(const ExteriorPart& part) const;
  bool IsFlat() const { return this->Facets.empty(); }

private:
  void AddFacet(int plane, const std::vector<int>& points);
  void IndexBoundary();
  std::vector<int> FindCovered(const ExteriorFace& facet);
  std::vector<ExteriorFace> Uncover(const ExteriorFace& facet, const std::vector<int>& covered);

  ExteriorGeometry& Geometry;
  std::vector<ExteriorFace> Facets;
  /** Points of the boundary by their first coordinate, and the triangles at each. */
  std::vector<int> BoundaryPoints;
  std::unordered_map<int, std::vector<int>> TrianglesOfPoint;
};

#endif
