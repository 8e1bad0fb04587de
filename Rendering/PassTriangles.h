#ifndef PassTriangles_h
#define PassTriangles_h

#include <array>
#include <vector>

class ConvexCellFaces;
class ConvexCellSelection;
class CellPlanes;
class FacePieces;

/**
 * @class PassTriangles
 * @brief The surfaces of cells as triangles, each cell three times in a row: once for every pass.
 *
 * A triangle is its piece, its cell, and pass + 4 half + 8 turned: half tells the piece's two
 * triangles apart, turned ones are listed clockwise as seen from outside. A negative piece -1 - i
 * is the explicit triangle i.
 */
class PassTriangles
{
public:
  using Triangle = std::array<int, 4>;

  /// What the passes are called in the code of a triangle.
  enum Pass
  {
    Length = 0,
    Emission = 1,
    Reset = 2
  };

  /// Flat cells have none.
  void Build(const ConvexCellFaces& cells, const FacePieces& pieces, const CellPlanes& planes,
    const ConvexCellSelection& selection);

  /// Which of the four corners of its piece a triangle's corner is.
  static int CornerOfPiece(const Triangle& triangle, int corner);

  /// Where a cell stands in Cells; -1 where it does not.
  int Find(int cell) const;

  /// Appends a cell of `count` explicit triangles.
  void AppendExplicit(int cell, int count);

  std::vector<Triangle> Triangles;
  std::vector<int> Cells;        ///< Ascending, in the order of the triangles.
  std::vector<int> Offsets{ 0 }; ///< Of each cell's first triangle; one more at the end.

private:
  void AppendPasses(int cell, const std::vector<Triangle>& once);

  int NumberOfExplicitTriangles = 0;
};

#endif
