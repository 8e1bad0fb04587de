/**
 * @class   vtkTetrahedraSimplifier
 * @brief   fewer tetrahedra within a stated error of the field and of the boundary
 *
 * Paper: Cignoni, Montani, Sarti, Scopigno, Fast Projective Volume Rendering: Approximating the
 * Rendering Process or Simplifying the Data?, 1995, section 4: levels of a mesh by the error of
 * its field. There they are made by inserting points, here by edge collapses: see
 * TetrahedraSimplification. (vtkUnstructuredGridQuadricDecimation bounds no error: with as many
 * tetrahedra as the paper keeps of Bucky ball for 2, 5 and 10 % it is off by 5.4, 13.6 and 28.7 %,
 * and loses 6, 11 and 17 % of the volume.)
 *
 * - Field error: the largest difference between the output's scalar and the input's, over all
 *   points of the input and the middles of its tetrahedra, as a share of the scalar's range. At a
 *   place outside of the output it is that of the output's nearest place.
 * - Boundary error: the largest distance of the input's boundary points, and of the middles of its
 *   boundary triangles, from the output's boundary, as a share of the diagonal of the bounds. With
 *   0 only what lies in one plane, or on one straight edge, is made simpler.
 *
 * Neither is more than its bound, whatever the mesh: both are measured at the end, and if the first
 * is more for what has come to lie outside, the work is done again with less of the second. The
 * output is one complex with the input's topology:
 * positive tetrahedra, no crack, boundary triangles turned by no more than 60 degrees at a time.
 *
 * Input: any cells that vtkConvexCells takes, which makes tetrahedra of them, and point scalars of
 * one component (SetInputArrayToProcess; the active ones by default). Output: tetrahedra; points of
 * the input, unmoved and in order, with their data. The scalars are shifted within the bound where
 * that lets more tetrahedra go (ShiftScalars); they become floats, or doubles where they were. Cell
 * data and `SourceCell` are those of the tetrahedron that each is left of.
 *
 * Errors: no such scalars, or some that are not finite; the output is then the tetrahedra as they
 * are. An aborted update gives nothing. One thread.
 *
 * Not guaranteed: the fewest tetrahedra possible; that a boundary which comes closer to itself than
 * its bound does not run through itself; anything for cells that overlap.
 */

#ifndef vtkTetrahedraSimplifier_h
#define vtkTetrahedraSimplifier_h

#include "vtkCellProjectionModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

class vtkDataArray;
struct SimplificationSettings;

class VTKCELLPROJECTION_EXPORT vtkTetrahedraSimplifier : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkTetrahedraSimplifier* New();
  vtkTypeMacro(vtkTetrahedraSimplifier, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The bound of the field error, a share of the scalar's range. Default: 0.02.
   */
  vtkSetClampMacro(MaximumFieldError, double, 0.0, 1.0);
  vtkGetMacro(MaximumFieldError, double);
  ///@}

  ///@{
  /**
   * The bound of the boundary error, a share of the diagonal. Default: 0.001.
   */
  vtkSetClampMacro(MaximumBoundaryError, double, 0.0, 1.0);
  vtkGetMacro(MaximumBoundaryError, double);
  ///@}

  ///@{
  /**
   * Let scalars of the points that stay differ from the input's, within MaximumFieldError. Default:
   * on.
   */
  vtkSetMacro(ShiftScalars, bool);
  vtkGetMacro(ShiftScalars, bool);
  vtkBooleanMacro(ShiftScalars, bool);
  ///@}

  // === What the last update did ===

  /**
   * Tetrahedra of the input's cells.
   */
  vtkGetMacro(NumberOfInputTetrahedra, vtkIdType);

  ///@{
  /**
   * What the errors are, as shares.
   */
  vtkGetMacro(FieldError, double);
  vtkGetMacro(BoundaryError, double);
  ///@}

  /**
   * How often the work was done again, for the field error.
   */
  vtkGetMacro(NumberOfRepetitions, int);

  /**
   * Wall-clock seconds of the last update.
   */
  vtkGetMacro(Seconds, double);

protected:
  vtkTetrahedraSimplifier();
  ~vtkTetrahedraSimplifier() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkTetrahedraSimplifier(const vtkTetrahedraSimplifier&) = delete;
  void operator=(const vtkTetrahedraSimplifier&) = delete;

  vtkDataArray* FindScalars(vtkInformationVector** inputVector, vtkUnstructuredGrid* tetrahedra);
  void Simplify(
    vtkUnstructuredGrid* tetrahedra, vtkDataArray* scalars, vtkUnstructuredGrid* output);
  bool SimplifyOnce(vtkUnstructuredGrid* tetrahedra, vtkDataArray* scalars,
    const SimplificationSettings& settings, vtkUnstructuredGrid* output);

  double MaximumFieldError = 0.02;
  double MaximumBoundaryError = 0.001;
  bool ShiftScalars = true;

  vtkIdType NumberOfInputTetrahedra = 0;
  double FieldError = 0.0;
  double BoundaryError = 0.0;
  int NumberOfRepetitions = 0;
  double Seconds = 0.0;
};

#endif
