#ifndef CellPlanes_h
#define CellPlanes_h

#include "ConvexCellFaces.h"
#include "FacePieces.h"

#include <glm/vec4.hpp>

#include <array>
#include <vector>

/**
 * @class CellPlanes
 * @brief The planes between which a ray is inside a convex cell.
 *
 * Per cell a run of texels: its centre and radius, then its planes as inward normal and offset,
 * inside where normal . (x - centre) + offset > 0. Between single planes the cell is the
 * intersection. A warped face gives two planes: single ones where its diagonal is a ridge of the
 * cell, a pair at the end of the run where it is a valley: inside either of a pair is inside.
 *
 * The two cells of a face hold the same normals, negated. A cell that is flat once its points are
 * floats has no planes and is not drawn.
 */
class CellPlanes
{
public:
  void Build(
    const std::vector<float>& points, const ConvexCellFaces& cells, const FacePieces& pieces);

  /// Per cell: first texel, planes + 65536 times pairs, first corner, number of corners.
  std::vector<std::array<int, 4>> Headers;
  std::vector<glm::vec4> Texels;
  std::vector<int> Pieces; ///< Per texel: the first piece of the plane's face.
  int NumberOfFlatCells = 0;

private:
  struct Side;
  int CountPlanes(int cell, const ConvexCellFaces& cells, const FacePieces& pieces) const;
  bool SetUpCell(int cell, const std::vector<float>& points, const ConvexCellFaces& cells,
    const FacePieces& pieces);
};

#endif
