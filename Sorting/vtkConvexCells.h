/**
 * @class   vtkConvexCells
 * @brief   any cells to convex cells or to conforming tetrahedra
 *
 * Takes tetrahedra, voxels, hexahedra, wedges and pyramids of any unstructured grid, in any
 * numbering and winding, and gives cells that the rest of this module can rely on: coincident
 * points are one point, every cell has a volume and faces outward by VTK's convention.
 *
 * - Default: cells go out as they are; voxels as hexahedra; a cell that repeats a point, as the
 *   tetrahedra that are left of it.
 * - TetrahedraOnly: every cell is split from its smallest point id (Dompierre et al., How to
 *   Subdivide Pyramids, Prisms and Hexahedra into Tetrahedra, 1999), so that neighbours agree on
 *   every face: 5 or 6 tetrahedra per hexahedron, 3 per wedge, 2 per pyramid. A lattice in its
 *   natural numbering gives 6. det(p1 - p0, p2 - p0, p3 - p0) > 0 for each.
 *
 * Points at exactly the same coordinates are merged to the one of smallest id, whose data they
 * take; points that are not finite or hidden are removed, the others keep their order and
 * precision. Where no point is merged or removed, points and point data are shared with the input.
 * A tetrahedron whose volume cannot be told from 0 in double precision is dropped and counted.
 *
 * Input: vtkUnstructuredGridBase. Output: vtkUnstructuredGrid, in the order of the input's cells,
 * with all point, cell and field data, and the cell array `SourceCell` (vtkIdTypeArray): the id of
 * the input's cell. (An input array of that name is replaced. Global ids of cells are carried, but
 * no longer marked as such once cells are split.)
 *
 * Left out and counted, without a warning: cells of dimension 0 to 2, types not listed above, ghost
 * cells (vtkGhostType DUPLICATECELL or HIDDENCELL, or a HIDDENPOINT), cells that touch a point that
 * is not finite, cells whose point list does not fit their type or names a point that does not
 * exist. GetLeftOutSummary() says it in one line. Nothing in the input is an error: empty gives
 * empty. An aborted update leaves the output empty.
 *
 * Cells whose cell array `Imaginary` (unsigned char) is 1 fill gaps for a sort and have nothing to
 * draw: they and that array are left out, and counted apart.
 *
 * Where only data change and points and cells do not, the output keeps its points and cells: their
 * GetMTime() says whether the geometry is new.
 *
 * Not guaranteed: warped faces and hexahedra that are not convex are not detected, save that cells
 * whose tetrahedra have both signs are counted as folded (their tetrahedra, all turned positive,
 * overlap). Coincident points with different data are not told apart: the smallest id wins. A flat
 * tetrahedron that is dropped can leave two cells facing each other with different diagonals.
 */

#ifndef vtkConvexCells_h
#define vtkConvexCells_h

#include "vtkCellProjectionModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string
#include <vector> // for std::vector

class ConvexCellConversion;
struct ConvexCellCounts;
class vtkUnstructuredGridBase;

class VTKCELLPROJECTION_EXPORT vtkConvexCells : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkConvexCells* New();
  vtkTypeMacro(vtkConvexCells, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Split every cell into tetrahedra. Default: off.
   */
  vtkSetMacro(TetrahedraOnly, bool);
  vtkGetMacro(TetrahedraOnly, bool);
  vtkBooleanMacro(TetrahedraOnly, bool);
  ///@}

  // === What the last update did ===

  /**
   * Points that gave way to another point at the same coordinates.
   */
  vtkGetMacro(NumberOfMergedPoints, vtkIdType);

  /**
   * Input cells from which a tetrahedron was dropped for its zero volume.
   */
  vtkGetMacro(NumberOfDegenerateCells, vtkIdType);

  /**
   * Tetrahedra that were dropped for their zero volume.
   */
  vtkGetMacro(NumberOfDroppedTetrahedra, vtkIdType);

  /**
   * Cells of negative volume in the input, turned in the output.
   */
  vtkGetMacro(NumberOfInvertedCells, vtkIdType);

  /**
   * Cells whose tetrahedra have both signs.
   */
  vtkGetMacro(NumberOfFoldedCells, vtkIdType);

  // === What it left out ===

  /**
   * Cells that put nothing into the output: those below and the cells of zero volume.
   */
  vtkGetMacro(NumberOfSkippedCells, vtkIdType);

  /**
   * Cells of zero volume, of the types that are taken.
   */
  vtkGetMacro(NumberOfZeroVolumeCells, vtkIdType);

  /**
   * Cells of dimension 0, 1 and 2, and empty cells.
   */
  vtkGetMacro(NumberOfLowerDimensionalCells, vtkIdType);

  /**
   * Three-dimensional cells of types that are not taken, and unknown types.
   */
  vtkGetMacro(NumberOfUnsupportedCells, vtkIdType);

  /**
   * Duplicate and hidden cells, and cells with a hidden point.
   */
  vtkGetMacro(NumberOfGhostCells, vtkIdType);

  /**
   * Cells that touch a point with an infinite or NaN coordinate.
   */
  vtkGetMacro(NumberOfNonFiniteCells, vtkIdType);

  /**
   * Cells marked as imaginary; not among the skipped ones.
   */
  vtkGetMacro(NumberOfImaginaryCells, vtkIdType);

  /**
   * Cells with a wrong number of points, or with a point that does not exist.
   */
  vtkGetMacro(NumberOfInvalidCells, vtkIdType);

  /**
   * One line that names what was left out, by kind and number, such as
   * "cells left out: 1 vtkTriangle (2-D), 3 vtkPolyhedron (not supported), 2 ghost or hidden"; else
   * empty.
   */
  std::string GetLeftOutSummary() const { return this->LeftOutSummary; }

protected:
  vtkConvexCells();
  ~vtkConvexCells() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkConvexCells(const vtkConvexCells&) = delete;
  void operator=(const vtkConvexCells&) = delete;

  void TakeCounts(const ConvexCellCounts& counts);
  bool Convert(ConvexCellConversion& conversion);
  std::vector<vtkMTimeType> FindSources(vtkUnstructuredGridBase* input) const;

  bool TetrahedraOnly = false;

  vtkIdType NumberOfMergedPoints = 0;
  vtkIdType NumberOfDegenerateCells = 0;
  vtkIdType NumberOfDroppedTetrahedra = 0;
  vtkIdType NumberOfInvertedCells = 0;
  vtkIdType NumberOfFoldedCells = 0;
  vtkIdType NumberOfSkippedCells = 0;
  vtkIdType NumberOfZeroVolumeCells = 0;
  vtkIdType NumberOfLowerDimensionalCells = 0;
  vtkIdType NumberOfUnsupportedCells = 0;
  vtkIdType NumberOfGhostCells = 0;
  vtkIdType NumberOfNonFiniteCells = 0;
  vtkIdType NumberOfImaginaryCells = 0;
  vtkIdType NumberOfInvalidCells = 0;
  std::string LeftOutSummary;

  // The last conversion, and what its geometry was made from.
  std::unique_ptr<ConvexCellConversion> Last;
  std::vector<vtkMTimeType> LastSources;
};

#endif
