/**
 * @class   vtkTetGenTetrahedralizer
 * @brief   any cells to conforming tetrahedra by TetGen
 *
 * Program: Hang Si, TetGen, a Delaunay-Based Quality Tetrahedral Mesh Generator, ACM Transactions
 * on Mathematical Software 41(2), 2015. It is AGPL: see the README beside this file.
 *
 * Input: vtkUnstructuredGrid of the cells that vtkConvexCells takes, and polyhedra that no point
 * sees all of. Output, by Mode:
 * - CellByCell (the default): the tetrahedra of each cell, those of vtkConvexCells where it has
 *   any, else of TetGen. Faces stay, cut alike by both neighbours: concave ones by their ears. New
 *   points lie inside of concave polyhedra alone.
 * - Remesh: the boundary triangles of CellByCell stay, what is inside is meshed anew, better than
 *   MaximumRadiusEdgeRatio and MaximumVolume as far as the boundary allows. Cavities stay empty.
 * - Delaunay: the Delaunay tetrahedra of the points, up to their convex hull, whatever the cells
 *   are. vtkPowerVisibilitySort is exact on them where no five points lie on one sphere.
 * - FillHull: the input as it is, then imaginary tetrahedra that fill it up to its convex hull,
 *   with the arrays `Imaginary` and `ImaginaryContacts` of vtkConvexifyFilter, whose FillAlgorithm
 *   this can be. Any convex cells; data of what is new are 0.
 *
 * Points of the input come first, in their order and unmoved, coincident ones as one; Remesh and
 * Delaunay leave out those that no tetrahedron has. Point data are interpolated to new points in
 * the cell (a concave polyhedron: by mean value coordinates) that has them; where there are new
 * points, all are double. Cell data and the cell array `SourceCell` (vtkIdTypeArray) are those of
 * the input's cell that the tetrahedron is of, or that its middle lies in; -1, and data of 0, where
 * there is none. Tetrahedra are positive: det(p1 - p0, p2 - p0, p3 - p0) > 0.
 *
 * Errors, one per update, with TetGen's reason: cells that it cannot cut (they are left out, and
 * counted), a boundary or points that it cannot mesh. Warning: a boundary that intersects itself;
 * Remesh then gives what CellByCell gives, as it does after an error; FillHull adds nothing.
 * Nothing in the input is an error. TetGen cannot be aborted on its way.
 *
 * Not guaranteed: MaximumRadiusEdgeRatio and MaximumVolume near the boundary, whose triangles are
 * not cut; TetGen aims at both and stops short of them where a point would come too close.
 */

#ifndef vtkTetGenTetrahedralizer_h
#define vtkTetGenTetrahedralizer_h

#include "vtkCellProjectionTetGenModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // for messages

struct TetGenMesh;

class VTKCELLPROJECTIONTETGEN_EXPORT vtkTetGenTetrahedralizer : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkTetGenTetrahedralizer* New();
  vtkTypeMacro(vtkTetGenTetrahedralizer, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ModeType
  {
    CELL_BY_CELL = 0,
    REMESH = 1,
    DELAUNAY = 2,
    FILL_HULL = 3
  };

  ///@{
  /**
   * What is made of the input, see above. Default: CellByCell.
   */
  vtkSetClampMacro(Mode, int, CELL_BY_CELL, FILL_HULL);
  vtkGetMacro(Mode, int);
  void SetModeToCellByCell() { this->SetMode(CELL_BY_CELL); }
  void SetModeToRemesh() { this->SetMode(REMESH); }
  void SetModeToDelaunay() { this->SetMode(DELAUNAY); }
  void SetModeToFillHull() { this->SetMode(FILL_HULL); }
  ///@}

  ///@{
  /**
   * For Remesh: the circumsphere's radius by the shortest edge, at most; 0 for no bound. TetGen may
   * run for long below 1.2. Default: 2.
   */
  vtkSetClampMacro(MaximumRadiusEdgeRatio, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumRadiusEdgeRatio, double);
  ///@}

  ///@{
  /**
   * For Remesh: of a tetrahedron; 0 for no bound, the default.
   */
  vtkSetClampMacro(MaximumVolume, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumVolume, double);
  ///@}

  // === What the last update did ===

  /**
   * Polyhedra that TetGen cut, cell by cell.
   */
  vtkGetMacro(NumberOfCutCells, vtkIdType);

  /**
   * Polyhedra that TetGen could not cut.
   */
  vtkGetMacro(NumberOfFailedCells, vtkIdType);

  /**
   * Cells of the input without tetrahedra, CellByCell: those and what vtkConvexCells leaves out.
   */
  vtkGetMacro(NumberOfSkippedCells, vtkIdType);

  /**
   * Points that the input does not have.
   */
  vtkGetMacro(NumberOfNewPoints, vtkIdType);

  /**
   * Tetrahedra that FillHull added.
   */
  vtkGetMacro(NumberOfImaginaryCells, vtkIdType);

  /**
   * Whether Remesh gave what CellByCell gives.
   */
  vtkGetMacro(FellBack, bool);

protected:
  vtkTetGenTetrahedralizer() = default;
  ~vtkTetGenTetrahedralizer() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkTetGenTetrahedralizer(const vtkTetGenTetrahedralizer&) = delete;
  void operator=(const vtkTetGenTetrahedralizer&) = delete;

  void SplitCells(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output);
  void Remesh(vtkUnstructuredGrid* input, vtkUnstructuredGrid* split, vtkUnstructuredGrid* output);
  void Triangulate(
    vtkUnstructuredGrid* input, vtkUnstructuredGrid* split, vtkUnstructuredGrid* output);
  void FillHull(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output);
  void ReportFailure(const TetGenMesh& mesh, const char* instead);

  int Mode = CELL_BY_CELL;
  double MaximumRadiusEdgeRatio = 2.0;
  double MaximumVolume = 0.0;

  vtkIdType NumberOfCutCells = 0;
  vtkIdType NumberOfFailedCells = 0;
  vtkIdType NumberOfSkippedCells = 0;
  vtkIdType NumberOfNewPoints = 0;
  vtkIdType NumberOfImaginaryCells = 0;
  bool FellBack = false;
};

#endif
