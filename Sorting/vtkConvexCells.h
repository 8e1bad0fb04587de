/**
 * @class   vtkConvexCells
 * @brief   any cells to convex cells or to conforming tetrahedra
 *
 * Takes every three-dimensional cell of any unstructured grid, in any numbering and winding:
 * tetrahedra, voxels, hexahedra, wedges, pyramids, pentagonal and hexagonal prisms, convex point
 * sets, polyhedra, and the quadratic, Lagrange and Bezier cells. It gives cells that the rest of
 * this module can rely on: coincident points are one point, every cell has a volume and faces
 * outward by VTK's convention.
 *
 * - Default: cells that are convex go out as they are, voxels as hexahedra; those that are not, and
 *   those that repeat a point, as their tetrahedra.
 * - TetrahedraOnly: every cell is split from its smallest point id (Dompierre et al., How to
 *   Subdivide Pyramids, Prisms and Hexahedra into Tetrahedra, 1999), so that neighbours agree on
 *   every face, faces with nodes in the middle of straight edges included: 5 or 6 tetrahedra per hexahedron, 3 per wedge, 2 per pyramid, 9 per pentagonal and
 *   12 per hexagonal prism. A lattice in its natural numbering gives 6.
 *   det(p1 - p0, p2 - p0, p3 - p0) > 0 for each.
 *
 * A face is a fan of triangles from its smallest point id, in both; where that is on a straight edge
 * with more than its two ends (within 1e-4 radians), tetrahedra take the smallest id that is not, or
 * cut the face in two. A cell is convex where for each
 * of its faces the normals of these triangles are within 60 degrees of each other, every corner off
 * the face lies inside the plane of each triangle within 1e-9 of the cell's size, and a face of
 * five or more corners is planar within 1e-5 of its size: hexahedra with slightly warped faces stay
 * whole. A polyhedron with two faces in one plane (within 1e-4 radians), as beside a refined cell of
 * an octree, is cut like one that is not convex: rays that enter cannot tell such faces apart.
 * Tetrahedra, and voxels that are boxes along the axes, are not tested.
 *
 * A cell whose tetrahedra from the smallest id have both signs, or not all a volume, is split from
 * another of its corners where one sees the whole surface, or else from a point within that does
 * (the centre of the largest ball between the planes of its faces' triangles; its data by mean value
 * coordinates); the triangles of its faces stay as they are. If there is none, a corner will do that
 * looks along faces within 1e-6 of the cell's size: what is so flat, 1e-6 of the cell at most, is
 * dropped, and GetReport() says so. If there is none either, the cell is counted as folded and its
 * tetrahedra, all turned positive, overlap or leave the triangles of its faces; a polyhedron is left
 * out as concave instead. A face that is not convex must be seen whole from its smallest id, too.
 *
 * Curved cells, which are the quadratic, Lagrange (of degree 10 at most) and Bezier ones: the
 * linear twin, of the same corners, is split as above; then edges of the tetrahedra that are off
 * by more than Tolerance are halved at points of the curved cell, by VTK's shape functions, and
 * tetrahedra at their halved edges, until none is off. Off means: from the curve or surface by more
 * than Tolerance times the diagonal of the mesh, or in the data by more than Tolerance times their
 * range. The data are the array to process (SetInputArrayToProcess; the active point scalars unless
 * one is named), or all point arrays of floating-point numbers where there is no such array. An edge
 * is halved for all of its cells alike, straight ones too, so that there are no cracks, and where a
 * polyhedron has a node in its middle. Where nothing is off a curved cell goes out as its linear twin. Global ids of points are dropped where
 * points are added.
 *
 * A convex point set is the polyhedron of its convex hull; triangles in one plane make one face.
 *
 * Polyhedra: each face may be wound either way; points that a face repeats in a row are taken once.
 * Left out are those of which a list of faces has a wrong length, names a point that does not exist
 * or a face of fewer than three points; whose surface is open (an edge that does not belong to
 * exactly two faces, or a surface of one side); which are in several pieces; or concave as above.
 *
 * Points at exactly the same coordinates are merged to the one of smallest id, whose data they
 * take; points that are not finite or hidden are removed, the others keep their order and
 * precision. Where no point is merged, removed or added, points and point data are shared with the input.
 * A tetrahedron whose volume cannot be told from 0 in double precision is dropped and counted.
 *
 * Input: vtkUnstructuredGridBase. Output: vtkUnstructuredGrid, in the order of the input's cells,
 * with all point, cell and field data, and the cell array `SourceCell` (vtkIdTypeArray): the id of
 * the input's cell. (An input array of that name is replaced. Global ids of cells are carried, but
 * no longer marked as such once cells are split.)
 *
 * Left out and counted, without a warning: cells of dimension 0 to 2, unknown types, ghost and
 * blanked cells (vtkGhostType DUPLICATECELL or HIDDENCELL, or a HIDDENPOINT), cells that touch a
 * point that is not finite, cells whose point list does not fit their type or names a point that
 * does not exist. GetLeftOutSummary() says it in one line, GetReport() in a table. Nothing in the
 * input is an error: empty gives empty. An aborted update leaves the output empty.
 *
 * Cells whose cell array `Imaginary` (unsigned char) is 1 fill gaps for a sort and have nothing to
 * draw: they and that array are left out, and counted apart.
 *
 * Where only data change and points and cells do not, the output keeps its points and cells: their
 * GetMTime() says whether the geometry is new. (With curved cells the data that are followed count
 * as geometry.)
 *
 * Not guaranteed: that surfaces which cut through themselves are found. Coincident points with
 * different data are not told apart: the smallest id wins. Faces match where nothing was dropped
 * but what repeats a point, no face runs back on itself, no cell is folded, and polyhedra have of a
 * curved cell's nodes only corners and those in the middle of edges. In the default mode a cell of the output may meet tetrahedra
 * across a face: they are its face's triangles, but where nodes hang on the face's edges.
 */

