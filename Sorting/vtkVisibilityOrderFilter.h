/**
 * @class   vtkVisibilityOrderFilter
 * @brief   rank of every cell from back to front, as a cell array
 *
 * Input: a vtkUnstructuredGrid of any convex cells. Output: the same grid (a shallow copy, cells in
 * the input's order) with the cell array `VisibilityOrder` (vtkIdTypeArray): the rank of the cell
 * for the eye of the camera, 0 is farthest; ranks are a permutation of the cell ids. In Python:
 *
 *     order = vtkVisibilityOrderFilter(input_connection=..., camera=renderer.GetActiveCamera())
 *     order.Update()
 *
 * (before VTK 9.4 by SetInputConnection and SetCamera). Cells that have no place in the order,
 * those of dimension 0 to 2 and those that the input's `Imaginary` array marks, take the last
 * ranks, among themselves in the order of the input. An array of the same name is replaced.
 *
 * Sort methods:
 * - Automatic (default): Power where it is proven exact for every eye (a convex Delaunay mesh,
 *   which only Convexify finds out), else MPVO.
 * - MPVO: vtkMPVOVisibilitySort, convexified unless Convexify is off.
 * - MPVOC: the same order, and the cell array `CyclicGroup` (vtkIdTypeArray) beside it, the number
 *   of the group of cells that hide each other in a circle, -1 elsewhere. The cells of a group have
 *   consecutive ranks under both.
 * - Power: vtkPowerVisibilitySort.
 * - CellCenter: vtkCellCenterDepthSort, as VTK itself sorts; nothing is proven.
 *
 * What is built from the mesh is kept between updates until points or cells change; a new eye costs
 * a sort alone. GetMTime follows the camera. Empty input gives an empty array; an aborted update
 * gives ranks of -1.
 *
 * Errors: no input connection (as any filter); a direction of length 0 without a camera.
 */

#ifndef vtkVisibilityOrderFilter_h
#define vtkVisibilityOrderFilter_h

#include "vtkCellProjectionModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkCamera;
class vtkIdTypeArray;

class VTKCELLPROJECTION_EXPORT vtkVisibilityOrderFilter : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkVisibilityOrderFilter* New();
  vtkTypeMacro(vtkVisibilityOrderFilter, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SortMethods
  {
    AUTOMATIC,
    MPVO,
    MPVOC,
    POWER,
    CELL_CENTER
  };

  ///@{
  /**
   * How the cells are sorted. Default: Automatic.
   */
  vtkSetClampMacro(SortMethod, int, AUTOMATIC, CELL_CENTER);
  vtkGetMacro(SortMethod, int);
  void SetSortMethodToAutomatic() { this->SetSortMethod(AUTOMATIC); }
  void SetSortMethodToMPVO() { this->SetSortMethod(MPVO); }
  void SetSortMethodToMPVOC() { this->SetSortMethod(MPVOC); }
  void SetSortMethodToPower() { this->SetSortMethod(POWER); }
  void SetSortMethodToCellCenter() { this->SetSortMethod(CELL_CENTER); }
  ///@}

  ///@{
  /**
   * Whose eye the order is for. Default: none, Direction is used.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}

  ///@{
  /**
   * The direction of projection, away from a viewer at infinity; used where no camera is set.
   * Default: (0, 0, -1).
   */
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  ///@}

  ///@{
  /**
   * Fill concavities, holes and gaps with imaginary cells while sorting, so that the order is right
   * across them; the output has none. Default: on.
   */
  vtkSetMacro(Convexify, bool);
  vtkGetMacro(Convexify, bool);
  vtkBooleanMacro(Convexify, bool);
  ///@}

  vtkMTimeType GetMTime() override;

  // === The order of the last update ===

  /**
   * "MPVO", "MPVOC", "Power" or "CellCenter"; empty where nothing was sorted.
   */
  std::string GetSortMethodUsed();

  /**
   * Groups of cells that hide each other in a circle; -1 where the method does not know.
   */
  vtkIdType GetNumberOfCycles();

  /**
   * Shared faces whose two cells come out in the wrong order; -1 where the method does not know.
   * Computed when asked for.
   */
  vtkIdType GetNumberOfMisorderedFaces();

  /**
   * Whether the order is right for every ray. Computed when asked for.
   */
  bool IsOrderProven();

protected:
  vtkVisibilityOrderFilter();
  ~vtkVisibilityOrderFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkVisibilityOrderFilter(const vtkVisibilityOrderFilter&) = delete;
  void operator=(const vtkVisibilityOrderFilter&) = delete;

  int SortMethod = AUTOMATIC;
  double Direction[3] = { 0.0, 0.0, -1.0 };
  bool Convexify = true;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
