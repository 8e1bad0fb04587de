/**
 * @class   vtkProvenVisibilitySort
 * @brief   what our visibility sorts share: the eye, the batches, and the proof of the order
 *
 * Input: any vtkDataSet of convex cells, given by SetInput. GetNextCells() returns every cell's id
 * once, in batches of MaxCellsReturned, farthest first (or nearest first, by Direction); only cells
 * whose `Imaginary` array says 1 are never returned. Cells of dimension 0 to 2, and cells that are
 * not linear, come in no particular place. A batch is a window on the order: it is not to be
 * written to. What is built from the cells is kept until they change, the order until the eye or
 * the model transform does.
 *
 * The eye is the camera's centre of projection, sheared and stereo views included; in parallel
 * projection it is a direction.
 *
 * Proof: `GetNumberOfMisorderedFaces()` counts the shared faces whose two cells come out in the
 * wrong order, faces seen edge-on apart; `GetNumberOfCycles()` the groups of cells that no order
 * can satisfy; `IsOrderProven()` says whether every cell is in its place: a convex (or convexified)
 * complex, no cycle, no misordered contact. Each is computed when it is asked for, and only then.
 *
 * Errors, each once: no input, no camera, a camera or transform without an eye. Warning, once per
 * mesh: cells that are no complex, with their counts.
 *
 * Not guaranteed: an order that is not proven is still a permutation, and nothing more.
 */

#ifndef vtkProvenVisibilitySort_h
#define vtkProvenVisibilitySort_h

#include "vtkCellProjectionModule.h" // for export macro
#include "vtkTimeStamp.h"
#include "vtkVisibilitySort.h"

#include <memory> // for std::unique_ptr
#include <string> // for messages
#include <vector> // for std::vector

class vtkCellArray;
struct CellComplex;
struct ImaginaryCells;

class VTKCELLPROJECTION_EXPORT vtkProvenVisibilitySort : public vtkVisibilitySort
{
public:
  vtkTypeMacro(vtkProvenVisibilitySort, vtkVisibilitySort);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void InitTraversal() override;
  vtkIdTypeArray* GetNextCells() override;

  ///@{
  /**
   * Fill concavities, holes and gaps with imaginary cells, where the order needs it and the input
   * does not carry such cells already. Default: on.
   */
  void SetConvexify(bool convexify);
  vtkGetMacro(Convexify, bool);
  vtkBooleanMacro(Convexify, bool);
  ///@}

  /**
   * Take over what `other` has built for the same input, and need not build it again. Nothing
   * where the inputs differ or nothing is built; `other` builds anew when it is asked next.
   */
  void TakeComplex(vtkProvenVisibilitySort* other);

  // === The order of the last traversal ===

  /**
   * Groups of cells that hide each other in a circle.
   */
  vtkIdType GetNumberOfCycles();

  /**
   * The cells of these groups, one group a cell of the array; contiguous in the order.
   */
  vtkCellArray* GetCyclicGroups();

  /**
   * Shared faces whose two cells come out in the wrong order for this eye.
   */
  vtkIdType GetNumberOfMisorderedFaces();

  /**
   * Whether the order is right for every ray.
   */
  bool IsOrderProven();

protected:
  vtkProvenVisibilitySort();
  ~vtkProvenVisibilitySort() override;

  /**
   * All cells of the input from back to front for `eye` (a point, or with eye[3] = 0 a direction
   * towards the eye; in the input's coordinates), cells that are never returned included or not.
   * What it returns stays as it is until the next call.
   */
  virtual const std::vector<vtkIdType>& SortCells(const double eye[4]) = 0;

  /**
   * Groups of the last SortCells as lists of ids one after the other, and where each begins (and
   * the end). Default: none.
   */
  virtual void FindCyclicGroups(std::vector<vtkIdType>& cells, std::vector<vtkIdType>& offsets);

  /**
   * The input's cells as a complex, built when first asked for and when the cells have changed.
   * Cell ids are the input's.
   */
  const CellComplex& GetComplex();

  /**
   * What fills the complex to a convex one; empty where Convexify is off.
   */
  const ImaginaryCells& GetImaginaryCells();

  /**
   * Whether complex and imaginary cells together are convex and free of overlaps.
   */
  bool IsComplexConvex();

  /**
   * Whether cells that a gap separates are in order too. Default: where there is no gap.
   */
  virtual bool IsOrderRightAcrossGaps();

  /**
   * When complex or imaginary cells were built last.
   */
  vtkTimeStamp ComplexTime;

  /**
   * When a setting changed that the order depends on.
   */
  vtkTimeStamp SettingsTime;

private:
  vtkProvenVisibilitySort(const vtkProvenVisibilitySort&) = delete;
  void operator=(const vtkProvenVisibilitySort&) = delete;

  vtkMTimeType GetSettingsTime();
  void ForgetComplex();
  void ReportComplex();
  void FailOnce(const std::string& text);

  bool Convexify = true;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