#ifndef vtkConvexCells_h
#define vtkConvexCells_h

#include "vtkCellProjectionModule.h" // for export macro
#include "vtkNew.h" // for the report
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string
#include <vector> // for std::vector

class ConvexCellConversion;
struct ConvexCellCounts;
class vtkDataArray;
class vtkTable;
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

  ///@{
  /**
   * Where points alone have moved, give them the cells of the last update, as they were cut up,
   * turned and left out then: cells may have turned inside out. Only where no point was merged or
   * removed. Default: off, and all is found anew.
   */
  vtkSetMacro(KeepCells, bool);
  vtkGetMacro(KeepCells, bool);
  vtkBooleanMacro(KeepCells, bool);
  ///@}

  ///@{
  /**
   * How far curved cells may be off, as a share of the mesh's diagonal and of the data's range.
   * Halving ends at 1/256 of a cell, or where it is in 20,000 pieces. Default: 0.001.
   */
  vtkSetClampMacro(Tolerance, double, 1e-7, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  // === What the last update did ===

  /**
   * What became of the cells: one row for each type of cell and reason, with the columns `type`
   * (VTK's class), `in` (cells), `out` (cells that they became), `dropped` (cells that became none)
   * and `why` (empty where they went out as they were).
   */
  vtkTable* GetReport() { return this->Report; }

  /**
   * Curved cells that are still off by more than Tolerance.
   */
  vtkGetMacro(NumberOfCoarseCells, vtkIdType);

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
   * Cells of negative volume in the input, and polyhedra with a face that was wound inward; turned
   * in the output.
   */
  vtkGetMacro(NumberOfInvertedCells, vtkIdType);

  /**
   * Cells that were split into tetrahedra of both signs: no point sees all of them.
   */
  vtkGetMacro(NumberOfFoldedCells, vtkIdType);

  /**
   * Cells that were split because they are not convex; 0 with TetrahedraOnly, where none is tested.
   */
  vtkGetMacro(NumberOfNonConvexCells, vtkIdType);

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
   * Cells of types that are unknown.
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
   * Polyhedra that no point sees all of.
   */
  vtkGetMacro(NumberOfConcaveCells, vtkIdType);

  /**
   * Cells with a wrong number of points, or with a point that does not exist; polyhedra with a list
   * of faces that does not fit, with an open surface, or in several pieces.
   */
  vtkGetMacro(NumberOfInvalidCells, vtkIdType);

  /**
   * One line that names what was left out, by kind and number, such as
   * "cells left out: 1 vtkTriangle (2-D), 3 vtkPolyhedron (open surface), 2 ghost or hidden"; else
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
  bool Convert(ConvexCellConversion& conversion, vtkUnstructuredGridBase* input);
  std::vector<vtkDataArray*> FindFollowedArrays(vtkUnstructuredGridBase* input);
  std::vector<vtkMTimeType> FindSources(vtkUnstructuredGridBase* input, bool curved);

  bool HasKeptCells(vtkUnstructuredGridBase* input, const std::vector<vtkMTimeType>& sources) const;

  bool TetrahedraOnly = false;
  bool KeepCells = false;
  double Tolerance = 1e-3;

  vtkIdType NumberOfMergedPoints = 0;
  vtkIdType NumberOfDegenerateCells = 0;
  vtkIdType NumberOfDroppedTetrahedra = 0;
  vtkIdType NumberOfInvertedCells = 0;
  vtkIdType NumberOfFoldedCells = 0;
  vtkIdType NumberOfNonConvexCells = 0;
  vtkIdType NumberOfSkippedCells = 0;
  vtkIdType NumberOfZeroVolumeCells = 0;
  vtkIdType NumberOfLowerDimensionalCells = 0;
  vtkIdType NumberOfUnsupportedCells = 0;
  vtkIdType NumberOfGhostCells = 0;
  vtkIdType NumberOfNonFiniteCells = 0;
  vtkIdType NumberOfImaginaryCells = 0;
  vtkIdType NumberOfConcaveCells = 0;
  vtkIdType NumberOfInvalidCells = 0;
  vtkIdType NumberOfCoarseCells = 0;
  std::string LeftOutSummary;
  vtkNew<vtkTable> Report;

  // The last conversion, and what its geometry was made from.
  std::unique_ptr<ConvexCellConversion> Last;
  std::vector<vtkMTimeType> LastSources;
};

#endif
