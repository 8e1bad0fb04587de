/**
 * Makes cells of convex parts of an exterior volume, and finds where they touch.
 */
#ifndef ImaginaryCellAssembly_h
#define ImaginaryCellAssembly_h

#include "Convexification.h"
#include "ExteriorPart.h"
#include "PlanarRegion.h"

#include <unordered_map>
#include <vector>

class ExteriorGeometry;

class ImaginaryCellAssembly
{
public:
  explicit ImaginaryCellAssembly(const ExteriorGeometry& geometry);

  /** A new cut by a plane; returns the number that its faces carry. */
  int AddCut(int plane);
  /** A convex part as the next cell; one that is thinner than the tolerance in two directions is
   *  left out, for no ray meets it. */
  void AddCell(const ExteriorPart& part);
  /** All cells, with the contacts between them. */
  ImaginaryCells Finish();

private:
  /** A face of one cell in the plane of a cut. */
  struct Piece
  {
    int Cell;
    PlanarRegion::Polygon Outline;
  };
  struct Cut
  {
    int Plane;
    std::vector<Piece> Below;
    std::vector<Piece> Above;
  };
  /** All that one cell has in one plane. */
  struct Facet
  {
    int Plane;
    int Direction;
    std::vector<int> Points;
  };

  static std::vector<Facet> FindFacets(const ExteriorGeometry& geometry, const ExteriorPart& part);
  bool AddFace(const Facet& facet);
  int TakePoint(int point);
  void AddPieces(const ExteriorPart& part, int cell);
  void AddMeshContacts(const ExteriorPart& part, int cell);
  void AddContact(int triangle, int above, int below);
  void FindContacts(const Cut& cut);

  const ExteriorGeometry& Geometry;
  ImaginaryCells Cells;
  std::vector<Cut> Cuts;
  std::unordered_map<int, int> NewIds;
};

#endif
