#ifndef ApproximatedCells_h
#define ApproximatedCells_h

#include "ApproximationTriangles.h"

#include <glm/vec4.hpp>

#include <vector>

class CellApproximation;
class ProjectedPoints;

/**
 * @class ApproximatedCells
 * @brief The triangles of all cells from back to front.
 */
class ApproximatedCells
{
public:
  struct Input
  {
    /// Cells from back to front.
    const std::vector<unsigned int>& Order;
    /// 4 ids per cell.
    const std::vector<int>& Corners;
    const ProjectedPoints& Points;
    /// Classified by the approximation, one per point or per cell.
    const std::vector<glm::vec4>& Values;
    bool OnePerCell;
  };

  static ApproximationTriangles Build(const Input& input, const CellApproximation& approximation);
};

#endif
