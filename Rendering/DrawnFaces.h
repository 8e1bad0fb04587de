#ifndef DrawnFaces_h
#define DrawnFaces_h

#include <vector>

class ConvexCellFaces;
class ConvexCellSelection;
class FacePieces;
class ScalarField;

/**
 * @class DrawnFaces
 * @brief The faces of drawn cells, each once, as pieces.
 */
class DrawnFaces
{
public:
  void Build(
    const ConvexCellFaces& cells, const FacePieces& pieces, const ConvexCellSelection& selection);

  /// Scalars of cells on their faces: four per piece, the greatest, or least, of its drawn cells.
  static std::vector<float> CellScalars(const ConvexCellFaces& cells, const FacePieces& pieces,
    const ConvexCellSelection& selection, const ScalarField& scalars, bool findLeast);

  std::vector<unsigned int> Pieces;
};

#endif
